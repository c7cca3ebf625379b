#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace rubicon::test {

/// A loop as the records alone tell it.
struct DirectLoop {
  std::string kind;
  std::string file;
  int line = 0;
  int tried = 0;
  int made = 0;
};

/// Where a task stands, as its records alone tell it.
struct DirectState {
  double t = 0;
  int n = 0;
  std::string carries;
  std::vector<DirectLoop> loops;
  std::map<std::string, double> variables;
  std::map<std::string, double> q;  ///< empty before the first record that tells it
};

/// The records of one run of one task.
struct DirectRun {
  std::string task;
  std::vector<nlohmann::json> records;
};

/// The runs of a trace, in the order in which they begin.
std::vector<DirectRun> direct_runs(const std::vector<std::string>& lines);

/// The state after one more record.
void direct_apply(const nlohmann::json& record, DirectState& state);

}  // namespace rubicon::test
