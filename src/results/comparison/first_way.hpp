#pragma once

#include <functional>
#include <string>

#include "interpreter/check/plan_model.hpp"
#include "interpreter/machine/machine.hpp"
#include "interpreter/syntax/source.hpp"

namespace rubicon::comparison {

/// The first way that a guide plans for a task, or why it finds none, and the site as it is then.
struct FirstWay {
  const interpreter::Program& program;
  const interpreter::MotionTask& motion;
  const interpreter::World& world;
  const guides::GuideSpec& spec;
  const guides::PlanReport& report;  ///< with what was grown
  const std::string& cause;          ///< of no way
};

/// Runs the plan up to the first motion of the task that a guide plans for: the first that the task
/// names, or of `kind` (""), as the task has it or by default. `use` is not called if there is no
/// such motion. Throws std::invalid_argument with a message for the user.
void with_first_way(const interpreter::PlanModel& plan, const interpreter::SourceMap& sources,
                    const std::string& task, const std::string& kind,
                    const std::function<void(const FirstWay& way)>& use);

}  // namespace rubicon::comparison
