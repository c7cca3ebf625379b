#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "interpreter/syntax/diagnostic.hpp"
#include "src/results/debug/command_words.hpp"
#include "src/results/debug/number_text.hpp"
#include "src/results/debug/session.hpp"
#include "src/results/debug/stop_text.hpp"

namespace rubicon::debug {

namespace {

/// `list` shows so many lines before and after the place.
constexpr int kLinesAround = 5;
/// `tasks` shows so many.
constexpr std::size_t kShownTasks = 60;

std::string counted(int count, const char* one, const char* many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

}  // namespace

std::optional<Place> Session::here() const {
  const std::span<const Event> events = run().events();
  for (std::size_t i = at_.position; i > 0; --i) {
    if (const Place* place = recording_.place_of(events[i - 1])) return *place;
  }
  for (std::size_t i = at_.position; i < events.size(); ++i) {
    if (const Place* place = recording_.place_of(events[i])) return *place;
  }
  return std::nullopt;
}

std::string Session::print(const Words& words) const {
  std::string text;
  if (words.empty()) {
    for (const auto& [name, value] : state_.variables) {
      text += fmt::format("var({}) = {}\n", recording_.texts[name], number_text(value));
    }
    return text.empty() ? "no variable is set\n" : text;
  }
  if (words.size() > 1) return "print takes one name\n";
  std::string wanted = words.front();
  if (wanted.starts_with("var(") && wanted.ends_with(')')) {
    wanted = wanted.substr(4, wanted.size() - 5);
  }
  std::vector<std::string> names;
  for (const auto& [name, value] : state_.variables) {
    names.push_back(recording_.texts[name]);
    if (names.back() == wanted) text += fmt::format("var({}) = {}\n", wanted, number_text(value));
  }
  const std::vector<double> q = run().configuration(state_.row);
  for (std::size_t i = 0; i < q.size(); ++i) {
    names.push_back(run().parameters()[i]);
    if (names.back() == wanted) text += fmt::format("{} = {}\n", wanted, number_text(q[i]));
  }
  if (!text.empty()) return text;
  const std::string near = interpreter::did_you_mean(wanted, names);
  return fmt::format("no variable that is set and no parameter is called '{}'{}\n", wanted,
                     near.empty() ? "" : "; did you mean " + near + "?");
}

std::string Session::loop_text(const LoopState& loop) const {
  const Place* place =
      loop.place < recording_.places.size() ? &recording_.places[loop.place] : nullptr;
  std::string text = fmt::format("{} at {}", recording_.texts[loop.kind],
                                 place == nullptr ? "?" : recording_.place_text(*place));
  if (loop.visit > 1) text += fmt::format(", begun {} times", loop.visit);
  text += fmt::format(": round {}, {} tried, {} accepted", loop.rounds, loop.tried, loop.made);
  const std::span<const Event> events = run().events();
  const std::uint32_t exit = events[loop.entered].row;
  if (exit == kNone) return text + "; it never ends by itself\n";
  const Event& end = events[exit];
  const int n = run().state_at(exit).n;
  return text + fmt::format("; ends {} after try {}, {}\n", end.ok ? "reached" : "exhausted", n,
                            counted(static_cast<int>(end.value), "success", "successes"));
}

std::string Session::where() const {
  if (state_.loops.empty()) return "in no loop\n";
  std::string text;
  int number = 0;
  for (auto loop = state_.loops.rbegin(); loop != state_.loops.rend(); ++loop) {
    text += fmt::format("#{}  {}", number++, loop_text(*loop));
  }
  return text;
}

std::string Session::config() const {
  const std::vector<double> after = run().configuration(state_.row);
  if (after.empty()) return "this task moves no machine\n";
  const bool tried =
      at_.position > 0 && run().events()[at_.position - 1].kind == EventKind::attempt;
  const std::vector<double> before = run().configuration(tried ? state_.row_before : state_.row);
  std::size_t width = 0;
  for (const std::string& name : run().parameters()) width = std::max(width, name.size());
  std::string text;
  for (std::size_t i = 0; i < after.size(); ++i) {
    const bool moved = before[i] != after[i] && !std::isnan(after[i]);
    text += fmt::format("{:<{}}  {}\n", run().parameters()[i], width,
                        moved ? change_text(before[i], after[i]) : number_text(after[i]));
  }
  return text;
}

std::string Session::list(const Words& words) {
  const std::optional<Place> place = here();
  NamedLine middle{place ? place->file : recording_.files.size(), place ? place->line : 0};
  if (!words.empty()) {
    const auto named = line_named(words.front(), recording_, middle.file);
    if (const auto* message = std::get_if<std::string>(&named)) return *message + "\n";
    middle = std::get<NamedLine>(named);
  }
  if (middle.file >= recording_.files.size()) return "no script is open here\n";
  const ScriptFile& file = recording_.files[middle.file];
  const int lines = static_cast<int>(file.lines.size());
  if (middle.line > lines) return fmt::format("{} has {} lines\n", file.name, lines);
  std::string text = paint_.mark(file.path) + "\n";
  const int last = std::min(lines - kLinesAround, middle.line) + kLinesAround;
  for (int line = std::max(1, middle.line - kLinesAround); line <= last; ++line) {
    const bool stops =
        std::any_of(breakpoints_.begin(), breakpoints_.end(), [&](const Breakpoint& each) {
          return each.kind == Breakpoint::Kind::line && each.file == middle.file &&
                 each.line == line;
        });
    const bool is_here = place && place->file == middle.file && place->line == line;
    const std::string shown = fmt::format("{}{} {:4}  {}", stops ? '*' : ' ', is_here ? "->" : "  ",
                                          line, file.lines[static_cast<std::size_t>(line - 1)]);
    text += (is_here ? paint_.bold(shown) : shown) + "\n";
  }
  return text;
}

std::string Session::tasks(const Words& words) const {
  std::string text;
  std::size_t shown = 0;
  std::size_t more = 0;
  std::size_t width = 0;
  for (const TaskRun& run : recording_.runs) {
    width = std::max(width, recording_.texts[run.name()].size());
  }
  for (std::size_t i = 0; i < recording_.runs.size(); ++i) {
    const TaskRun& run = recording_.runs[i];
    const std::string& name = recording_.texts[run.name()];
    if (!words.empty() && name.find(words.front()) == std::string::npos) continue;
    if (++shown > kShownTasks) {
      ++more;
      continue;
    }
    const PlannedTask* task = recording_.task_of(run);
    const std::string begins = run.size() > 0 ? time_text(recording_, run.events().front().t) : "";
    text += fmt::format(
        "{}{:4}  {:<{}}  {:6} tried  {:6} accepted  {}  {}{}\n", scope_[at_.run] == i ? "->" : "  ",
        i + 1, name, std::min<std::size_t>(width, 40), run.last().tried + run.last().waits,
        run.last().made + run.last().waits, begins, recording_.texts[run.robot()],
        task != nullptr && task->result != "done" && !task->result.empty() ? "  " + task->result
                                                                           : "");
  }
  if (more > 0)
    text += fmt::format("  ... {} more: tasks TEXT lists those with TEXT in their name\n", more);
  return text.empty() ? "no task has this in its name\n" : text;
}

std::string Session::info() const {
  const std::string& robot = recording_.texts[run().robot()];
  std::string text = stop_text(recording_, run(), state_, paint_);
  text += fmt::format("  {}{}\n", robot.empty() ? std::string() : robot + ": ",
                      situation_text(recording_, run(), state_));
  // A wait counts as a step that was accepted, as in all results.
  text += fmt::format("  {} tried so far, {} accepted, {} of them waits; record {} of {}\n",
                      state_.tried + state_.waits, state_.made + state_.waits, state_.waits,
                      at_.position, run().size());
  if (const std::optional<Place> place = here()) {
    text += fmt::format("  in {}:{}\n", recording_.files[place->file].path, place->line);
  }
  return text;
}

std::string Session::help(const Words& words) const {
  if (!words.empty()) {
    const CommandMatch match = find_command(words.front());
    if (match.command == nullptr) return match.message + "\n";
    const CommandWord& word = *match.command;
    return fmt::format("{}{}{}{}\n{}.\n{}{}", word.name, *word.letter != 0 ? ", " : "", word.letter,
                       *word.usage != 0 ? fmt::format(" {}", word.usage) : "", word.summary,
                       word.more, *word.more != 0 ? "\n" : "");
  }
  std::string text;
  for (const CommandWord& word : command_words()) {
    text += fmt::format("  {:1}  {:8}  {}\n", word.letter, word.name, word.summary);
  }
  return text +
         "The beginning of a word is enough; an empty line does the last step again; ';' separates "
         "commands.\n";
}

}  // namespace rubicon::debug
