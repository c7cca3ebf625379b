#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "interpreter/check/check_plan_parts.hpp"

namespace rubicon::interpreter::plan_check {

namespace {

constexpr std::array<std::string_view, 7> kWeek = {"mon", "tue", "wed", "thu", "fri", "sat", "sun"};

/// 0 for mon ... 6 for sun.
std::optional<int> day_of(Subject& subject, const syntax::Name& name) {
  const auto day = std::find(kWeek.begin(), kWeek.end(), name.text);
  if (day != kWeek.end()) return static_cast<int>(day - kWeek.begin());
  const std::string nearest =
      did_you_mean(name.text, {"mon", "tue", "wed", "thu", "fri", "sat", "sun"});
  subject.error("P11", name.span,
                fmt::format("expected a day (mon, tue, wed, thu, fri, sat, sun), found '{}'{}",
                            name.text, nearest.empty() ? "" : "; did you mean " + nearest + "?"));
  return std::nullopt;
}

std::optional<int> time_of(Subject& subject, const syntax::String& text) {
  const std::optional<int> minutes = schedule::parse_minute_of_day(text.text);
  if (!minutes) {
    subject.error("P10", text.span,
                  fmt::format("expected a time between 00:00 and 24:00, found '{}'", text.text));
  }
  return minutes;
}

void check_off_days(Subject& subject, const syntax::Shift& shift, CalendarSpec& calendar) {
  for (const syntax::String& date : shift.off) {
    if (const auto day = schedule::parse_date(date.text)) {
      calendar.off.push_back(*day);
    } else {
      subject.error("P10", date.span,
                    fmt::format("expected a date such as 2026-12-25, found '{}'", date.text));
    }
  }
}

/// 0 for jan ... 11 for dec: the grammar knows no other.
int month_of(const syntax::Name& name) {
  constexpr std::array<std::string_view, 12> kMonths = {"jan", "feb", "mar", "apr", "may", "jun",
                                                        "jul", "aug", "sep", "oct", "nov", "dec"};
  return static_cast<int>(std::find(kMonths.begin(), kMonths.end(), name.text) - kMonths.begin());
}

/// The share of a calendar's days that the weather takes, in some months or in all that have none
/// of their own.
class LostDaysCheck {
 public:
  explicit LostDaysCheck(Subject& subject) : subject_(subject) {}

  void take(const syntax::Shift& shift) {
    const std::string what = "the share of lost days";
    const auto share = bounded(subject_, *shift.lost, syntax::UnitKind::none, what, 0, kMostLost);
    if (!shift.first_month) {
      if (any_) subject_.twice(shift.span, what + " is given twice", *any_);
      any_ = shift.span;
      for (int i = 0; i < 12; ++i) {
        if (!given_[month(i)]) lost_[month(i)] = share.value_or(0);
      }
      return;
    }
    const int first = month_of(*shift.first_month);
    const int last = shift.last_month ? month_of(*shift.last_month) : first;
    for (int i = first;; i = (i + 1) % 12) {
      if (given_[month(i)]) {
        subject_.twice(shift.span, what + " of a month is given twice", *given_[month(i)]);
        return;
      }
      given_[month(i)] = shift.span;
      lost_[month(i)] = share.value_or(0);
      if (i == last) return;
    }
  }
  const schedule::LostShares& shares() const { return lost_; }

 private:
  /// A calendar that loses more of its days is hardly one to plan by.
  static constexpr double kMostLost = 0.95;
  static std::size_t month(int i) { return static_cast<std::size_t>(i); }

