// The program `rubicon-search`: the optimiser of a study. It reads from standard input what is to
// be searched, then writes a generation of points, reads what each is worth, and so on until
// standard input ends.
//
//   search 1 SEED GENERATION OBJECTIVES RANGES LISTS     then, a line each: how many values a list
//   has;
//                                                        the point to begin with
//   -> a line a point: a share from 0 to 1 for each range, then an index for each list
//   <- a line a point: its objectives, less is better
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <limits>
#include <pagmo/algorithms/nsga2.hpp>
#include <pagmo/batch_evaluators/member_bfe.hpp>
#include <pagmo/bfe.hpp>
#include <pagmo/population.hpp>
#include <pagmo/problem.hpp>
#include <string>
#include <utility>
#include <vector>

namespace {

using Numbers = pagmo::vector_double;

/// What is asked and answered.
struct Channel {
  std::size_t width = 0;
  std::size_t objectives = 1;

  /// The study has ended, or what it says is not understood.
  [[noreturn]] static void end(int code) {
    std::fflush(stdout);
    std::_Exit(code);
  }

  double number() const {
    double value = 0;
    const int read = std::scanf("%lf", &value);  // NOLINT(cert-err34-c): what is no number ends it
    if (read == EOF) end(0);
    if (read != 1) end(2);
    return value;
  }

  std::size_t count() const {
    const double value = number();
    if (!(value >= 0 && value <= 1e6)) end(2);
    return static_cast<std::size_t>(value);
  }

  /// What the points, one after the other, are worth. A single objective is given twice: NSGA-II
  /// takes two or more, and ranks by two that are the same as by one.
  Numbers worths(const Numbers& points) const {
    for (std::size_t i = 0; i < points.size(); ++i) {
      std::printf("%a%c", points[i], (i + 1) % width == 0 ? '\n' : ' ');
    }
    std::fflush(stdout);
    Numbers result;
    for (std::size_t i = 0; i < points.size() / width; ++i) {
      for (std::size_t k = 0; k < objectives; ++k) result.push_back(number());
      if (objectives == 1) result.push_back(result.back());
    }
    return result;
  }
};

/// The problem as pagmo sees it.
struct Asked {
  const Channel* channel = nullptr;
  Numbers most;
  std::size_t lists = 0;

  Numbers fitness(const Numbers& point) const { return channel->worths(point); }
  Numbers batch_fitness(const Numbers& points) const { return channel->worths(points); }
  std::pair<Numbers, Numbers> get_bounds() const { return {Numbers(most.size(), 0.0), most}; }
  Numbers::size_type get_nobj() const {
    return channel == nullptr ? 2 : std::max<std::size_t>(channel->objectives, 2);
  }
  Numbers::size_type get_nix() const { return lists; }
};

void search() {
  Channel channel;
  if (std::scanf("search") != 0 || channel.count() != 1) Channel::end(2);
  const auto seed = static_cast<unsigned>(channel.number());
  const std::size_t generation = channel.count();
  channel.objectives = channel.count();
  const std::size_t ranges = channel.count();
  Asked asked;
  asked.channel = &channel;
  asked.lists = channel.count();
  asked.most.assign(ranges, 1.0);
  for (std::size_t i = 0; i < asked.lists; ++i) {
    asked.most.push_back(static_cast<double>(channel.count()) - 1);
  }
  channel.width = asked.most.size();
  if (channel.width == 0 || channel.objectives == 0) Channel::end(2);
  Numbers points;
  for (std::size_t i = 0; i < channel.width; ++i) points.push_back(channel.number());

  pagmo::population population(pagmo::problem(asked), 0, seed);
  while (points.size() < generation * channel.width) {
    const Numbers point = population.random_decision_vector();
    points.insert(points.end(), point.begin(), point.end());
  }
  const Numbers worths = channel.worths(points);
  const std::size_t objectives = asked.get_nobj();
  for (std::size_t i = 0; i < generation; ++i) {
    const auto point = points.begin() + static_cast<std::ptrdiff_t>(i * channel.width);
    const auto worth = worths.begin() + static_cast<std::ptrdiff_t>(i * objectives);
    population.push_back(Numbers(point, point + static_cast<std::ptrdiff_t>(channel.width)),
                         Numbers(worth, worth + static_cast<std::ptrdiff_t>(objectives)));
  }
  constexpr double kCrossover = 0.95;
  constexpr double kSpreadOfCrossover = 10;
  constexpr double kSpreadOfMutation = 20;
  // One coordinate in each point, on average (Deb and others, IEEE TEC 6(2), 2002).
  const double mutation = 1 / static_cast<double>(channel.width);
  pagmo::nsga2 optimiser(std::numeric_limits<unsigned>::max(), kCrossover, kSpreadOfCrossover,
                         mutation, kSpreadOfMutation, seed);
  optimiser.set_bfe(pagmo::bfe{pagmo::member_bfe{}});
  optimiser.evolve(population);
}

}  // namespace

int main() {
  try {
    search();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "rubicon-search: %s\n", error.what());
    return 2;
  }
  return 0;
}
