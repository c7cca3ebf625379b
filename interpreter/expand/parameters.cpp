#include "interpreter/expand/parameters.hpp"

#include <fmt/format.h>

#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "interpreter/expand/evaluate.hpp"
#include "interpreter/expand/plain_items.hpp"
#include "interpreter/parse/parse.hpp"

namespace rubicon::interpreter::expansion {

namespace {

/// stock_1 of stock[1], stock_2_5 of stock[2, 5]. Brackets with anything else in them stay.
std::string without_brackets(std::string_view name) {
  std::string plain;
  for (std::size_t at = 0; at < name.size(); ++at) {
    const std::size_t end = name[at] == '[' ? name.find(']', at) : std::string_view::npos;
    const std::string_view indices =
        end == std::string_view::npos ? "[" : name.substr(at + 1, end - at - 1);
    if (indices.find_first_not_of("0123456789, ") != std::string_view::npos) {
      plain += name[at];
      continue;
    }
    plain += '_';
    for (const char c : indices) {
      if (c != ' ') plain += c == ',' ? '_' : c;
    }
    at = end;
  }
  return plain;
}

class Evaluator {
 public:
  Evaluator(Scope& scope, Diagnostics& diagnostics, const OnImport& on_import)
      : scope_(scope), diagnostics_(diagnostics), on_import_(on_import) {}

  void take(const ParameterTexts& set) {
    for (const auto& [given, text] : set) {
      const std::string name = without_brackets(given);
      if (!set_.emplace(name, text).second) {
        diagnostics_.error("P27", {}, fmt::format("--set {} is given twice", name));
      }
    }
  }

  void run(const syntax::Plan& plan) {
    for (const syntax::PlanItem& each : plan.items) {
      const auto* item = std::get_if<syntax::PlanParameter>(&each);
      if (item != nullptr) scope_.later.emplace(item->name.text, item->name.span);
    }
    for (const syntax::PlanItem& each : plan.items) {
      if (const auto* item = std::get_if<syntax::PlanParameter>(&each)) declare(*item);
      if (const auto* item = std::get_if<syntax::ImportItem>(&each))
        on_import_(*item, set_of(*item));
    }
    scope_.later.clear();
    for (const auto& [name, text] : set_) {
      if (scope_.parameters.count(name) != 0 || plan.broken) continue;
      const std::string whole = scope_.prefix + name;
      diagnostics_.error("P27", {},
                         fmt::format("--set {}={}: the plan has no parameter '{}'{}", whole, text,
                                     whole, near_whole_name(name)));
    }
  }

 private:
  /// What is set of an imported plan: `yard.bays` is its `bays`.
  ParameterTexts set_of(const syntax::ImportItem& item) const {
    ParameterTexts result;
    if (!item.as) return result;
    const std::string prefix = item.as->text + ".";
    for (const auto& [name, text] : set_) {
      if (name.starts_with(prefix)) result.emplace_back(name.substr(prefix.size()), text);
    }
    return result;
  }

  /// "; did you mean yard.pitch?": one of that name in a plan that is imported, else the nearest.
  std::string near_whole_name(const std::string& name) {
    std::vector<std::string> all;
    for (const auto& [each, parameter] : scope_.parameters) {
      all.push_back(scope_.prefix + each);
      if (each.ends_with("." + name)) return "; did you mean " + all.back() + "?";
    }
    return scope_.suggestions.ending(scope_.prefix + name, [&] { return all; });
  }

  void declare(const syntax::PlanParameter& item) {
    const std::optional<std::string> plain = plain_name(item.name, scope_, diagnostics_);
    if (!plain) return;
    const std::string& name = *plain;
    const auto known = scope_.parameters.find(name);
    if (known != scope_.parameters.end()) {
      Diagnostic diagnostic;
      diagnostic.code = "P02";
      diagnostic.span = item.name.span;
      diagnostic.message = fmt::format("parameter '{}' is declared twice", name);
      diagnostic.notes.push_back({known->second.span, "first given here"});
      diagnostics_.add(std::move(diagnostic));
      return;
    }
    std::optional<Value> value;
    if (item.value) {
      value = evaluate_number(*item.value, scope_, diagnostics_);
    } else if (syntax::PlanParameter text = item;
               PlainItems(scope_, diagnostics_).make_plain(text)) {
      value.emplace();
      value->kind = Value::Kind::text;
      value->text = std::move(text.text.text);
    }
    const auto given = set_.find(name);
    if (value && given != set_.end()) value = changed(name, *value, given->second);
    scope_.parameters.emplace(name, Parameter{std::move(value), item.name.span});
    scope_.later.erase(name);
  }

  /// What --set makes of a value.
  std::optional<Value> changed(const std::string& name, const Value& value,
                               const std::string& text) {
    if (value.kind == Value::Kind::text) {
      Value result = value;
      result.text = text;
      return result;
    }
    std::optional<Value> given = number_of(text);
    const std::string asked = fmt::format("--set {}{}={}: ", scope_.prefix, name, text);
    if (!given) {
      diagnostics_.error("P27", {}, asked + "expected a number, such as 6 or \"3.5 m\"");
      return std::nullopt;
    }
    if (given->dimension == value.dimension) return given;
    if (given->dimension.is_bare() && dimension_has_base(value.dimension)) {
      Value result = value;
      result.number = given->number;
      return result;
    }
    diagnostics_.error(
        "P27", {},
        fmt::format("{}the parameter is {}, found {}", asked, kind_text(value), kind_text(*given)));
    return std::nullopt;
  }

  static bool dimension_has_base(syntax::Dimension dimension) {
    return unit_kind(dimension) != syntax::UnitKind::per_hour &&
           unit_kind(dimension) != syntax::UnitKind::compound;
  }

  /// A number in a text, by the rules of the language.
  static std::optional<Value> number_of(const std::string& text) {
    if (text.find_first_of(";{}\"#\n\r") != std::string::npos) return std::nullopt;
    SourceMap sources;
    Diagnostics mistakes;
    const FileId file = sources.add("--set", "plan p { parameter x = " + text + "; }");
    const syntax::Plan plan = parse_plan(sources, file, mistakes);
    if (mistakes.has_errors() || plan.items.size() != 1) return std::nullopt;
    const auto* item = std::get_if<syntax::PlanParameter>(&plan.items.front());
    if (item == nullptr || !item->value) return std::nullopt;
    Scope nothing;
    return evaluate_number(*item->value, nothing, mistakes);
  }

  Scope& scope_;
  Diagnostics& diagnostics_;
  const OnImport& on_import_;
  std::map<std::string, std::string> set_;
};

}  // namespace

void evaluate_parameters(const syntax::Plan& plan, const ParameterTexts& set, Scope& scope,
                         Diagnostics& diagnostics, const OnImport& on_import) {
  Evaluator evaluator(scope, diagnostics, on_import);
  evaluator.take(set);
  evaluator.run(plan);
}

}  // namespace rubicon::interpreter::expansion
