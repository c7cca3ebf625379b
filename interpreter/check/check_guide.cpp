#include "interpreter/check/check_guide.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "interpreter/check/check_number.hpp"
#include "interpreter/check/resolve_keep.hpp"
#include "src/motion/guides/leg.hpp"
#include "src/motion/guides/vehicle.hpp"
#include "src/motion/ompl_bridge/ompl_planners.hpp"

namespace rubicon::interpreter {

namespace {

using guides::ClauseInfo;
using syntax::UnitKind;

constexpr double kLeastWeight = 1e-3;
constexpr double kMostWeight = 1e6;

std::string suggestion(const std::string& name, const std::vector<std::string>& candidates) {
  const std::string near = did_you_mean(name, candidates);
  return near.empty() ? std::string() : fmt::format("; did you mean {}?", near);
}

std::string list_of_kinds() {
  std::string text;
  for (const guides::KindInfo& info : guides::guide_kinds()) {
    text += fmt::format("{}{}", text.empty() ? "" : ", ", info.name);
  }
  return text;
}

class ClauseChecker {
 public:
  ClauseChecker(const syntax::GuideDeclaration& guide, Diagnostics& diagnostics)
      : guide_(guide), diagnostics_(diagnostics) {}

  std::optional<guides::GuideSpec> check() {
    const auto kind = guides::find_kind(guide_.kind.text);
    if (!kind) {
      std::vector<std::string> names;
      for (const guides::KindInfo& info : guides::guide_kinds()) names.emplace_back(info.name);
      diagnostics_.error("G01", guide_.kind.span,
                         fmt::format("unknown kind of guide '{}'{}", guide_.kind.text,
                                     suggestion(guide_.kind.text, names)),
                         "kinds are " + list_of_kinds());
      return std::nullopt;
    }
    spec_ = guides::default_guide(*kind);
    spec_.name = guide_.name.text;
    const int errors = diagnostics_.errors();
    check_planner();
    if (diagnostics_.errors() != errors) return std::nullopt;
    for (const syntax::GuideClause& clause : guide_.clauses) check_clause(clause);
    if (diagnostics_.errors() != errors) return std::nullopt;
    check_steering();
    if (diagnostics_.errors() != errors) return std::nullopt;
    warn_of_heuristic();
    return spec_;
  }

 private:
  /// Of OMPL: a planner that it has, and that guides take.
  void check_planner() {
    const bool of_ompl = spec_.kind == guides::GuideKind::ompl;
    std::vector<std::string> taken;
    for (const ompl_bridge::OmplPlanner& each : ompl_bridge::ompl_planners()) {
      if (each.taken()) taken.emplace_back(each.name);
    }
    const std::string list = fmt::format("planners are {}", fmt::join(taken, ", "));
    if (!guide_.planner) {
      if (!of_ompl) return;
      diagnostics_.error("G08", guide_.kind.span,
                         "ompl needs the name of a planner in quotes, as ompl \"RRTConnect\"",
                         list);
      return;
    }
    const syntax::String& name = *guide_.planner;
    if (!of_ompl) {
      diagnostics_.error("G08", name.span,
                         fmt::format("{} takes no name of a planner", guide_.kind.text),
                         "leave it out, or write ompl");
      return;
    }
    const ompl_bridge::OmplPlanner* const planner = ompl_bridge::find_ompl_planner(name.text);
    if (planner == nullptr) {
      diagnostics_.error("G08", name.span,
                         fmt::format("OMPL has no geometric planner '{}'{}", name.text,
                                     suggestion(name.text, taken)),
                         list);
    } else if (!planner->taken()) {
      diagnostics_.error(
          "G08", name.span,
          fmt::format("guides do not take {} of OMPL: {}", name.text, planner->refusal), list);
    }
    spec_.planner = name.text;
  }

  /// set "goal_bias" 0.1;
  void check_setting(const syntax::GuideClause& clause) {
    if (spec_.kind != guides::GuideKind::ompl) {
      report_unknown(clause, true);
      return;
    }
    const syntax::String& name = *clause.setting;
    const auto names = ompl_bridge::parameters_of(*ompl_bridge::find_ompl_planner(spec_.planner));
    if (std::find(names.begin(), names.end(), name.text) == names.end()) {
      diagnostics_.error(
          "G02", name.span,
          fmt::format("{} of OMPL has no parameter '{}'{}", spec_.planner, name.text,
                      suggestion(name.text, names)),
          names.empty() ? "it has none" : fmt::format("it has {}", fmt::join(names, ", ")));
      return;
    }
    if (!check_unit(*clause.number, UnitKind::none, name.text.c_str(), diagnostics_)) return;
    const double value = clause.number->value;
    const ompl_bridge::Setting bounds = ompl_bridge::setting_of(name.text);
    if (!(value >= bounds.least && value <= bounds.most)) {
      diagnostics_.error("G03", clause.number->span,
                         fmt::format("{} must be from {:g} to {:g}, found {:.16g}", name.text,
                                     bounds.least, bounds.most, value));
      return;
    }
    spec_.settings.emplace_back(name.text, value);
  }

