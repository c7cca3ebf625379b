#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "interpreter/check/check.hpp"
#include "src/motion/guides/guide_spec.hpp"

namespace rubicon::interpreter {

/// Kind and clauses of a declared guide, but for weights and keep: G01-G03. Nothing after an error.
std::optional<guides::GuideSpec> check_guide(const syntax::GuideDeclaration& guide,
                                             Diagnostics& diagnostics);

/// Adds weights and what is kept, whose parameters are those of a robot: G03. False after an error.
bool resolve_parameters(const syntax::GuideDeclaration& guide, const robot::RobotModel& robot,
                        guides::GuideSpec& spec, Diagnostics& diagnostics);

/// Whether guides can plan for the robot: it makes legs, and what they move has a range. G04 at
/// `span`.
bool check_guided_robot(const robot::RobotModel& robot, Span span, Diagnostics& diagnostics);

/// The guides that are declared in one file; G05 where a name is declared twice.
class GuideDeclarations {
 public:
  void declare(const syntax::GuideDeclaration& guide, Diagnostics& diagnostics);
  const syntax::GuideDeclaration* find(const std::string& name) const;
  std::vector<std::string> names() const;

 private:
  std::map<std::string, const syntax::GuideDeclaration*> by_name_;
};

}  // namespace rubicon::interpreter
