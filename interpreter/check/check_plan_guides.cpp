#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "interpreter/check/check_plan_parts.hpp"

namespace rubicon::interpreter::plan_check {

namespace {

const syntax::GuideDeclaration* guide_of(const RobotSpec& robot, const std::string& name) {
  for (const syntax::GuideDeclaration& guide : robot.robot->guides) {
    if (guide.name.text == name) return &guide;
  }
  return nullptr;
}

std::string suggestion(const Subject& subject, const RobotSpec& robot, const std::string& name) {
  std::vector<std::string> names = subject.guides.names();
  for (const syntax::GuideDeclaration& guide : robot.robot->guides) {
    names.push_back(guide.name.text);
  }
  const std::string near = did_you_mean(name, names);
  return near.empty() ? std::string() : fmt::format("; did you mean {}?", near);
}

}  // namespace

void check_guides(Subject& subject) {
  for (const syntax::PlanItem& item : subject.plan.items) {
    const auto* guide = std::get_if<syntax::GuideDeclaration>(&item);
    if (guide == nullptr) continue;
    subject.guides.declare(*guide, subject.diagnostics);
    check_guide(*guide, subject.diagnostics);
  }
}

std::vector<guides::GuideSpec> resolve_guides(Subject& subject, const RobotSpec* robot,
                                              const syntax::GuideItem& item) {
  std::vector<guides::GuideSpec> specs;
  if (robot == nullptr || !robot->robot || !robot->robot->usable) return specs;
  for (const syntax::Name& name : item.names) {
    const syntax::GuideDeclaration* guide = subject.guides.find(name.text);
    const bool of_plan = guide != nullptr;
    if (!of_plan) guide = guide_of(*robot, name.text);
    if (guide == nullptr) {
      if (!subject.judges_names()) continue;
      subject.error(
          "P01", name.span,
          fmt::format("unknown guide '{}'{}", name.text, suggestion(subject, *robot, name.text)),
          fmt::format("declare it in the plan: guide {} rrt_connect;", name.text));
      continue;
    }
    const bool twice = std::any_of(specs.begin(), specs.end(), [&](const guides::GuideSpec& spec) {
      return spec.name == name.text;
    });
    if (twice) {
      subject.error("P02", name.span, fmt::format("guide '{}' is named twice", name.text));
      continue;
    }
    // What is wrong with it by itself was said where it is declared.
    Diagnostics said;
    std::optional<guides::GuideSpec> spec = check_guide(*guide, said);
    if (!spec) continue;
    const robot::RobotModel& model = robot->robot->model;
    if (!resolve_parameters(*guide, model, *spec, subject.diagnostics)) continue;
    if (of_plan && !check_guided_robot(model, name.span, subject.diagnostics)) continue;
    specs.push_back(*std::move(spec));
  }
  return specs;
}

}  // namespace rubicon::interpreter::plan_check
