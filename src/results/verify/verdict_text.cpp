#include "src/results/verify/verdict_text.hpp"

#include <fmt/format.h>

#include "src/results/verify/input/json_fields.hpp"
#include "src/results/verify/schedule/task_clock.hpp"

namespace rubicon::verify {

namespace {

constexpr std::size_t kMostLines = 50;

const std::string& file_of(const Fault& fault, const ResultNames& names) {
  switch (fault.file) {
    case ResultFile::schedule_json:
      return names.schedule_json;
    case ResultFile::schedule_csv:
      return names.schedule_csv;
    case ResultFile::loads_csv:
      return names.loads_csv;
    case ResultFile::report:
      return names.report;
    default:
      return names.trace;
  }
}

std::string line_of(const Fault& fault, const ResultNames& names) {
  std::string text = file_of(fault, names);
  if (fault.line > 0) text += fmt::format(":{}", fault.line);
  text += ": ";
  if (!fault.task.empty()) text += fmt::format("task {} ", fault.task);
  if (fault.time >= 0) text += fmt::format("at {}", clock_text(fault.time));
  if (text.back() == ' ') text.pop_back();
  if (text.back() != ':') text += ':';
  return text + fmt::format(" {}\n", fault.text);
}

}  // namespace

std::string verdict_text(const Verdict& verdict, const ResultNames& names) {
  if (verdict.faults.empty()) {
    return fmt::format("verified: {} tasks ({} done), {} steps, {} close pairs, no fault\n",
                       verdict.tasks, verdict.done, verdict.steps, verdict.pairs);
  }
  std::string text;
  for (std::size_t i = 0; i < verdict.faults.size() && i < kMostLines; ++i) {
    text += line_of(verdict.faults[i], names);
  }
  const std::size_t count = verdict.faults.size();
  return text + fmt::format("{} fault{}{}\n", count, count == 1 ? "" : "s",
                            count > kMostLines
                                ? fmt::format(", the first {} of them above", kMostLines)
                                : "");
}

std::string verdict_json(const Verdict& verdict, const ResultNames& names) {
  nlohmann::ordered_json json;
  json["verified"] = verdict.faults.empty();
  json["tasks"] = verdict.tasks;
  json["done"] = verdict.done;
  json["steps"] = verdict.steps;
  json["pairs"] = verdict.pairs;
  json["faults"] = nlohmann::ordered_json::array();
  for (const Fault& fault : verdict.faults) {
    nlohmann::ordered_json each;
    each["kind"] = name_of(fault.kind);
    each["file"] = file_of(fault, names);
    each["line"] = fault.line;
    each["task"] = fault.task;
    if (fault.time >= 0) {
      each["t"] = static_cast<double>(fault.time) / static_cast<double>(kSecond);
    } else {
      each["t"] = nullptr;
    }
    each["text"] = fault.text;
    json["faults"].push_back(std::move(each));
  }
  return json.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace rubicon::verify
