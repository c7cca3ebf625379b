#pragma once

#include <optional>
#include <string>
#include <vector>

#include "src/exchange/project_io/project.hpp"

namespace rubicon::test {

/// What reading a schedule gave: the project, and the codes and texts of what was said.
struct Reading {
  std::optional<project_io::Project> project;
  std::vector<std::string> said;  ///< "I07 1:52 FixedCost of Task is not taken over, here '12'"
  bool has_errors = false;

  /// Whether something was said with this code and these words in it.
  bool says(const std::string& code, const std::string& words) const;
};

/// Reads a schedule as the command does.
Reading read_schedule(const std::string& bytes);

/// The plan of a project, what was said while it was written, and what checking it says (empty: it
/// is well).
struct Planned {
  std::string text;
  std::vector<std::string> said;
  std::string mistakes;
};
Planned plan_of(const project_io::Project& project);

/// The project that a plan text stands for; fails the test if the plan has mistakes.
Reading project_of_plan(const std::string& text);

/// A schedule in Microsoft Project XML with this inside.
std::string mspdi(const std::string& inside);
/// A task with number and name and these elements; level 1 unless they say another.
std::string mspdi_task(int uid, const std::string& name, const std::string& elements);

}  // namespace rubicon::test
