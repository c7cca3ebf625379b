#include <optional>

#include "src/exchange/project_io/dates.hpp"
#include "src/exchange/project_io/mspdi_calendar_pugixml.hpp"
#include "src/simulation/schedule/civil_time.hpp"

namespace rubicon::project_io {

namespace {

/// Longest time over which exceptions that come again are written out, in days: forty years.
constexpr int kMaxDays = 40 * 366;

/// Exception types of MSPDI that are understood.
enum Recurrence { kDaily = 1, kYearly = 2, kWeekly = 6 };

class CalendarReader {
 public:
  CalendarReader(const pugi::xml_node& node, XmlReading& reading)
      : node_(node), reading_(reading) {}

  Calendar read() {
    XmlElement element(node_, reading_);
    element("", "UID", calendar_.uid);
    element("", "Name", calendar_.name);
    element("", "BaseCalendarUID", calendar_.base);
    element.take("IsBaseCalendar");  // the same as to have no base calendar
    element.take("IsBaselineCalendar");
    for (const pugi::xml_node& days : element.take_all("WeekDays")) {
      for (const pugi::xml_node& day : days.children("WeekDay")) read_week_day(day);
    }
    for (const pugi::xml_node& list : element.take_all("Exceptions")) {
      for (const pugi::xml_node& each : list.children("Exception")) read_exception(each);
    }
    element.finish();
    return std::move(calendar_);
  }

 private:
  void read_week_day(const pugi::xml_node& node) {
    XmlElement element(node, reading_);
    int type = -1;
    element("", "DayType", type);
    const DayTimes times = day_times(element);
    if (type == 0) {
      add_exception(node, element.take("TimePeriod"), times, "");
    } else if (type >= 1 && type <= 7) {
      calendar_.week[static_cast<std::size_t>((type + 5) % 7)] = times;  // theirs starts on Sunday
    } else {
      wrong(node, "expected a DayType from 0 to 7");
    }
    element.finish();
  }

  void read_exception(const pugi::xml_node& node) {
    XmlElement element(node, reading_);
    std::string name;
    int type = kDaily, period = 1, days = 0, month = -1, month_day = 0;
    element("", "Name", name);
    element("", "Type", type);
    element("", "Period", period);
    element("", "DaysOfWeek", days);
    element("", "Month", month);
    element("", "MonthDay", month_day);
    const DayTimes times = day_times(element);
    const pugi::xml_node span = element.take("TimePeriod");
    element.take("Occurrences");  // what the period and the pattern say already
    element.take("EnteredByOccurrences");
    if (type == kDaily && period <= 1) {
      // Only patterns use these.
      add_exception(node, span, times, name);
    } else if ((type == kDaily || type == kYearly || type == kWeekly) && period >= 1) {
      const auto matches = [&](int first, int day) {
        if (type == kDaily) return (day - first) % period == 0;
        if (type == kYearly) return is_month_day(day, month + 1, month_day);
        // The first of January 1970 was a Thursday; weeks begin on Sunday here.
        const int week_day = ((day + 4) % 7 + 7) % 7;
        const int weeks = (day + 4 - week_day) / 7 - (first + 4 - ((first + 4) % 7 + 7) % 7) / 7;
        return (days >> week_day & 1) != 0 && weeks % period == 0;
      };
      add_pattern(node, span, times, name, matches);
    } else {
      reading_.listing.add("I07", "pattern", reading_.span(node),
                           fmt::format("exception '{}' of calendar '{}' comes again by a pattern "
                                       "that is not understood (type {}); left out",
                                       name, calendar_.name, type),
                           "write its days out in the schedule");
    }
    element.finish();
  }

  static bool is_month_day(int day, int month, int month_day) {
    return date_text(day).substr(5) == fmt::format("{:02}-{:02}", month, month_day);
  }

  DayTimes day_times(XmlElement& element) {
    bool working = false;
    element("", "DayWorking", working);
    DayTimes times;
    for (const pugi::xml_node& list : element.take_all("WorkingTimes")) {
      for (const pugi::xml_node& each : list.children("WorkingTime")) {
        const std::optional<int> from = minutes(each.child("FromTime"));
        std::optional<int> to = minutes(each.child("ToTime"));
        if (!from && !to) continue;  // Project pads its lists with empty ones
        if (to == 0) to = 24 * 60;   // midnight ends a day as well
        if (from && to && *from < *to) {
          times.push_back({*from, *to});
        } else {
          wrong(each, "expected working time from an earlier to a later time of day");
        }
      }
    }
    if (!working) return {};
    return tidy(std::move(times));
  }

  /// Minutes of "08:00:00", with or without fractions of a second.
  std::optional<int> minutes(const pugi::xml_node& node) {
    const std::string text = text_in(node);
    if (text.empty()) return std::nullopt;
    const std::optional<int> result = schedule::parse_minute_of_day(text.substr(0, 5));
    if (!result) {
      wrong(node, "expected a time of day such as 08:00:00");
    } else if (text.size() >= 8 && text.substr(5, 3) != ":00") {
      wrong(node, "working time is kept in minutes; seconds are left off");
    }
    return result;
  }

  /// First and last day of a period; nothing, and listed, if they are none.
  std::optional<std::pair<int, int>> days_of(const pugi::xml_node& node,
                                             const pugi::xml_node& period) {
    const auto day = [&](const char* which) {
      return day_number(text_in(period.child(which)).substr(0, 10));
    };
    const auto first = day("FromDate"), last = day("ToDate");
    if (first && last && *first <= *last) return std::pair(*first, *last);
    wrong(period ? period : node, "expected a period from an earlier to a later date");
    return std::nullopt;
  }

  void add_exception(const pugi::xml_node& node, const pugi::xml_node& period,
                     const DayTimes& times, const std::string& name) {
    if (const auto days = days_of(node, period)) {
      calendar_.exceptions.push_back(
          {date_text(days->first), date_text(days->second), times, name});
    }
  }

  template <typename Matches>
  void add_pattern(const pugi::xml_node& node, const pugi::xml_node& period, const DayTimes& times,
                   const std::string& name, const Matches& matches) {
    const auto days = days_of(node, period);
    if (!days) return;
    if (days->second - days->first > kMaxDays) {
      wrong(node, "an exception comes again over more than forty years; the rest is left out");
    }
    for (int day = days->first; day <= std::min(days->second, days->first + kMaxDays); ++day) {
      if (!matches(days->first, day)) continue;
      calendar_.exceptions.push_back({date_text(day), date_text(day), times, name});
    }
  }

  void wrong(const pugi::xml_node& node, const char* message) {
    reading_.listing.add(
        "I03", std::string("calendar ") + message, reading_.span(node),
        fmt::format("{}, in calendar '{}', found '{}'", message, calendar_.name, text_in(node)));
  }

  pugi::xml_node node_;
  XmlReading& reading_;
  Calendar calendar_;
};

}  // namespace

Calendar read_mspdi_calendar(const pugi::xml_node& node, XmlReading& reading) {
  return CalendarReader(node, reading).read();
}

}  // namespace rubicon::project_io
