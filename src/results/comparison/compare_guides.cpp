#include "src/results/comparison/compare_guides.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "src/motion/guides/vehicle.hpp"
#include "src/results/comparison/first_report.hpp"
#include "src/results/comparison/looked_at.hpp"
#include "src/simulation/site/make_site.hpp"
#include "src/simulation/site/robot_view.hpp"
#include "src/simulation/taskplan/run_plan.hpp"

namespace rubicon::comparison {

namespace {

GuideTrial trial_of(const FirstReport& first) {
  const guides::PlanReport& report = *first.report;
  GuideTrial trial;
  trial.found = report.found();
  trial.cause = first.cause;
  trial.nodes = static_cast<double>(report.nodes);
  trial.checks = static_cast<double>(report.checks);
  trial.refused = static_cast<double>(report.refused);
  trial.roughness = report.metrics.roughness;
  trial.length = report.metrics.length;
  trial.motion_time = report.metrics.motion_time;
  return trial;
}

/// The guide that the task names of each kind, else that kind as it is by default; those of travel
/// for machines that travel. Planners of OMPL are those that the task names.
std::vector<guides::GuideSpec> specs_for(const std::vector<guides::GuideSpec>& named,
                                         bool travels) {
  std::vector<guides::GuideSpec> specs;
  for (const guides::KindInfo& info : guides::guide_kinds()) {
    if (guides::is_travel(info.kind) && !travels) continue;
    if (info.kind == guides::GuideKind::ompl) {
      for (const guides::GuideSpec& spec : named) {
        if (spec.kind == info.kind) specs.push_back(spec);
      }
      continue;
    }
    const auto found = std::find_if(named.begin(), named.end(), [&](const guides::GuideSpec& spec) {
      return spec.kind == info.kind;
    });
    specs.push_back(found != named.end() ? *found : guides::default_guide(info.kind));
  }
  return specs;
}

class Comparer {
 public:
  Comparer(int seeds, const std::function<double()>& clock,
           const std::vector<guides::GuideSpec>& added)
      : seeds_(seeds), clock_(clock), added_(added) {}

  std::vector<GuideTrials> compare(const interpreter::Program& program,
                                   interpreter::MotionTask motion,
                                   const interpreter::World& world) {
    std::vector<GuideTrials> all;
    std::vector<guides::GuideSpec> named = std::move(motion.guides);
    for (const guides::GuideSpec& spec : added_) {
      const bool there = std::any_of(named.begin(), named.end(), [&](const auto& each) {
        return guides::full_name(each) == guides::full_name(spec);
      });
      if (!there) named.push_back(spec);
    }
    const guides::Vehicle vehicle(program.robot->model, motion.mounting);
    for (const guides::GuideSpec& spec : specs_for(named, vehicle.travels())) {
      GuideTrials trials{spec, {}};
      // These draw nothing: each try would be the same.
      const int seeds = guides::is_travel(spec.kind) ? 1 : seeds_;
      for (int seed = 1; seed <= seeds; ++seed) {
        guides::GuideSpec seeded = spec;
        seeded.seed = seed;
        motion.guides = {seeded};
        if (auto trial = plan(program, motion, world)) {
          trial->seed = seed;
          trials.trials.push_back(*std::move(trial));
        }
      }
      all.push_back(std::move(trials));
    }
    return all;
  }

 private:
  std::optional<GuideTrial> plan(const interpreter::Program& program,
                                 const interpreter::MotionTask& motion,
                                 const interpreter::World& world) {
    LookedAt looked_at(world);
    FirstReport first;
    interpreter::Machine machine(program, motion);
    const double begin = clock_();
    // To the first attempt, which is refused.
    machine.advance(looked_at, &first);
    const double end = clock_();
    if (!first.report) return std::nullopt;
    GuideTrial trial = trial_of(first);
    trial.milliseconds = (end - begin) * 1e3;
    return trial;
  }

  int seeds_;
  const std::function<double()>& clock_;
  const std::vector<guides::GuideSpec>& added_;
};

const char* motion_name(taskplan::MotionPurpose purpose) {
  switch (purpose) {
    case taskplan::MotionPurpose::grip:
      return "grip";
    case taskplan::MotionPurpose::carry:
      return "carry";
    case taskplan::MotionPurpose::place:
      return "place";
    case taskplan::MotionPurpose::dig:
      return "dig";
    case taskplan::MotionPurpose::haul:
      return "haul";
    case taskplan::MotionPurpose::go:
      break;
  }
  return "go";
}

}  // namespace

std::vector<std::string> moving_tasks(const interpreter::PlanModel& plan) {
  std::vector<std::string> names;
  if (plan.short_form) names.push_back(plan.name);
  for (const interpreter::TaskSpec& task : plan.tasks) {
    if (task.move || task.go) names.push_back(task.name);
  }
  return names;
}

GuideComparison compare_guides(const interpreter::PlanModel& plan,
                               const interpreter::SourceMap& sources, const std::string& task,
                               int seeds, const std::function<double()>& clock,
                               const std::vector<guides::GuideSpec>& added) {
  GuideComparison comparison{plan.name, task, {}};
  Comparer comparer(seeds, clock, added);
  // A plan that is begun again tells of its motions again: the last time counts.
  std::map<std::string, std::vector<GuideTrials>> motions;
  taskplan::RunOptions options;
  options.detail = trace::TraceDetail::none;
  options.on_motion = [&](const std::string& name, taskplan::MotionPurpose purpose,
                          const interpreter::Program& program,
                          const interpreter::MotionTask& motion, const interpreter::World& world) {
    if (name != task) return;
    motions[motion_name(purpose)] = comparer.compare(program, motion, world);
  };
  taskplan::run_plan(plan, sources, nullptr, options);
  for (const char* name : {"grip", "carry", "place", "go"}) {
    const auto found = motions.find(name);
    if (found != motions.end()) comparison.motions.push_back({name, std::move(found->second)});
  }
  return comparison;
}

}  // namespace rubicon::comparison