  void check_clause(const syntax::GuideClause& clause) {
    // One without anything in it did not parse: that was said.
    if (!clause.number && clause.values.empty() && clause.words.empty() && !clause.condition) {
      return;
    }
    const std::string key = clause.setting
                                ? fmt::format("{} \"{}\"", clause.key.text, clause.setting->text)
                                : clause.key.text;
    const auto [place, is_new] = given_.emplace(key, clause.key.span);
    if (!is_new) {
      Diagnostic twice;
      twice.code = "G02";
      twice.span = clause.key.span;
      twice.message = fmt::format("{} is given twice", key);
      twice.notes.push_back({place->second, "first given here"});
      diagnostics_.add(std::move(twice));
      return;
    }
    if (clause.key.text == guides::kKeepClause) return;
    if (clause.setting) {
      if (clause.number) check_setting(clause);
      return;
    }
    if (clause.thinking) {
      check_thinking(clause);
      return;
    }
    if (clause.key.text == guides::kWeightClause) {
      if (!clause.values.empty()) return;
      diagnostics_.error("G03", clause.number ? clause.number->span : clause.words.front().span,
                         "weight needs parameters of the robot",
                         "for example weight x 20, boom.phi 2;");
      return;
    }
    if (clause.key.text == guides::kOverClause) {
      if (!guides::has_over(spec_.kind)) {
        report_unknown(clause, true);
      } else if (clause.words.empty()) {
        diagnostics_.error("G03", place_of(clause), "over needs parameters of the robot",
                           "for example over boom.phi, stick.phi;");
      }
      return;
    }
    if (const guides::ChoiceInfo* const choice = guides::find_choice(clause.key.text)) {
      if (choice->is_of(spec_.kind)) {
        check_choice(*choice, clause);
      } else {
        report_unknown(clause, true);
      }
      return;
    }
    const ClauseInfo* const info = guides::find_clause(clause.key.text);
    if (info == nullptr || !info->is_of(spec_.kind)) {
      report_unknown(clause, info != nullptr);
      return;
    }
    if (!clause.number) {
      diagnostics_.error("G03", place_of(clause), fmt::format("{} takes one number", info->name));
      return;
    }
    check_number(*info, *clause.number);
  }

  /// Where the first thing behind the word of a clause stands.
  static Span place_of(const syntax::GuideClause& clause) {
    if (clause.number) return clause.number->span;
    return clause.words.empty() ? clause.values.front().parameter.span : clause.words.front().span;
  }

  void check_choice(const guides::ChoiceInfo& choice, const syntax::GuideClause& clause) {
    const std::vector<std::string> words(choice.words.begin(), choice.words.end());
    const std::string list = fmt::format("{}", fmt::join(words, ", "));
    if (clause.words.size() != 1) {
      diagnostics_.error("G03", place_of(clause),
                         fmt::format("{} takes one of the words {}", choice.name, list));
      return;
    }
    const std::string word = clause.words.front().text();
    const auto found = std::find(words.begin(), words.end(), word);
    if (found == words.end()) {
      diagnostics_.error("G03", clause.words.front().span,
                         fmt::format("{} is one of {}, found '{}'{}", choice.name, list, word,
                                     suggestion(word, words)));
      return;
    }
    choice.choose(spec_, static_cast<std::size_t>(found - words.begin()));
  }

  void check_thinking(const syntax::GuideClause& clause) {
    spec_.thinks = *clause.thinking;
    if (spec_.thinks <= guides::kMostThinking) return;
    diagnostics_.error("G03", clause.number->span,
                       fmt::format("a check may take at most {} s, found {:.16g} s",
                                   guides::kMostThinking, spec_.thinks),
                       "for example thinks 20 us per check;");
  }

  /// Of a vehicle that steers: what knows nothing of arcs.
  void check_steering() {
    if (!(spec_.turn_radius > 0) || !(spec_.safety > 0)) return;
    diagnostics_.error("G03", given_.at("safety"),
                       "with a turn_radius there is no safety: no lattice that has arcs knows it",
                       "leave one of them out");
  }

  void warn_of_heuristic() {
    if (guides::is_admissible(spec_)) return;
    diagnostics_.warning("G06", given_.at("heuristic"),
                         "manhattan is more than the way where several parameters change at once: "
                         "the way found may not be the cheapest",
                         "take octile, or neighbours straight");
  }

