#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "src/exchange/project_io/project.hpp"

namespace rubicon::cli {

/// What levelling does to a schedule: tasks that start later than without it.
struct LevellingDelay {
  std::size_t tasks = 0;     ///< of the plan
  std::size_t delayed = 0;   ///< that start later
  std::int64_t longest = 0;  ///< s, of one of them
  std::string task;          ///< that one, as the plan calls it
};

/// Runs the plan of the schedule with its resources as limits and without. Nothing where one of the
/// two cannot be run.
std::optional<LevellingDelay> levelling_delay(const project_io::Project& project);

/// The same for people, as one line.
std::string delay_text(const LevellingDelay& delay);

}  // namespace rubicon::cli
