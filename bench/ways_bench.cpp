// How long first ways take, beside RRTConnect of OMPL over FCL in the same run, and whether they
// are free by FCL at dense poses: an excavator from trench to truck, and an arm of seven joints in
// seven kinds of scenes. Then what the test of an edge costs, and how that grows with what is far
// away; and whether looks along legs say what the test of them says. Processor time on one core.
//
//   ways_bench [excavator|cases|arm|edges|legs]... [--problems N] [--ours]     in the project's
//   folder
//
// --ours leaves OMPL out: for profiles.

#include <fmt/format.h>
#include <time.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/chain.hpp"
#include "bench/chain_scenes.hpp"
#include "interpreter/check/plan_model.hpp"
#include "interpreter/machine/machine.hpp"
#include "interpreter/machine/world_tests.hpp"
#include "src/motion/guides/guide.hpp"
#include "src/motion/robot/kinematics.hpp"
#include "src/simulation/site/make_site.hpp"
#include "src/simulation/site/robot_view.hpp"
#include "tests/support/memory_files.hpp"

namespace {

using namespace rubicon;
using bench::Chain;
using bench::ChainProblem;
using interpreter::WorldTests;
using Way = std::vector<std::vector<double>>;

/// m: what the engine lets bodies touch by, so that the machine is taken smaller by that.
constexpr double kContact = 1e-3;

/// Seconds of processor time of this thread: others may work beside it.
double now() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
}

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5)];
}

class DiskFiles : public test::MemoryFiles {
 public:
  std::variant<std::string, interpreter::FileFailure> read_text(const std::string& path) override {
    std::ifstream file(path, std::ios::binary);
    if (!file) return test::MemoryFiles::read_text(path);
    return std::string(std::istreambuf_iterator<char>(file), {});
  }
};

/// A plan with one robot and one goal, ready to plan for.
class OurSite {
 public:
  explicit OurSite(const std::string& path) { load(path); }
  OurSite(const Chain& chain, const ChainProblem& problem) {
    files_.texts()["problem.plan"] = bench::plan_text(chain, problem);
    files_.texts()[chain.name + ".robot"] = chain.robot_text();
    load("problem.plan");
  }

  const robot::RobotModel& model() const { return plan_->robots[0].robot->model; }
  const interpreter::World& world() const { return *view_; }
  const std::vector<double>& start() const { return plan_->robots[0].start; }

  guides::PlanReport plan(const guides::GuideSpec& spec) const {
    guides::GuideTask task;
    task.model = &model();
    task.mounting = mounting_;
    std::vector<double> goal = start();
    for (const auto& [index, value] : plan_->goal->values) {
      goal[static_cast<std::size_t>(index)] = value;
    }
    robot::update_derived(model(), mounting_, goal);
    task.goals = {goal};
    WorldTests tests(model(), *view_);
    return guides::plan_way(spec, task, start(), tests);
  }

 private:
  void load(const std::string& path) {
    interpreter::Diagnostics diagnostics;
    plan_ = load_plan(path, sources_, files_, diagnostics);
    if (!plan_) {
      for (const auto& each : diagnostics.sorted()) fmt::print(stderr, "{}\n", each.message);
      throw std::runtime_error("run this benchmark in the project's folder");
    }
    world_.emplace(site::make_site(*plan_));
    view_.emplace(*world_, 0);
    mounting_.starts = start();
  }

  DiskFiles files_;
  interpreter::SourceMap sources_;
  std::unique_ptr<interpreter::PlanModel> plan_;
  robot::Mounting mounting_;
  std::optional<site::SiteWorld> world_;
  std::optional<site::RobotView> view_;
};

guides::GuideSpec connect(double seed, double improve = 0) {
  guides::GuideSpec spec = guides::default_guide(guides::GuideKind::rrt_connect);
  spec.seed = seed;
  spec.improve = improve;
  return spec;
}

/// Planners on many problems: seconds of those that were solved, and how many of the ways meet
/// something.
struct Tally {
  std::vector<double> seconds;
  int tried = 0;
  int met = 0;
  void add(bool solved, double took, bool meets) {
    ++tried;
    if (!solved) return;
    seconds.push_back(took);
    met += meets;
  }
  std::string row(const std::string& name) const {
    return fmt::format(
        "  {:<28} {:>4}/{:<4} median {:>9.3f} ms   p95 {:>9.3f} ms   in contact {}\n", name,
        seconds.size(), tried, quantile(seconds, 0.5) * 1e3, quantile(seconds, 0.95) * 1e3, met);
  }
};

/// Our first way, the best of three times; its way is judged by FCL.
void add_ours(Tally& tally, const Chain& chain, const ChainProblem& problem, double seed,
              double dense) {
  const OurSite site(chain, problem);
  double least = 1e9;
  guides::PlanReport report;
  for (int i = 0; i < 3; ++i) {
    const double begin = now();
    report = site.plan(connect(seed));
    least = std::min(least, now() - begin);
  }
  const bench::FclChain oracle(chain, problem.obstacles, kContact);
  tally.add(report.found(), least, report.found() && bench::meets(oracle, report.way, dense));
}

