#include <fmt/format.h>

#include <utility>

#include "interpreter/check/check_robot_parts.hpp"
#include "interpreter/parse/parse.hpp"

namespace rubicon::interpreter::robot_check {

namespace {

/// Most files of one run: FileId is 16 bits wide.
constexpr std::size_t kMaxFiles = 60000;

/// The id of the file that `written` names; nothing after reporting why it cannot be read (F01).
std::optional<FileId> open_behaviour(Subject& subject, const syntax::String& written,
                                     const std::string& path, SourceMap& sources,
                                     FileProvider& files) {
  for (std::size_t i = 0; i < sources.size(); ++i) {
    if (sources.file(static_cast<FileId>(i)).path == path) return static_cast<FileId>(i);
  }
  if (sources.size() >= kMaxFiles) {
    subject.diagnostics.error("F01", written.span,
                              fmt::format("more than {} files are named", kMaxFiles));
    return std::nullopt;
  }
  std::variant<std::string, FileFailure> text = files.read_text(path);
  if (const auto* failure = std::get_if<FileFailure>(&text)) {
    subject.diagnostics.error("F01", written.span,
                              fmt::format("behaviour '{}': {}", written.text, failure->message));
    return std::nullopt;
  }
  return sources.add(path, std::get<std::string>(std::move(text)));
}

/// The script that `item` holds, which is moved out of it, or names.
std::optional<syntax::Script> take_script(Subject& subject, syntax::BehaviourItem& item,
                                          const std::string& robot_path, SourceMap& sources,
                                          FileProvider& files) {
  if (!item.file) return std::move(item.script);
  const std::optional<FileId> file = open_behaviour(
      subject, *item.file, resolve_path(robot_path, item.file->text), sources, files);
  if (!file) return std::nullopt;
  return parse_script(sources, *file, subject.diagnostics);
}

}  // namespace

void check_behaviours(Subject& subject, CheckedRobot& checked, SourceMap& sources,
                      FileProvider& files, const std::vector<std::string>* plan_situations,
                      const GivenScript* script) {
  bool named = script != nullptr;  // some behaviour was written, even if it could not be read
  checked.body_scripts.resize(subject.bodies.size());
  for (std::size_t i = 0; i < subject.bodies.size(); ++i) {
    auto& items = subject.bodies[i]->behaviours;
    if (items.empty()) continue;
    named = true;
    if (items.size() > 1) {
      subject.twice(items[1].span,
                    fmt::format("body '{}' has two behaviours", subject.bodies[i]->name.text),
                    items[0].span);
    }
    checked.body_scripts[i] = take_script(subject, items[0], checked.path, sources, files);
  }
  const syntax::BehaviourItem* first = nullptr;
  for (syntax::RobotItem& each : subject.robot.items) {
    auto* item = std::get_if<syntax::BehaviourItem>(&each);
    if (item == nullptr) continue;
    named = true;
    if (first != nullptr) {
      subject.twice(item->span, "the robot has two behaviours", first->span);
      continue;
    }
    first = item;
    if (script == nullptr) {
      checked.script = take_script(subject, *item, checked.path, sources, files);
    }
  }
  if (script != nullptr) {
    const auto file = open_behaviour(subject, script->written, script->path, sources, files);
    if (file) checked.script = parse_script(sources, *file, subject.diagnostics);
  }
  if (!named && subject.judges_names() && !subject.bodies.empty()) {
    subject.diagnostics.warning(
        "R19", subject.robot.name.span,
        fmt::format("robot '{}' has no behaviour: it will never move", subject.robot.name.text),
        "write behaviour \"FILE.motion\"; or behaviour { ... }");
  }

  ScriptContext context;
  // Of a robot that did not parse as a whole no one knows all parameters.
  context.robot = subject.robot.broken ? nullptr : &checked.model;
  context.has_plan = plan_situations != nullptr;
  if (plan_situations != nullptr) context.plan_situations = *plan_situations;
  std::vector<std::string> body_behaviours;
  for (std::size_t i = 0; i < checked.body_scripts.size(); ++i) {
    if (!checked.body_scripts[i]) continue;
    context.body = static_cast<int>(i);
    check_script(*checked.body_scripts[i], context, subject.diagnostics);
    body_behaviours.push_back(checked.model.bodies[i].name);
  }
  if (!checked.script) return;
  context.body = -1;
  context.body_behaviours = std::move(body_behaviours);
  check_script(*checked.script, context, subject.diagnostics);
}

}  // namespace rubicon::interpreter::robot_check