  Subject& subject_;
  schedule::LostShares lost_ = {};
  std::array<std::optional<Span>, 12> given_ = {};
  std::optional<Span> any_;
};

/// A shift over midnight, in the lines that it has to be.
std::string night_hint(std::optional<int> first, std::optional<int> last, std::string_view from,
                       std::string_view to) {
  constexpr const char* kText = "split a night shift at 24:00";
  if (!first || !last || *last < *first) return kText;
  const auto days = [](int from_day, int to_day) {
    const std::string_view first_name = kWeek[static_cast<std::size_t>(from_day)];
    const std::string_view last_name = kWeek[static_cast<std::size_t>(to_day)];
    return from_day == to_day ? std::string(first_name)
                              : fmt::format("{}-{}", first_name, last_name);
  };
  std::string lines = fmt::format("{} {}-24:00;", days(*first, *last), from);
  if (*first == 0 && *last == 6) {
    lines += fmt::format(" {} 00:00-{};", days(0, 6), to);
  } else if (to != "00:00") {
    if (*last == 6) lines += fmt::format(" {} 00:00-{};", days(0, 0), to);
    if (*first < 6)
      lines += fmt::format(" {} 00:00-{};", days(*first + 1, std::min(*last + 1, 6)), to);
  }
  return fmt::format("{}: {}", kText, lines);
}

void check_shift(Subject& subject, const syntax::Shift& shift, CalendarSpec& calendar) {
  const std::optional<int> first = day_of(subject, shift.first_day);
  const std::optional<int> last = shift.last_day ? day_of(subject, *shift.last_day) : first;
  if (first && last && *last < *first) {
    subject.error("P11", shift.last_day->span,
                  fmt::format("the days go from {} to {}; expected the order of the week from mon "
                              "to sun",
                              shift.first_day.text, shift.last_day->text),
                  "write two lines");
  }
  CalendarSpec::Shift result;
  result.first_day = first.value_or(0);
  result.last_day = last.value_or(6);
  int end = 0;
  for (const auto& [from_text, to_text] : shift.times) {
    const std::optional<int> from = time_of(subject, from_text);
    const std::optional<int> to = time_of(subject, to_text);
    if (!from || !to) continue;
    if (*to <= *from) {
      subject.error(
          "P11", to_text.span,
          fmt::format("this shift ends at {} and begins at {}", to_text.text, from_text.text),
          night_hint(first, last, from_text.text, to_text.text));
    } else if (*from < end) {
      subject.error("P11", from_text.span,
                    fmt::format("the shifts of a day follow each other: this one begins at {}, "
                                "before the one before it ends",
                                from_text.text));
    } else {
      end = *to;
      result.minutes.emplace_back(*from, *to);
    }
  }
  calendar.shifts.push_back(std::move(result));
}

}  // namespace

void check_calendars(Subject& subject) {
  std::map<std::string, Span> spans;
  for (const syntax::PlanItem& each : subject.plan.items) {
    const auto* item = std::get_if<syntax::CalendarItem>(&each);
    if (item == nullptr) continue;
    subject.use("calendar", item->span);
    const auto [place, is_new] = spans.emplace(item->name.text, item->name.span);
    if (!is_new) {
      subject.twice(item->name.span,
                    fmt::format("calendar '{}' is declared twice", item->name.text), place->second);
      continue;
    }
    CalendarSpec calendar;
    calendar.name = item->name.text;
    calendar.span = item->name.span;
    LostDaysCheck lost(subject);
    for (const syntax::Shift& shift : item->shifts) {
      if (shift.lost) {
        lost.take(shift);
      } else if (shift.carry_over) {
        calendar.carry_over = true;
      } else if (!shift.off.empty()) {
        check_off_days(subject, shift, calendar);
      } else {
        check_shift(subject, shift, calendar);
      }
    }
    calendar.lost = lost.shares();
    if (calendar.shifts.empty() && subject.judges_names()) {
      subject.error("P11", item->name.span,
                    fmt::format("calendar '{}' has no working hours", item->name.text),
                    "write for example mon-fri 07:00-12:00, 12:30-16:00;");
    }
    subject.calendars.emplace(calendar.name, static_cast<int>(subject.model.calendars.size()));
    subject.model.calendars.push_back(std::move(calendar));
  }
}

}  // namespace rubicon::interpreter::plan_check