  void report_unknown(const syntax::GuideClause& clause, bool of_another_kind) {
    std::vector<std::string> names{guides::kWeightClause, guides::kKeepClause,
                                   guides::kThinksClause};
    std::string list = fmt::format("{}, {}, {}", guides::kWeightClause, guides::kKeepClause,
                                   guides::kThinksClause);
    const auto add = [&](const char* name) {
      names.emplace_back(name);
      list += fmt::format(", {}", name);
    };
    for (const ClauseInfo& info : guides::guide_clauses()) {
      if (info.is_of(spec_.kind)) add(info.name);
    }
    for (const guides::ChoiceInfo& info : guides::guide_choices()) {
      if (info.is_of(spec_.kind)) add(info.name);
    }
    if (guides::has_over(spec_.kind)) add(guides::kOverClause);
    if (spec_.kind == guides::GuideKind::ompl) add(guides::kSetClause);
    diagnostics_.error(
        "G02", clause.key.span,
        of_another_kind ? fmt::format("{} has no clause '{}'", guide_.kind.text, clause.key.text)
                        : fmt::format("unknown clause '{}' of a guide{}", clause.key.text,
                                      suggestion(clause.key.text, names)),
        why_no_arcs(clause) + fmt::format("clauses of {} are {}", guide_.kind.text, list));
  }

  /// Of a kind without turn_radius: why.
  std::string why_no_arcs(const syntax::GuideClause& clause) const {
    if (clause.key.text != "turn_radius") return {};
    const char* const instead = "take rrt_connect, astar, drrt or prm; ";
    if (spec_.kind == guides::GuideKind::rrt_limcon) {
      return std::string("it moves one parameter at a time, and an arc moves three: ") + instead;
    }
    return guides::has_over(spec_.kind)
               ? std::string("arcs do not lead from node to node of its lattice: ") + instead
               : std::string();
  }

  void check_number(const ClauseInfo& info, const syntax::Number& number) {
    const bool angle = number.unit == UnitKind::angle && std::string_view(info.name) == "step";
    const UnitKind unit = info.is_length ? UnitKind::length : UnitKind::none;
    if (!angle && !check_unit(number, unit, info.name, diagnostics_)) return;
    const double value = number.value;
    const bool whole = !info.whole || value == std::floor(value);
    if (!(value >= info.least && value <= info.most) || !whole) {
      diagnostics_.error(
          "G03", number.span,
          fmt::format("{} must be {} from {:.16g} to {:.16g}, found {:.16g}", info.name,
                      info.whole ? "a whole number" : "a number", info.least, info.most, value));
      return;
    }
    spec_.*info.value = value;
  }