void add_ompl(Tally& tally, const Chain& chain, const ChainProblem& problem, double resolution,
              unsigned seed, double dense) {
  const bench::FclChain world(chain, problem.obstacles);
  const auto way = bench::rrt_connect_of_ompl(chain, world, problem, resolution, seed, 5);
  tally.add(!way.points.empty(), way.seconds,
            !way.points.empty() && bench::meets(world, way.points, dense));
}

void excavator(int problems, int of_ompl) {
  const Chain chain = bench::digging_excavator();
  constexpr double kDense = 0.0286;  // degrees: 0.0005 rad
  for (const bool moved : {false, true}) {
    fmt::print("excavator, dig to dump, {}\n",
               moved ? "boxes shifted and turned" : "scene I, 18 boxes");
    Tally ours;
    std::vector<std::pair<double, Tally>> ompl = {
        {0.01, {}}, {0.002, {}}, {0.0005, {}}, {0.0001, {}}};
    int made = 0;
    for (std::uint32_t seed = 1; made < problems; ++seed) {
      bench::Random random(seed);
      const auto problem =
          bench::dig_and_dump(chain, bench::trench_and_truck(moved ? &random : nullptr), random);
      if (!problem) continue;
      ++made;
      add_ours(ours, chain, *problem, seed, kDense);
      if (made > of_ompl) continue;
      for (auto& [resolution, tally] : ompl) {
        add_ompl(tally, chain, *problem, resolution, seed, kDense);
      }
    }
    fmt::print("{}", ours.row("ours, rrt_connect"));
    for (const auto& [resolution, tally] : ompl) {
      fmt::print("{}", tally.row(fmt::format("OMPL RRTConnect, FCL, {}", resolution)));
    }
    for (const auto& [resolution, tally] : ompl) {
      fmt::print("  ratio of medians at {}: {:.2f}\n", resolution,
                 quantile(tally.seconds, 0.5) / quantile(ours.seconds, 0.5));
    }
  }
}

void cases() {
  for (const std::string name : {"trench_to_truck", "truck_to_trench"}) {
    const OurSite site("robots/excavator/cases/" + name + "/site.plan");
    fmt::print("{}, 50 seeds\n", name);
    for (const double improve : {0.0, 10.0, 25.0, 50.0, 100.0, 200.0}) {
      std::vector<double> seconds;
      std::vector<double> times;
      for (int seed = 1; seed <= 50; ++seed) {
        const double begin = now();
        const guides::PlanReport report = site.plan(connect(seed, improve));
        const double took = now() - begin;
        if (!report.found()) continue;
        seconds.push_back(took);
        times.push_back(report.metrics.motion_time);
      }
      fmt::print(
          "  improve {:>3}: {:>2}/50 median {:.3f} ms  p95 {:.3f} ms  motion time {:.2f} s\n",
          improve, seconds.size(), quantile(seconds, 0.5) * 1e3, quantile(seconds, 0.95) * 1e3,
          quantile(times, 0.5));
    }
  }
}

void arm(int problems, int of_ompl) {
  const Chain chain = bench::seven_axis_arm();
  constexpr double kDense = 0.1;
  Tally all_ours;
  Tally all_ompl;
  for (const std::string& scene : bench::arm_scenes()) {
    Tally ours;
    Tally ompl;
    int made = 0;
    for (std::uint32_t seed = 1; made < problems && seed < 100'000; ++seed) {
      bench::Random random(seed);
      const auto problem = bench::arm_problem(scene, chain, random);
      if (!problem) continue;
      ++made;
      for (Tally* tally : {&ours, &all_ours}) add_ours(*tally, chain, *problem, seed, kDense);
      if (made > of_ompl) continue;
      for (Tally* tally : {&ompl, &all_ompl}) add_ompl(*tally, chain, *problem, 0.01, seed, kDense);
    }
    fmt::print("{}\n{}{}  ratio of medians {:.2f}\n", scene, ours.row("ours, rrt_connect"),
               ompl.row("OMPL RRTConnect, FCL, 0.01"),
               quantile(ompl.seconds, 0.5) / quantile(ours.seconds, 0.5));
    std::fflush(stdout);
  }
  fmt::print("all\n{}{}  ratio of medians {:.2f}\n", all_ours.row("ours, rrt_connect"),
             all_ompl.row("OMPL RRTConnect, FCL, 0.01"),
             quantile(all_ompl.seconds, 0.5) / quantile(all_ours.seconds, 0.5));
}

