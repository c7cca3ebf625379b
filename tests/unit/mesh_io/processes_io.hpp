#pragma once

#include <sys/types.h>

#include <chrono>
#include <functional>
#include <string>
#include <vector>

namespace rubicon::mesh_io::testing {

/// Processes that this one, or `parent`, has started and that still run or wait to be reaped.
std::vector<pid_t> children_of(pid_t parent);

/// A line of /proc/PID/status without its name, "" when there is none.
std::string status_of(pid_t process, const std::string& name);

/// What the open files of a process are: number and target.
std::vector<std::string> open_files_of(pid_t process);

/// Asks again and again until it is true; false after `patience`.
bool comes_true(const std::function<bool()>& what,
                std::chrono::seconds patience = std::chrono::seconds(10));

}  // namespace rubicon::mesh_io::testing