  const syntax::GuideDeclaration& guide_;
  Diagnostics& diagnostics_;
  guides::GuideSpec spec_;
  std::map<std::string, Span> given_;
};

guides::Leg leg_of(const robot::RobotModel& robot) {
  robot::Mounting mounting;
  mounting.starts = robot.start_values();
  return {robot, mounting};
}

/// The parameters that `over` names.
void resolve_over(const syntax::GuideClause& clause, const robot::RobotModel& robot,
                  guides::GuideSpec& spec, Diagnostics& diagnostics) {
  const guides::Leg leg = leg_of(robot);
  for (const syntax::QualifiedName& word : clause.words) {
    const int parameter = resolve_parameter(robot, -1, word);
    const char* wrong = nullptr;
    const std::vector<int>& all = leg.parameters();
    if (parameter < 0) {
      wrong = parameter == -2 ? "a parameter of several bodies" : "no parameter";
    } else if (std::find(all.begin(), all.end(), parameter) == all.end()) {
      wrong = "no parameter that a leg changes";
    } else if (std::find(spec.over.begin(), spec.over.end(), parameter) != spec.over.end()) {
      diagnostics.error("G03", word.span, fmt::format("'{}' is named twice", word.text()));
      continue;
    }
    if (wrong != nullptr) {
      diagnostics.error("G03", word.span,
                        fmt::format("'{}' is {} of robot '{}'", word.text(), wrong, robot.name));
      continue;
    }
    spec.over.push_back(parameter);
  }
}

/// Whether a lattice can span what it shall: G07. That of a vehicle spans its place.
void check_spanned(const syntax::GuideDeclaration& guide, const robot::RobotModel& robot,
                   const guides::GuideSpec& spec, Diagnostics& diagnostics) {
  if (guides::is_travel(spec.kind) && !guides::Vehicle(robot, {}).travels()) {
    diagnostics.error("G07", guide.kind.span,
                      fmt::format("{} is for machines that travel, and no body of '{}' has "
                                  "parameters x and y",
                                  guides::name_of(spec.kind), robot.name));
  }
  const guides::Leg leg = leg_of(robot);
  if (spec.turn_radius > 0 && leg.heading() < 0) {
    diagnostics.error("G07", guide.kind.span,
                      fmt::format("turn_radius is for vehicles, and robot '{}' drives along no "
                                  "heading that it can turn",
                                  robot.name),
                      "leave turn_radius out");
    return;
  }
  if (!guides::has_over(spec.kind)) return;
  const std::string kind = guides::name_of(spec.kind);
  if (leg.heading() >= 0) {
    if (spec.over.empty()) return;
    diagnostics.error(
        "G07", guide.kind.span,
        fmt::format("{} spans the place of a vehicle such as '{}', nothing else", kind, robot.name),
        "leave over out");
    return;
  }
  const std::size_t count = spec.over.empty() ? leg.parameters().size() : spec.over.size();
  if (count <= guides::kMostSpanned) return;
  diagnostics.error(
      "G07", guide.kind.span,
      fmt::format("{} spans at most {} parameters, and here robot '{}' has {}", kind,
                  guides::kMostSpanned, robot.name, count),
      "name some of them: over boom.phi, stick.phi; the others change in the last leg");
}

}  // namespace

std::optional<guides::GuideSpec> check_guide(const syntax::GuideDeclaration& guide,
                                             Diagnostics& diagnostics) {
  return ClauseChecker(guide, diagnostics).check();
}

bool resolve_parameters(const syntax::GuideDeclaration& guide, const robot::RobotModel& robot,
                        guides::GuideSpec& spec, Diagnostics& diagnostics) {
  const int errors = diagnostics.errors();
  for (const syntax::GuideClause& clause : guide.clauses) {
    if (clause.condition) {
      resolve_keep(*clause.condition, robot, spec.keep, diagnostics);
      continue;
    }
    if (clause.key.text == guides::kOverClause) resolve_over(clause, robot, spec, diagnostics);
    if (clause.key.text != guides::kWeightClause) continue;
    for (const syntax::GuideClause::Value& value : clause.values) {
      const int parameter = resolve_parameter(robot, -1, value.parameter);
      if (parameter < 0) {
        diagnostics.error(
            "G03", value.parameter.span,
            fmt::format("'{}' is {} of robot '{}'", value.parameter.text(),
                        parameter == -2 ? "a parameter of several bodies" : "no parameter",
                        robot.name));
        continue;
      }
      if (!check_unit(value.number, UnitKind::none, "weight", diagnostics)) continue;
      if (!(value.number.value >= kLeastWeight && value.number.value <= kMostWeight)) {
        diagnostics.error("G03", value.number.span,
                          fmt::format("a weight must be from {} to {}, found {}", kLeastWeight,
                                      kMostWeight, value.number.value));
        continue;
      }
      spec.weights.emplace_back(parameter, value.number.value);
    }
  }
  if (diagnostics.errors() == errors) check_spanned(guide, robot, spec, diagnostics);
  return diagnostics.errors() == errors;
}

bool check_guided_robot(const robot::RobotModel& robot, Span span, Diagnostics& diagnostics) {
  robot::Mounting mounting;
  mounting.starts = robot.start_values();
  const guides::Leg leg(robot, mounting);
  if (!leg.refusal().empty()) {
    diagnostics.error("G04", span,
                      fmt::format("robot '{}' cannot be guided: {}", robot.name, leg.refusal()));
    return false;
  }
  for (const int index : leg.parameters()) {
    const robot::Parameter& p = robot.parameters[static_cast<std::size_t>(index)];
    if (p.cyclic || (std::isfinite(p.lower) && std::isfinite(p.upper))) continue;
    diagnostics.error("G04", span,
                      fmt::format("robot '{}' cannot be guided: {} has no range to look for a way "
                                  "in",
                                  robot.name, p.display_name),
                      fmt::format("add range(...) to param {} in the robot file", p.name));
    return false;
  }
  return true;
}

void GuideDeclarations::declare(const syntax::GuideDeclaration& guide, Diagnostics& diagnostics) {
  const auto [place, is_new] = by_name_.emplace(guide.name.text, &guide);
  if (is_new) return;
  Diagnostic twice;
  twice.code = "G05";
  twice.span = guide.name.span;
  twice.message = fmt::format("guide '{}' is declared twice", guide.name.text);
  twice.notes.push_back({place->second->name.span, "first declared here"});
  diagnostics.add(std::move(twice));
}

const syntax::GuideDeclaration* GuideDeclarations::find(const std::string& name) const {
  const auto found = by_name_.find(name);
  return found == by_name_.end() ? nullptr : found->second;
}

std::vector<std::string> GuideDeclarations::names() const {
  std::vector<std::string> names;
  for (const auto& [name, guide] : by_name_) names.push_back(name);
  return names;
}

}  // namespace rubicon::interpreter
