#include <fmt/format.h>

#include <cmath>

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

/// Most litres an hour, and the most that one may cost.
constexpr double kMaxLitres = 1e6;
constexpr double kMaxLitrePrice = 1e6;
constexpr const char* kFuelExample = "fuel 18 l per h idling 4 l per h price 1.70 per l;";

/// A number of a dimension in units of which there are `factor` in one of SI, without what the
/// change of units rounds.
std::optional<double> in_fuel_unit(Subject& subject, const syntax::Number& number,
                                   syntax::Dimension dimension, double factor, double most,
                                   const std::string& what) {
  const char* const unit = dimension.length > 0 ? "litres per h" : "money per litre";
  if (number.dimension != dimension) {
    subject.error("F09", number.span,
                  fmt::format("{} needs {}, but the value is {}", what, unit,
                              syntax::dimension_text(number.dimension)),
                  fmt::format("write for example {}", kFuelExample));
    return std::nullopt;
  }
  constexpr double kPlaces = 1e6;
  const double value = std::round(number.value * factor * kPlaces) / kPlaces;
  if (value >= 0 && value <= most) return value;
  subject.error("P09", number.span,
                value < 0 ? fmt::format("{} cannot be negative, found {} {}", what, value, unit)
                          : fmt::format("{} is at most {} {}, found {}", what, most, unit, value));
  return std::nullopt;
}

std::optional<FuelUse> resolve_fuel(Subject& subject, const syntax::Fuel& written,
                                    const std::string& who) {
  const auto flow = [&](const syntax::Number& number, const std::string& what) {
    constexpr double kLitresPerHour = 3.6e6;  // in a m3 per s
    return in_fuel_unit(subject, number, {3, 0, -1, 0}, kLitresPerHour, kMaxLitres, what);
  };
  FuelUse fuel;
  const auto working = flow(written.working, "the fuel of " + who);
  if (working) fuel.working = *working;
  if (written.idling) {
    fuel.idling = flow(*written.idling, "what " + who + " burns idling").value_or(0);
  }
  if (written.price) {
    fuel.price = in_fuel_unit(subject, *written.price, {-3, 0, 0, 0}, 1e-3, kMaxLitrePrice,
                              "the price of the fuel of " + who);
  }
  if (working && written.idling && fuel.idling > fuel.working) {
    subject.error("P09", written.idling->span,
                  fmt::format("{} burns {} litres per h idling, which is more than the {} at work",
                              who, fuel.idling, fuel.working));
  }
  return working ? std::optional(fuel) : std::nullopt;
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
  const auto fuel_span = [](const syntax::Fuel& fuel) { return fuel.span; };
  if (const auto* fuel = only_one(subject, written.fuel, "the fuel of " + who, fuel_span)) {
    charges.fuel = resolve_fuel(subject, *fuel, who);
  }
  return charges;
}

}  // namespace rubicon::interpreter::plan_check
