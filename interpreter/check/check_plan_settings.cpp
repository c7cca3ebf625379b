#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "interpreter/check/check_number.hpp"
#include "interpreter/check/check_plan_parts.hpp"

namespace rubicon::interpreter::plan_check {

namespace {

using syntax::UnitKind;

/// Largest contact tolerance, in m: more would let whole panels through each other.
constexpr double kMaxContact = 0.1;

/// Largest budget: attempts are counted in 64 bits and shown as whole numbers of a double.
constexpr double kMaxBudget = 1e15;

class Settings {
 public:
  explicit Settings(Subject& subject) : subject_(subject) {}

  void number(const syntax::NumberItem& item) {
    if (!first_of(item.name)) return;
    if (item.name.text == "contact") {
      const auto value = bounded(subject_, item.value, UnitKind::length, "contact", 0, kMaxContact);
      if (value) subject_.model.contact = *value;
    } else if (item.name.text == "budget") {
      const auto value = resolve_budget(subject_, item.value);
      if (value) subject_.model.budget = *value;
    } else {
      unknown(item.name);
    }
  }

  void whole(const syntax::WholeItem& item) {
    if (!first_of({"whole", item.span})) return;
    if (const auto value = resolve_whole(subject_, item)) subject_.model.whole = *value;
  }

  void string(const syntax::StringItem& item) {
    if (!first_of(item.name)) return;
    const std::string& text = item.value.text;
    if (item.name.text == "start_at") {
      subject_.use("start_at", item.span);
      if (const auto time = resolve_civil_time(subject_, item.value)) {
        subject_.model.start_at = *time;
      }
    } else if (item.name.text == "currency") {
      subject_.use("currency", item.span);
      if (text.empty()) {
        subject_.error("P09", item.value.span,
                       "expected a currency such as \"EUR\", found nothing");
      }
      subject_.model.currency = text;
    } else {
      unknown(item.name);
    }
  }

 private:
  bool first_of(const syntax::Name& name) {
    const auto [place, is_new] = given_.emplace(name.text, name.span);
    if (!is_new) subject_.twice(name.span, name.text + " is given twice", place->second);
    return is_new;
  }

  void unknown(const syntax::Name& name) {
    static const std::map<std::string, int> kSettings = {
        {"contact", 0}, {"budget", 0}, {"start_at", 0}, {"currency", 0}};
    subject_.unknown(name.span, "setting", name.text, {&kSettings});
  }

  Subject& subject_;
  std::map<std::string, Span> given_;
};

/// A limit, or what was found, as one reads it: 1e8 s is 27777.8 h.
std::string limit_text(double value, UnitKind unit) {
  if (unit != UnitKind::time) return fmt::format("{}", value);
  return std::abs(value) < 3600 ? fmt::format("{} s", value)
                                : fmt::format("{:.1f} h", value / 3600);
}

}  // namespace

std::optional<double> bounded(Subject& subject, const syntax::Number& number, UnitKind unit,
                              const std::string& what, double lowest, double highest) {
  if (!check_unit(number, unit, what, subject.diagnostics)) return std::nullopt;
  if (number.value >= lowest && number.value <= highest) return number.value;
  subject.error(
      "P09", number.span,
      number.value < lowest && lowest == 0
          ? fmt::format("{} cannot be negative, found {}", what, number.value)
          : fmt::format("{} must be between {} and {}, found {}", what, limit_text(lowest, unit),
                        limit_text(highest, unit), limit_text(number.value, unit)));
  return std::nullopt;
}

std::optional<double> resolve_budget(Subject& subject, const syntax::Number& number) {
  if (!check_unit(number, UnitKind::none, "budget", subject.diagnostics)) return std::nullopt;
  const double value = number.value;
  if (value >= 1 && value <= kMaxBudget && std::floor(value) == value) return value;
  subject.error("P09", number.span,
                fmt::format("budget is a whole number of attempts from 1 on, found {}", value));
  return std::nullopt;
}

namespace {

/// The shapes of the storage place, which has one or several.
std::vector<geometry::Shape>& storage_of(PlanModel& model, const std::string& name) {
  const auto found = std::find_if(model.storages.begin(), model.storages.end(),
                                  [&](const StorageSpec& each) { return each.name == name; });
  if (found != model.storages.end()) return found->shapes;
  return model.storages.emplace_back(StorageSpec{name, {}}).shapes;
}

}  // namespace

void check_settings(Subject& subject) {
  Settings settings(subject);
  for (const syntax::PlanItem& each : subject.plan.items) {
    if (const auto* number = std::get_if<syntax::NumberItem>(&each)) {
      settings.number(*number);
    } else if (const auto* string = std::get_if<syntax::StringItem>(&each)) {
      settings.string(*string);
    } else if (const auto* whole = std::get_if<syntax::WholeItem>(&each)) {
      settings.whole(*whole);
    } else if (const auto* situation = std::get_if<syntax::SituationItem>(&each)) {
      for (const syntax::Name& name : situation->names) {
        subject.model.situations.push_back(name.text);
      }
    } else if (const auto* overhead = std::get_if<syntax::OverheadItem>(&each)) {
      if (subject.model.overhead_per_day) {
        subject.error("P02", overhead->span, "overhead is given twice");
      }
      subject.use("overhead", overhead->span);
      subject.model.overhead_per_day = resolve_money(subject, overhead->amount, "overhead");
    } else if (const auto* site = std::get_if<syntax::SiteItem>(&each)) {
      std::optional<geometry::Shape> shape = subject.shapes.resolve(site->shape);
      if (shape) subject.model.site.push_back(*std::move(shape));
    } else if (const auto* storage = std::get_if<syntax::StorageItem>(&each)) {
      std::optional<geometry::Shape> shape = subject.shapes.resolve(storage->shape);
      if (shape) storage_of(subject.model, storage->name.text).push_back(*std::move(shape));
    }
  }
}

}  // namespace rubicon::interpreter::plan_check
