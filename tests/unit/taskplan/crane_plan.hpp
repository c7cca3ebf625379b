#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "interpreter/check/plan_model.hpp"
#include "interpreter/syntax/syntax.hpp"
#include "src/simulation/trace/trace_sink.hpp"

namespace rubicon::test {

/// Scripts built by hand, element by element; every command stands on the line given.
syntax::ExpressionPtr number(double value);
syntax::ExpressionPtr goal_of(const std::string& parameter);
syntax::ExpressionPtr upwards();  ///< dir(z, max(z))
syntax::Statement move_to(const std::string& parameter, syntax::ExpressionPtr value, int line);
syntax::Statement move_dir(const std::string& parameter, syntax::ExpressionPtr value, int line);
syntax::Statement together(std::vector<syntax::Statement> parts, int line);
syntax::Statement chain(std::vector<syntax::Statement> elements, int line);
/// which { label: { then } default: { otherwise } }
syntax::Statement which(const std::string& label, syntax::Statement then,
                        syntax::Statement otherwise, int line);

template <typename... Statements>
std::vector<syntax::Statement> list(Statements&&... statements) {
  std::vector<syntax::Statement> all;
  (all.push_back(std::forward<Statements>(statements)), ...);
  return all;
}

/// A tower crane: mast, jib (theta, 5 degrees), hook (x, z by 1 m, theta of its own by 15 degrees);
/// each step takes one second but lifting, which takes two. Its tool is the hook's underside. The
/// hook's own angle is `hook.theta`, the jib's `jib.theta`.
std::shared_ptr<interpreter::CheckedRobot> crane(std::vector<syntax::Statement> script);

/// Lift to z 20, turn, travel and turn the hook to the goal, and lower to it; while transporting
/// stop 2 m above, unless placing.
std::vector<syntax::Statement> lifting_script();

/// A sources map whose file 0 is "crane.motion" of 40 lines, ten bytes each.
interpreter::SourceMap numbered_lines();

/// A plan with one crane at the origin, hook at x 10, z 20 over nothing.
interpreter::PlanModel crane_plan();
interpreter::ComponentSpec box_component(const std::string& name, const math::Vec3& size,
                                         const math::Pose& X_WO);
interpreter::TaskSpec move_task(const std::string& name, int component, const math::Pose& X_WO);

/// Keeps the lines of a trace.
class Lines : public trace::TraceSink {
 public:
  void line(std::string_view text) override { lines.emplace_back(text); }
  void restart() override { lines.clear(); }
  std::vector<std::string> lines;
};

}  // namespace rubicon::test
