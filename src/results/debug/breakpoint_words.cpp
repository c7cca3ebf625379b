#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <set>

#include "interpreter/syntax/diagnostic.hpp"
#include "src/results/debug/breakpoint.hpp"

namespace rubicon::debug {

namespace {

/// Of the names that would do so many are told.
constexpr std::size_t kShownNames = 8;

using Answer = std::variant<Breakpoint, std::string>;

bool is_number(const std::string& text) {
  return !text.empty() &&
         std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

std::string suggestion(const std::string& name, const std::vector<std::string>& names) {
  const std::string near = interpreter::did_you_mean(name, names);
  return near.empty() ? std::string() : "; did you mean " + near + "?";
}

/// The files whose path is `name` or ends with it.
std::vector<std::size_t> files_named(const std::string& name, const Recording& recording) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < recording.files.size(); ++i) {
    const std::string& path = recording.files[i].path;
    if (path == name) return {i};
    if (path.ends_with("/" + name)) found.push_back(i);
  }
  return found;
}

/// What takes part in a hit of this recording.
std::vector<std::string> names_in_hits(const Recording& recording) {
  std::set<std::string> names;
  for (const Refusal& refusal : recording.refusals) {
    if (refusal.met.empty()) continue;
    names.insert(refusal.moved);
    names.insert(refusal.met);
  }
  return {names.begin(), names.end()};
}

/// "; what meets something is high.hook, low.jib": of many some.
std::string some_of(const std::vector<std::string>& names) {
  if (names.empty()) return {};
  const auto count = static_cast<std::ptrdiff_t>(std::min(names.size(), kShownNames));
  return fmt::format("; what meets something is {}{}",
                     fmt::join(names.begin(), names.begin() + count, ", "),
                     names.size() > kShownNames ? " ..." : "");
}

Answer pair_of(const std::vector<std::string>& words, const Recording& recording) {
  if (words.size() < 2 || words.size() > 3) {
    return "break pair takes one or two names; those with blanks stand in \"...\"";
  }
  const std::vector<std::string> names = names_in_hits(recording);
  Breakpoint breakpoint;
  breakpoint.kind = Breakpoint::Kind::pair;
  breakpoint.one = words[1];
  if (words.size() == 3) breakpoint.other = words[2];
  for (std::size_t i = 1; i < words.size(); ++i) {
    if (std::find(names.begin(), names.end(), words[i]) != names.end()) continue;
    const std::string near = suggestion(words[i], names);
    return fmt::format("nothing meets '{}' in this recording{}", words[i],
                       near.empty() ? some_of(names) : near);
  }
  return breakpoint;
}

Answer task_of(const std::vector<std::string>& words, const Recording& recording) {
  if (words.size() != 2) return "break task takes the name of a task";
  std::vector<std::string> names;
  for (const TaskRun& run : recording.runs) names.push_back(recording.texts[run.name()]);
  if (std::find(names.begin(), names.end(), words[1]) == names.end()) {
    return fmt::format("no task '{}' begins in this recording{}", words[1],
                       suggestion(words[1], names));
  }
  Breakpoint breakpoint;
  breakpoint.kind = Breakpoint::Kind::task;
  breakpoint.one = words[1];
  return breakpoint;
}

}  // namespace

std::vector<int> lines_with_records(const Recording& recording, std::size_t file) {
  std::set<int> lines;
  for (const Place& place : recording.places) {
    if (place.file == file) lines.insert(place.line);
  }
  return {lines.begin(), lines.end()};
}

std::variant<NamedLine, std::string> line_named(const std::string& text, const Recording& recording,
                                                std::size_t here) {
  const std::size_t colon = text.rfind(':');
  const std::string number = colon == std::string::npos ? text : text.substr(colon + 1);
  NamedLine line{here, 0};
  const auto read = std::from_chars(number.data(), number.data() + number.size(), line.line);
  if (!is_number(number) || read.ec != std::errc() || line.line < 1) {
    return fmt::format("'{}' is no line: it is LINE or FILE:LINE", text);
  }
  if (colon == std::string::npos) {
    if (here < recording.files.size()) return line;
    return "no script is open here: name it, FILE:LINE";
  }
  const std::string name = text.substr(0, colon);
  const std::vector<std::size_t> found = files_named(name, recording);
  if (found.size() == 1) {
    line.file = found.front();
    return line;
  }
  std::vector<std::string> names;
  for (const ScriptFile& file : recording.files) names.push_back(file.name);
  return found.empty() ? fmt::format("there is no file '{}'{}", name, suggestion(name, names))
                       : fmt::format("several files are called '{}': give more of the path", name);
}

std::variant<Breakpoint, std::string> breakpoint_of(const std::vector<std::string>& words,
                                                    const Recording& recording, std::size_t here) {
  if (words.empty()) return "where? see help break";
  if (words[0] == "pair") return pair_of(words, recording);
  if (words[0] == "task") return task_of(words, recording);
  if (words.size() > 1) return fmt::format("'{}' is too much; see help break", words[1]);
  Breakpoint breakpoint;
  if (words[0] == "refused" || words[0] == "hit") {
    breakpoint.kind = words[0] == "hit" ? Breakpoint::Kind::hit : Breakpoint::Kind::refused;
    return breakpoint;
  }
  if (!is_number(words[0].substr(words[0].rfind(':') + 1))) {
    return fmt::format("'{}' is no place to stop{}; see help break", words[0],
                       suggestion(words[0], {"refused", "hit", "pair", "task"}));
  }
  const auto line = line_named(words[0], recording, here);
  if (const auto* message = std::get_if<std::string>(&line)) return *message;
  breakpoint.kind = Breakpoint::Kind::line;
  breakpoint.file = std::get<NamedLine>(line).file;
  breakpoint.line = std::get<NamedLine>(line).line;
  return breakpoint;
}

}  // namespace rubicon::debug
