// Discs on roadmaps in continuous time: how many are planned at once, how fast, how far from the
// least sum of arrivals, and what becomes of it when moves end late.
//   roadmap_bench [EXECUTIONS [EXACT_NODES]]

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <vector>

#include "bench/exact_discs.hpp"
#include "tests/unit/traffic/roadmaps.hpp"

namespace {

using namespace rubicon;

constexpr double kDiameter = 2.4;  // m
constexpr int kSeeds = 5;

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

struct Yard {
  const char* name;
  traffic::RoadmapQuery query;
  std::int64_t expansions = 0;  ///< for each plan
  double piece = 0;             ///< m: lanes are cut into pieces as long as that at least; 0: not
};

double ratio(lanes::Nanoseconds cost, double least) {
  return static_cast<double>(cost) * 1e-9 / least;
}

}  // namespace

int main(int argc, char** argv) {
  const int executions = argc > 1 ? std::atoi(argv[1]) : 300;
  const int exact_nodes = argc > 2 ? std::atoi(argv[2]) : 300;
  const Yard yards[] = {{"170 nodes, 349 edges", {170, 349, 200, 6, 1}, 1'500'000, 2.5},
                        {"878 nodes, 7341 edges", {878, 7341, 400, 6, 1}, 150'000, 0}};
  int contacts = 0;
  int standstills = 0;
  int driven = 0;
  for (const Yard& yard : yards) {
    const lanes::LaneNetwork whole = traffic::roadmap(yard.query);
    const lanes::LaneNetwork network = yard.piece > 0 ? traffic::divided(whole, yard.piece) : whole;
    const double begin = processor_seconds();
    const traffic::Nearness near = traffic::nearness_of(network, kDiameter);
    std::printf("%s; what is near to what: %.2f s\n", yard.name, processor_seconds() - begin);
    std::printf(
        "agents  solved  s each (most)  over the bound: first, at the end  over exact (ended)\n");
    for (const int count : {5, 10, 15, 20, 30, 50}) {
      int solved = 0;
      int ended = 0;
      double most = 0, sum = 0, first = 0, last = 0, over_exact = 0, worst = 0;
      for (int seed = 1; seed <= kSeeds; ++seed) {
        const auto trips = traffic::random_trips(whole, count, static_cast<std::uint64_t>(seed));
        const double start = processor_seconds();
        const traffic::OneShot found =
            traffic::plan_all(network, near, trips, {yard.expansions, 1});
        const double took = processor_seconds() - start;
        sum += took;
        most = std::max(most, took);
        if (!found.solved) continue;
        ++solved;
        first += ratio(found.first_cost, static_cast<double>(found.least) * 1e-9);
        last += ratio(found.cost, static_cast<double>(found.least) * 1e-9);
        if (count <= 20 && exact_nodes > 0) {
          if (const auto exact = bench::exact_discs(whole, kDiameter, trips, exact_nodes)) {
            ++ended;
            over_exact += ratio(found.cost, *exact);
            worst = std::max(worst, ratio(found.cost, *exact));
          }
        }
        const auto order = traffic::order_of(near, found.ways);
        const int times = count == 50 ? executions / (2 * kSeeds) : 0;
        for (int late = 0; late < times; ++late) {
          const auto ways = traffic::driven_late(network, trips, order, found.ways, 20,
                                                 static_cast<std::uint64_t>(late));
          ++driven;
          std::vector<std::vector<traffic::TimedPlace>> tracks;
          for (std::size_t i = 0; i < ways.size(); ++i) {
            if (ways[i].size() < found.ways[i].size()) ++standstills;
            tracks.push_back(traffic::track_of(network, ways[i]));
          }
          for (std::size_t i = 0; i < tracks.size(); ++i) {
            for (std::size_t k = 0; k < i; ++k) {
              if (traffic::least_distance(tracks[i], tracks[k]) < kDiameter - 1e-6) ++contacts;
            }
          }
        }
      }
      std::printf("%6d  %d/%d     %.3f (%.3f)  %.4f, %.4f", count, solved, kSeeds, sum / kSeeds,
                  most, first / std::max(solved, 1), last / std::max(solved, 1));
      if (ended > 0) std::printf("  %.4f, %.4f at most (%d)", over_exact / ended, worst, ended);
      std::printf("\n");
      std::fflush(stdout);
    }
  }
  std::printf("%d executions with moves up to 20 s late: %d contacts, %d standstills\n", driven,
              contacts, standstills);
  return contacts + standstills == 0 ? 0 : 1;
}
