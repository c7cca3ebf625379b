#include <fmt/format.h>

#include "interpreter/check/check_plan_parts.hpp"

namespace rubicon::interpreter::plan_check {

namespace {

using syntax::UnitKind;

/// Largest amount of money; more is a slip of the pen.
constexpr double kMaxMoney = 1e12;

/// Largest factor for overtime.
constexpr double kMaxFactor = 100;

std::optional<schedule::Date> resolve_date(Subject& subject, const syntax::String& written) {
  const auto date = schedule::parse_date(written.text);
  if (!date) {
    subject.error(
        "P10", written.span,
        fmt::format("expected a date such as \"2026-03-02\", found \"{}\"", written.text));
  }
  return date;
}

void resolve_rental(Subject& subject, const syntax::Rental& rental, const std::string& who,
                    Charges& charges) {
  charges.rental_per_day = resolve_money(subject, rental.amount, "the rental of " + who);
  if (!rental.from || !rental.to) return;
  const auto from = resolve_date(subject, *rental.from);
  const auto to = resolve_date(subject, *rental.to);
  if (!from || !to) return;
  if (schedule::days_from_date(*to) < schedule::days_from_date(*from)) {
    subject.error("P10", rental.to->span,
                  fmt::format("the rental of {} ends before it begins", who));
    return;
  }
  charges.rental_days.emplace(*from, *to);
}

}  // namespace

std::optional<double> resolve_money(Subject& subject, const syntax::Number& amount,
                                    const std::string& what) {
  return bounded(subject, amount, UnitKind::none, what, 0, kMaxMoney);
}

Charges resolve_charges(Subject& subject, const syntax::Charges& written, const std::string& who) {
  Charges charges;
  const auto rental_span = [](const syntax::Rental& rental) { return rental.span; };
  const auto number_span = [](const syntax::Number& number) { return number.span; };
  const auto overtime_span = [](const syntax::Overtime& overtime) { return overtime.span; };
  if (const auto* rental = only_one(subject, written.rental, "the rental of " + who, rental_span)) {
    resolve_rental(subject, *rental, who, charges);
  }
  if (const auto* amount =
          only_one(subject, written.mobilisation, "mobilisation of " + who, number_span)) {
    charges.mobilisation = resolve_money(subject, *amount, "mobilisation of " + who);
  }
  if (const auto* overtime =
          only_one(subject, written.overtime, "overtime of " + who, overtime_span)) {
    const auto factor = bounded(subject, overtime->factor, UnitKind::none,
                                "the overtime factor of " + who, 1, kMaxFactor);
    if (factor) charges.overtime = *factor;
    if (overtime->outside && subject.find(subject.calendars, *overtime->outside, "calendar") >= 0) {
      charges.normal = overtime->outside->text;
    }
  }
  return charges;
}

}  // namespace rubicon::interpreter::plan_check
