#include "src/results/golden/golden_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "interpreter/check/plan_model.hpp"
#include "interpreter/program/program.hpp"
#include "interpreter/syntax/name_suggestion.hpp"
#include "src/results/golden/difference.hpp"
#include "src/results/golden/observation.hpp"
#include "src/results/golden/task_difference.hpp"
#include "src/results/golden/tolerance.hpp"
#include "src/results/report/diagnostic_printer.hpp"
#include "src/simulation/taskplan/preflight_errors.hpp"
#include "src/simulation/taskplan/run_plan.hpp"
#include "src/simulation/trace/record.hpp"

namespace rubicon::golden {

namespace {

using interpreter::Diagnostic;
using interpreter::Diagnostics;
using interpreter::PlanModel;
using interpreter::SourceMap;
using nlohmann::ordered_json;

std::map<Place, std::string> command_texts(const PlanModel& plan, const SourceMap& sources) {
  std::map<Place, std::string> texts;
  for (const auto& robot : plan.robots) {
    const interpreter::Program program = compile(robot.robot);
    for (std::size_t i = 0; i < program.nodes.size(); ++i) {
      if (program.command_texts[i].empty()) continue;
      const interpreter::Span span = program.nodes[i].span;
      const interpreter::Position position = sources.position(span);
      texts[{sources.file(span.file).path, position.line, position.column}] =
          program.command_texts[i];
    }
  }
  return texts;
}

std::map<std::string, Values> starts(const PlanModel& plan) {
  std::map<std::string, Values> configurations;
  for (const auto& robot : plan.robots) {
    Values& q = configurations[robot.name];
    for (std::size_t i = 0; i < robot.start.size(); ++i) {
      q[robot.robot->model.parameters[i].display_name] = robot.start[i];
    }
  }
  return configurations;
}

/// What a short plan's golden says beside its events: the one motion's end.
void add_motion_end(ordered_json& document, const ObservedEnd& end) {
  document["status"] = end.status;
  document["period"] = end.period ? ordered_json(*end.period) : ordered_json(nullptr);
  document["tries"] = end.tries;
  document["accepted"] = end.accepted;
  ordered_json& rejected = document["rejected"] = ordered_json::object();
  const auto add = [&](const char* reason, int count) {
    if (count > 0) rejected[reason] = count;
  };
  add("at", end.rejected.at_goal);
  add("no", end.rejected.no_direction);
  add("limit", end.rejected.limit);
  add("hit", end.rejected.hit);
  document["end"] = end.q;
  document["vars"] = end.variables;
}

void add_schedule(ordered_json& document, const taskplan::Schedule& schedule) {
  document["process_time"] = trace::seconds(schedule.process_time);
  if (schedule.costed) document["cost"] = schedule.cost;
  if (schedule.has_kinds) {
    for (const taskplan::CostKind kind : told_kinds(schedule)) {
      document["cost_by_kind"][name_of(kind)] =
          schedule.cost_by_kind[static_cast<std::size_t>(kind)];
    }
  }
  document["tasks"] = ordered_json::array();
  for (const taskplan::TaskOutcome& task : schedule.tasks) {
    ordered_json row = {{"task", task.task},
                        {"start", trace::seconds(task.start)},
                        {"duration", trace::seconds(task.duration)}};
    if (schedule.costed) row["cost"] = task.cost;
    row["tried"] = task.tried;
    row["accepted"] = task.accepted;
    row["result"] = name_of(task.result);
    row["reason"] = without_folders(task.reason);
    document["tasks"].push_back(std::move(row));
  }
}

std::string summary(const ordered_json& document, const ObservedEnd& end) {
  std::string text = fmt::format("status {}", document.at("status").get<std::string>());
  text += fmt::format("; tries {}, accepted {}, rejected {} (", document.at("tries").get<int>(),
                      document.at("accepted").get<int>(),
                      document.at("tries").get<int>() - document.at("accepted").get<int>());
  const char* separator = "";
  for (const auto& [reason, count] : document.at("rejected").items()) {
    text += fmt::format("{}{} {}", separator, reason, count.get<int>());
    separator = ", ";
  }
  text += "); off goal:";
  separator = " ";
  for (const auto& [name, off] : end.residual) {
    if (std::fabs(off) <= kNumberTolerance) continue;
    text += fmt::format("{}{}={}", separator, name, brief(off));
    separator = ", ";
  }
  return separator[0] == ' ' ? text + " none" : text;
}

constexpr std::array kMembers = {"name",         "note",     "status",       "period",
                                 "tries",        "accepted", "rejected",     "end",
                                 "vars",         "warnings", "process_time", "cost",
                                 "cost_by_kind", "tasks",    "tolerance",    "events"};

/// What is misspelt would be left out, and so not compared. Throws std::invalid_argument with a
/// sentence for people.
void check_members(const ordered_json& golden) {
  interpreter::NameSuggestions suggestions;
  for (const auto& [name, value] : golden.items()) {
    if (std::find(kMembers.begin(), kMembers.end(), name) != kMembers.end()) continue;
    throw std::invalid_argument(
        fmt::format("there is no member '{}'{}", name, suggestions.ending(name, [&] {
          return std::vector<std::string>(kMembers.begin(), kMembers.end());
        })));
  }
}

/// Tasks have their own tolerance by their names: those that are there or expected.
void check_tasks(const Tolerance& tolerance, const ordered_json& expected,
                 const ordered_json& found) {
  std::vector<std::string> names;
  for (const ordered_json* document : {&found, &expected}) {
    const auto tasks = document->find("tasks");
    if (tasks == document->end() || !tasks->is_array()) continue;
    for (const ordered_json& task : *tasks) names.push_back(task_name(task));
  }
  interpreter::NameSuggestions suggestions;
  for (const std::string& name : tolerance.tasks()) {
    if (std::find(names.begin(), names.end(), name) != names.end()) continue;
    throw std::invalid_argument(fmt::format("there is no task '{}', which the tolerance names{}",
                                            name, suggestions.ending(name, [&] { return names; })));
  }
}

/// Without what differs where times do: how many steps each task tried and made.
ordered_json without_counts(ordered_json document) {
  for (ordered_json& task : document.at("tasks")) {
    task.erase("tried");
    task.erase("accepted");
  }
  return document;
}

/// One event a line, so that version control shows what changed.
std::string pretty(const ordered_json& document) {
  std::string text = "{";
  const char* separator = "\n";
  for (const auto& [key, value] : document.items()) {
    text += separator + ordered_json(key).dump() + ": ";
    separator = ",\n";
    if (value.is_array() && !value.empty() && value[0].is_object()) {
      const char* inner = "[\n  ";
      for (const auto& element : value) {
        text += inner + element.dump();
        inner = ",\n  ";
      }
      text += "\n]";
    } else {
      text += value.dump();
    }
  }
  return text + "\n}\n";
}

}  // namespace

CaseResult run_case(const std::string& folder, const std::string& expected,
                    interpreter::FileProvider& files) {
  CaseResult result;
  result.name = folder;
  SourceMap sources;
  Diagnostics diagnostics;
  const std::unique_ptr<PlanModel> plan =
      load_plan(folder + "/site.plan", sources, files, diagnostics);
  if (plan) {
    for (Diagnostic& diagnostic : taskplan::preflight_errors(*plan))
      diagnostics.add(std::move(diagnostic));
  }
  if (!plan || diagnostics.has_errors()) {
    result.wrong_input = true;
    result.report = report::print_text(diagnostics.sorted(), sources, false);
    return result;
  }
  Observation observation(command_texts(*plan, sources), starts(*plan), !plan->short_form);
  const taskplan::Schedule schedule = taskplan::run_plan(*plan, sources, &observation);

  ordered_json old = ordered_json::object();
  if (!expected.empty()) {
    old = ordered_json::parse(expected, nullptr, false);
    if (!old.is_object()) {
      result.wrong_input = true;
      result.report =
          "expected.json is not a JSON object; delete it, and write it anew with --update\n";
      return result;
    }
  }
  const bool tolerant = old.contains("tolerance");
  // What people wrote about the case stays; what it says of the run is made anew.
  ordered_json document = ordered_json::object();
  document["name"] = folder.substr(folder.rfind('/') + 1);
  document["note"] = old.value("note", std::string());
  std::string head = fmt::format("# {}: {}\n", document.at("name").get<std::string>(),
                                 document.at("note").get<std::string>());
  if (plan->short_form && !observation.ends().empty()) {
    add_motion_end(document, observation.ends().front());
    head += "# " + summary(document, observation.ends().front()) + "\n";
  } else {
    if (tolerant) document["tolerance"] = old.at("tolerance");
    add_schedule(document, schedule);
    head += fmt::format("# {} tasks, process time {} s\n", schedule.tasks.size(),
                        brief(trace::seconds(schedule.process_time)));
  }
  try {
    check_members(old);
    if (tolerant && plan->short_form) {
      throw std::invalid_argument("a tolerance is for plans with tasks: leave it out");
    }
    check_tasks(Tolerance(old), old, document);
  } catch (const std::invalid_argument& error) {
    result.wrong_input = true;
    result.report = fmt::format("expected.json: {}\n", error.what());
    return result;
  }
  document["warnings"] = ordered_json::array();
  for (const Diagnostic& diagnostic : diagnostics.sorted()) {
    document["warnings"].push_back(report::print_brief(diagnostic, sources));
    head += "# check: " + report::print_brief(diagnostic, sources) + "\n";
  }
  if (!tolerant || old.contains("events")) document["events"] = observation.events();
  result.expected_json = pretty(tolerant ? without_counts(document) : document);
  result.expected_trace = head + observation.text();
  result.report = expected.empty() ? "expected.json is missing or empty; write it with --update\n"
                                   : difference(old, document);
  result.passed = result.report.empty();
  return result;
}

std::string junit_xml(const std::vector<CaseResult>& results) {
  const auto escaped = [](const std::string& text) {
    std::string out;
    for (const char byte : text) {
      switch (byte) {
        case '&':
          out += "&amp;";
          break;
        case '<':
          out += "&lt;";
          break;
        case '>':
          out += "&gt;";
          break;
        case '"':
          out += "&quot;";
          break;
        case '\n':
          out += "&#10;";
          break;
        default:
          if (static_cast<unsigned char>(byte) >= 0x20 || byte == '\t') out += byte;
      }
    }
    return out;
  };
  int failures = 0;
  for (const CaseResult& one : results) failures += one.passed ? 0 : 1;
  std::string xml = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuite name=\"rubicon\" tests=\"{}\" "
      "failures=\"{}\">\n",
      results.size(), failures);
  for (const CaseResult& one : results) {
    xml += fmt::format("  <testcase classname=\"rubicon\" name=\"{}\"", escaped(one.name));
    xml += one.passed
               ? "/>\n"
               : fmt::format("><failure message=\"{}\">{}</failure></testcase>\n",
                             one.wrong_input ? "wrong input" : "differs", escaped(one.report));
  }
  return xml + "</testsuite>\n";
}

}  // namespace rubicon::golden