void edges() {
  const Chain chain = bench::seven_axis_arm();
  double with_fewest = 0;
  for (const int far : {0, 900, 9'900, 99'900}) {
    bench::Random random(7);
    ChainProblem problem;
    problem.obstacles = bench::scattered(100, far, random);
    problem.start = {0, 0, 0, -90, 0, 90, 0};
    problem.goal = problem.start;
    const OurSite site(chain, problem);
    constexpr double kEach = 11.459;  // degrees: 0.2 rad
    bench::Random draws(11);
    std::vector<double> free;
    std::vector<double> refused;
    std::vector<double> looked;  // along those that are free
    while (free.size() < 400) {
      std::vector<double> from;
      std::vector<double> to;
      for (const robot::Parameter& p : site.model().parameters) {
        from.push_back(draws.between(p.lower + kEach, p.upper - kEach));
        to.push_back(from.back() + (draws.below(2) == 0 ? kEach : -kEach));
      }
      if (site.world().blocked_at(from)) continue;
      const interpreter::MotionStep step{from, to, 0, 0};
      constexpr int kTimes = 20;
      bool is_free = false;
      const double begin = now();
      for (int i = 0; i < kTimes; ++i) is_free = !site.world().refusal(step).has_value();
      (is_free ? free : refused).push_back((now() - begin) / kTimes);
      if (!is_free) continue;
      const double look = now();
      for (int i = 0; i < kTimes; ++i) {
        is_free = site.world().look_along(from, to, true, 1).free_until >= 1;
      }
      if (is_free) looked.push_back((now() - look) / kTimes);
    }
    const double median = quantile(free, 0.5);
    if (far == 0) with_fewest = median;
    fmt::print(
        "edge, 7 joints by 0.2 rad, 100 boxes near and {:>6} far: free {:.2f} us (p95 {:.2f}), "
        "refused {:.2f} us, growth {:.2f}; looked along {} of {}: {:.2f} us (p95 {:.2f})\n",
        far, median * 1e6, quantile(free, 0.95) * 1e6, quantile(refused, 0.5) * 1e6,
        median / with_fewest, looked.size(), free.size(), quantile(looked, 0.5) * 1e6,
        quantile(looked, 0.95) * 1e6);
  }
}

/// Looks along random legs against the test of the same legs, and of the parts called free or met.
void compare_looks(const OurSite& site, const std::string& name, int count, std::uint32_t seed) {
  const robot::RobotModel& model = site.model();
  robot::Mounting mounting;
  mounting.starts = site.start();
  bench::Random draws(seed);
  const auto is_free = [&](const std::vector<double>& from, const std::vector<double>& to,
                           double share) {
    const auto end = robot::configuration_at(from, to, share);
    return !site.world().refusal({from, end, 0, 0}).has_value();
  };
  int free = 0;
  int met = 0;
  int open = 0;
  int differ = 0;
  for (int n = 0; n < count; ++n) {
    std::vector<double> from;
    std::vector<double> to;
    const double most = n % 3 == 0 ? 1 : n % 3 == 1 ? 0.2 : 0.03;  // of the ranges
    for (const robot::Parameter& p : model.parameters) {
      const double lower = p.cyclic ? -180 : p.lower;
      const double upper = p.cyclic ? 180 : p.upper;
      const double way = most * (upper - lower);
      from.push_back(p.derived ? 0 : draws.between(lower, upper));
      to.push_back(p.derived ? 0
                             : std::clamp(from.back() + draws.between(-way, way), lower, upper));
    }
    robot::update_derived(model, mounting, from);
    robot::update_derived(model, mounting, to);
    if (site.world().blocked_at(from)) continue;
    for (const bool whole : {true, false}) {
      const interpreter::LegLook look = site.world().look_along(from, to, whole, 0.01);
      if (look.free_until > 0) ++free;
      if (look.met_from <= 1) ++met;
      if (look.met_from > 1 && look.free_until < (whole ? 1 : 1e-300)) ++open;
      if (look.free_until > 0 && !is_free(from, to, look.free_until)) ++differ;
      if (look.met_from <= 1 && is_free(from, to, look.met_from)) ++differ;
    }
  }
  fmt::print(
      "{:<16} looks that tell of a free part {:>6}, of contact {:>6}, open {:>4}; differ {}\n",
      name, free, met, open, differ);
}

void legs() {
  constexpr int kLegs = 20'000;
  for (const std::string name : {"trench_to_truck", "truck_to_trench"}) {
    const OurSite site("robots/excavator/cases/" + name + "/site.plan");
    compare_looks(site, name, kLegs, 5);
  }
  const Chain arm = bench::seven_axis_arm();
  for (const std::string& scene : bench::arm_scenes()) {
    for (std::uint32_t seed = 1; seed <= 2; ++seed) {
      bench::Random random(seed);
      const auto problem = bench::arm_problem(scene, arm, random);
      if (problem) compare_looks(OurSite(arm, *problem), scene, kLegs / 4, seed);
    }
  }
}

}  // namespace

int main(int count, char** words) {
  std::vector<std::string> asked;
  int problems = 20;
  int of_ompl = 500;
  for (int i = 1; i < count; ++i) {
    if (std::string(words[i]) == "--problems" && i + 1 < count) {
      problems = std::max(1, std::atoi(words[++i]));
    } else if (std::string(words[i]) == "--ours") {
      of_ompl = 0;
    } else {
      asked.emplace_back(words[i]);
    }
  }
  const auto wanted = [&](const char* name) {
    return asked.empty() || std::find(asked.begin(), asked.end(), name) != asked.end();
  };
  if (wanted("edges")) edges();
  if (wanted("legs")) legs();
  if (wanted("cases")) cases();
  if (wanted("excavator")) excavator(problems, of_ompl);
  if (wanted("arm")) arm(problems, of_ompl);
}
