#include "src/results/debug/session.hpp"

#include <fmt/format.h>

#include "interpreter/syntax/diagnostic.hpp"
#include "src/results/debug/clean_text.hpp"
#include "src/results/debug/command_words.hpp"
#include "src/results/debug/stop_text.hpp"

namespace rubicon::debug {

namespace {

bool is_step(std::string_view name) {
  return name == "step" || name == "back" || name == "next" || name == "out" || name == "record" ||
         name == "continue" || name == "reverse";
}

/// A command longer than this (bytes) is no command.
constexpr std::size_t kLongestCommand = 4096;

}  // namespace

Session::Session(Recording recording, const std::string& task, Paint paint)
    : recording_(std::move(recording)), paint_(paint) {
  set_scope(clean_text(task));
}

std::string Session::why_not(const Recording& recording, const std::string& task) {
  if (recording.detail != "steps") {
    return fmt::format(
        "this trace has no steps (its detail is '{}'): run again with --trace-detail steps",
        clean_text(recording.detail));
  }
  const std::string name = clean_text(task);
  for (const TaskRun& run : recording.runs) {
    if (run.size() > 0 && (name.empty() || recording.texts[run.name()] == name)) return {};
  }
  if (name.empty()) return "no task began: there is nothing to step through";
  std::vector<std::string> names;
  for (const PlannedTask& each : recording.tasks) {
    if (each.name == name) {
      return fmt::format("'{}' never began{}{}", name, each.reason.empty() ? "" : ": ",
                         each.reason);
    }
    names.push_back(each.name);
  }
  const std::string near = interpreter::did_you_mean(name, names);
  return fmt::format("there is no task '{}'{}", name,
                     near.empty() ? "" : "; did you mean " + near + "?");
}

void Session::set_scope(const std::string& task) {
  scope_.clear();
  only_ = task;
  for (std::size_t i = 0; i < recording_.runs.size(); ++i) {
    const TaskRun& run = recording_.runs[i];
    if (run.size() > 0 && (task.empty() || recording_.texts[run.name()] == task)) {
      scope_.push_back(i);
    }
  }
  at_ = {};
  state_ = run().state_at(0);
}

std::string Session::opening() const {
  const std::string count =
      scope_.size() == 1 ? std::string() : fmt::format("{} tasks. ", scope_.size());
  return fmt::format("plan {}. {}'help' tells the commands.\n", recording_.plan, count) +
         stop_text(recording_, run(), state_, paint_);
}

std::string Session::execute(std::string_view command) {
  if (command.size() > kLongestCommand) return "this line is too long for a command\n";
  Words words = words_of(command);
  if (words.empty()) words = words_of(again_);
  for (std::string& word : words) word = clean_text(word);
  const CommandMatch match = find_command(words.front());
  if (match.command == nullptr) return match.message + "\n";
  words.erase(words.begin());
  const std::string name = match.command->name;
  if (is_step(name)) again_ = name + (words.empty() ? "" : " " + words.front());
  return dispatch(name, words);
}

std::string Session::dispatch(const std::string& name, const Words& words) {
  if (name == "step") return step(words);
  if (name == "back") return back(words);
  if (name == "next") return to_end_of_loop(0);
  if (name == "out") return to_end_of_loop(1);
  if (name == "record") return record(words);
  if (name == "continue") return go_on();
  if (name == "reverse") return go_back();
  if (name == "run") return run_to(words);
  if (name == "until") return until(words);
  if (name == "break") return add_break(words);
  if (name == "breaks") return list_breaks();
  if (name == "delete") return delete_break(words);
  if (name == "print") return print(words);
  if (name == "where") return where();
  if (name == "config") return config();
  if (name == "list") return list(words);
  if (name == "tasks") return tasks(words);
  if (name == "task") return go_to_task(words);
  if (name == "info") return info();
  if (name == "help") return help(words);
  ended_ = true;
  return {};
}

}  // namespace rubicon::debug
