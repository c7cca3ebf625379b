#include <fmt/format.h>

#include <algorithm>
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

namespace {

/// Whether a formula reads the value of the parameter, its step or its start.
bool reads(const robot::Formula& formula, int parameter) {
  using Kind = robot::FormulaOp::Kind;
  return std::any_of(formula.code.begin(), formula.code.end(), [&](const robot::FormulaOp& op) {
    return op.index == parameter &&
           (op.kind == Kind::parameter || op.kind == Kind::step || op.kind == Kind::start);
  });
}

bool reads(const robot::FrameFormula& frame, int parameter) {
  return std::any_of(frame.begin(), frame.end(), [&](const robot::FrameElement& each) {
    return reads(each.a, parameter) || reads(each.b, parameter) || reads(each.c, parameter);
  });
}

/// R23: parameters whose steps move nothing, for nobody uses their values.
void warn_of_idle_parameters(const Subject& subject) {
  const robot::RobotModel& model = subject.model;
  const bool has_shapes = std::any_of(
      model.bodies.begin(), model.bodies.end(),
      [](const robot::Body& body) { return !body.shapes.empty() || body.rope.has_value(); });
  if (!has_shapes) return;
  for (std::size_t i = 0; i < model.parameters.size(); ++i) {
    const robot::Parameter& parameter = model.parameters[i];
    const auto index = static_cast<int>(i);
    if (parameter.derived || !(parameter.step > 0)) continue;
    bool used = reads(model.tool_frame, index);
    for (const robot::Body& body : model.bodies) used = used || reads(body.frame, index);
    for (std::size_t k = 0; k < model.parameters.size() && !used; ++k) {
      const robot::Parameter& other = model.parameters[k];
      used = reads(other.derived_value, index) || (k != i && reads(other.rule, index));
    }
    if (used) continue;
    const std::string& body = model.bodies[static_cast<std::size_t>(parameter.body)].name;
    subject.diagnostics.warning(
        "R23", subject.parameters[i]->name.span,
        fmt::format("{} of body '{}' moves nothing: no frame, rule or derived parameter uses it",
                    parameter.name, body),
        parameter.rotation
            ? fmt::format("turn the body by it, such as frame rotz({});", parameter.name)
            : fmt::format("move the body by it, such as frame trans({}, {}, {});",
                          parameter.name == "x" ? "x" : "0", parameter.name == "y" ? "y" : "0",
                          parameter.name == "z" ? "z" : "0"));
  }
}

}  // namespace

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
  if (diagnostics.errors() == errors_before && !robot.broken) {
    robot_check::warn_of_idle_parameters(subject);
  }
  check_guides(*checked, diagnostics, errors_before);
  robot_check::check_behaviours(subject, *checked, sources, files, plan_situations, script);
  checked->usable = diagnostics.errors() == errors_before && !robot.broken;
  return checked;
}

}  // namespace rubicon::interpreter
