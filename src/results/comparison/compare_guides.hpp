#pragma once

#include <functional>
#include <string>
#include <vector>

#include "interpreter/check/plan_model.hpp"
#include "interpreter/syntax/source.hpp"

namespace rubicon::comparison {

/// One try of one guide.
struct GuideTrial {
  double seed = 0;
  bool found = false;
  std::string cause;  ///< of no way
  double nodes = 0, checks = 0, refused = 0;
  double milliseconds = 0;
  double roughness = 0, length = 0, motion_time = 0;  ///< of a way that was found: 1, m, s
};

/// All tries of one guide on one motion.
struct GuideTrials {
  guides::GuideSpec spec;
  std::vector<GuideTrial> trials;
};

/// A motion of the task: to the grip, carrying, placing, or the one of `go`.
struct MotionComparison {
  std::string motion;
  std::vector<GuideTrials> guides;
};

struct GuideComparison {
  std::string plan;
  std::string task;
  std::vector<MotionComparison> motions;
};

/// Plans a way for the first goal of each motion of the task (of a short plan: its name), by every
/// kind of guide with the seeds from 1 on. A guide that the task names stands for its kind, with
/// its clauses; of OMPL its own, and those that are `added`. `clock` gives seconds. A motion that
/// never begins is not there.
GuideComparison compare_guides(const interpreter::PlanModel& plan,
                               const interpreter::SourceMap& sources, const std::string& task,
                               int seeds, const std::function<double()>& clock,
                               const std::vector<guides::GuideSpec>& added = {});

/// The names of the tasks that move, those that `compare_guides` takes.
std::vector<std::string> moving_tasks(const interpreter::PlanModel& plan);

std::string comparison_text(const GuideComparison& comparison);
std::string comparison_csv(const GuideComparison& comparison);
std::string comparison_json(const GuideComparison& comparison);

}  // namespace rubicon::comparison
