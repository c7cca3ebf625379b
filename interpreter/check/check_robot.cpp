#include <fmt/format.h>

#include <utility>

#include "interpreter/check/check.hpp"
#include "interpreter/check/check_guide.hpp"
#include "interpreter/check/check_robot_parts.hpp"
#include "interpreter/parse/parse.hpp"

namespace rubicon::interpreter {

namespace {

/// The guides of a robot, each as declared there; whether they can guide it is asked where the rest
/// of the robot is right.
void check_guides(const CheckedRobot& checked, Diagnostics& diagnostics, int errors_before) {
  GuideDeclarations declarations;
  const bool robot_is_right = diagnostics.errors() == errors_before;
  for (const syntax::GuideDeclaration& guide : checked.guides) {
    declarations.declare(guide, diagnostics);
    std::optional<guides::GuideSpec> spec = check_guide(guide, diagnostics);
    if (!spec || !robot_is_right) continue;
    if (resolve_parameters(guide, checked.model, *spec, diagnostics)) {
      check_guided_robot(checked.model, guide.name.span, diagnostics);
    }
  }
}

}  // namespace

namespace robot_check {

void Subject::twice(Span second, std::string message, Span first) {
  Diagnostic diagnostic;
  diagnostic.code = "R03";
  diagnostic.span = second;
  diagnostic.message = std::move(message);
  diagnostic.notes.push_back({first, "first given here"});
  diagnostics.add(std::move(diagnostic));
}

}  // namespace robot_check

std::shared_ptr<const CheckedRobot> load_robot(const std::string& path, SourceMap& sources,
                                               FileProvider& files,
                                               const std::vector<std::string>* plan_situations,
                                               Diagnostics& diagnostics) {
  std::variant<std::string, FileFailure> text = files.read_text(path);
  if (const auto* failure = std::get_if<FileFailure>(&text)) {
    diagnostics.error("F01", {}, fmt::format("'{}': {}", path, failure->message));
    return nullptr;
  }
  const FileId file = sources.add(path, std::get<std::string>(std::move(text)));
  return check_robot(file, sources, files, plan_situations, diagnostics);
}

std::shared_ptr<const CheckedRobot> check_robot(FileId file, SourceMap& sources,
                                                FileProvider& files,
                                                const std::vector<std::string>* plan_situations,
                                                Diagnostics& diagnostics,
                                                const GivenScript* script) {
  const int errors_before = diagnostics.errors();
  syntax::Robot robot = parse_robot(sources, file, diagnostics);
  auto checked = std::make_shared<CheckedRobot>();
  checked->path = sources.file(file).path;
  checked->model.name = robot.name.text;

  robot_check::Subject subject{robot, checked->model, diagnostics};
  robot_check::check_settings(subject);
  robot_check::check_deviation(subject);
  robot_check::check_constants(subject);
  robot_check::declare_bodies(subject);
  robot_check::check_attributes(subject);
  robot_check::check_derived(subject);
  robot_check::check_rules(subject);
  robot_check::check_geometry(subject, checked->path, files);
  robot_check::check_turns(subject);
  robot_check::complete_parameters(subject);
  for (const syntax::BodyItem* body : subject.bodies) {
    checked->body_spans.push_back(body->name.span);
  }
  for (const syntax::RobotItem& item : robot.items) {
    const auto* guide = std::get_if<syntax::GuideDeclaration>(&item);
    if (guide != nullptr) checked->guides.push_back(*guide);
  }
  check_guides(*checked, diagnostics, errors_before);
  robot_check::check_behaviours(subject, *checked, sources, files, plan_situations, script);
  checked->usable = diagnostics.errors() == errors_before && !robot.broken;
  return checked;
}

}  // namespace rubicon::interpreter
