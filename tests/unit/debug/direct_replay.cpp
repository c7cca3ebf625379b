#include "tests/unit/debug/direct_replay.hpp"

namespace rubicon::test {

using nlohmann::json;

std::vector<DirectRun> direct_runs(const std::vector<std::string>& lines) {
  std::vector<DirectRun> runs;
  std::map<std::string, std::size_t> open;
  for (const std::string& line : lines) {
    json record = json::parse(line);
    if (record.at("type") == "header") continue;
    const std::string task = record.at("task");
    const bool ends = record.at("type") == "task_end";
    if (!open.contains(task)) {
      if (ends) continue;  // not reached: it never began
      open[task] = runs.size();
      runs.push_back({task, {}});
    }
    runs[open[task]].records.push_back(std::move(record));
    if (ends) open.erase(task);
  }
  return runs;
}

void direct_apply(const json& record, DirectState& state) {
  const std::string type = record.at("type");
  if (record.contains("t")) state.t = record.at("t");
  if (type == "try" || type == "wait") state.n = record.at("n");
  if (type == "goal" || type == "end") state.loops.clear();
  if (type == "goal") state.variables.clear();
  if (type == "set") state.variables[record.at("var")] = record.at("value");
  if (type == "enter") {
    state.loops.push_back({record.at("kind"), record.at("file"), record.at("line"), 0, 0});
  }
  if (type == "exit") state.loops.pop_back();
  if (type == "attach") state.carries = record.at("component");
  if (type == "detach") state.carries = "";
  if (record.contains("q")) state.q = record.at("q").get<std::map<std::string, double>>();
  if (type != "try") return;
  for (DirectLoop& loop : state.loops) {
    ++loop.tried;
    if (record.at("ok")) ++loop.made;
  }
}

}  // namespace rubicon::test
