#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "interpreter/check/plan_model.hpp"

namespace rubicon::project_io {

using schedule::LinkType;

/// No element has this number: "none" for a calendar, a base calendar or a resource.
inline constexpr std::int64_t kNone = -1;

/// A moment on the schedule's own clock: "YYYY-MM-DD HH:MM", or with ":SS"; empty: not given.
struct Moment {
  std::string text;
  bool operator==(const Moment&) const = default;
};

/// A stretch of working time (of elapsed time where its format says so), in whole seconds.
struct Duration {
  std::int64_t seconds = 0;
  bool operator==(const Duration&) const = default;
};

/// A schedule has so many columns for texts of one's own.
inline constexpr std::size_t kMostTextFields = 30;

enum class TimeUnit { minutes, hours, days, weeks, months, percent };

/// How the schedule's author wrote a duration or a lag: the unit, whether it runs on outside of the
/// shifts, whether it is an estimate ("3 d?").
struct TimeFormat {
  TimeUnit unit = TimeUnit::days;
  bool elapsed = false;
  bool estimated = false;
  bool operator==(const TimeFormat&) const = default;
};

/// Working time from one minute of a day to another, 0 to 1440.
struct Interval {
  int from = 0;
  int to = 0;
  bool operator==(const Interval&) const = default;
};
/// In order, none touching the next; empty: no work.
using DayTimes = std::vector<Interval>;

/// Days that differ from the week.
struct CalendarException {
  std::string first;  ///< YYYY-MM-DD
  std::string last;   ///< the last of these days
  DayTimes times;     ///< empty: days off
  std::string name;
  bool operator==(const CalendarException&) const = default;
};

struct Calendar {
  std::int64_t uid = kNone;
  std::string name;
  std::int64_t base = kNone;  ///< the calendar that holds where this one says nothing
  std::array<std::optional<DayTimes>, 7> week;  ///< from Monday; nothing: as the base calendar
  std::vector<CalendarException> exceptions;    ///< by first day
  bool operator==(const Calendar&) const = default;
};

/// The dependence of a task on a predecessor.
struct Link {
  std::int64_t predecessor = kNone;  ///< uid of a task
  LinkType type = LinkType::FS;
  std::int64_t lag =
      0;  ///< seconds; in percent of the predecessor's duration if `format` is percent
  TimeFormat format;
  bool operator==(const Link&) const = default;
};

/// When a task may start or finish, numbered as in Microsoft Project.
enum class Constraint {
  as_soon_as_possible,
  as_late_as_possible,
  must_start_on,
  must_finish_on,
  start_no_earlier_than,
  start_no_later_than,
  finish_no_earlier_than,
  finish_no_later_than,
};

/// One line of the schedule. A line with deeper lines below it is a heading (a summary task).
struct Task {
  std::int64_t uid = kNone;
  std::int64_t id = 0;  ///< the number of its row, as people see it
  std::string name;
  std::string code;  ///< work breakdown code or activity code
  int level = 1;     ///< of the outline; 0 is the project itself
  bool active = true;
  bool manual = false;  ///< placed by hand, not by links
  int type = 0;         ///< 0 fixed units, 1 fixed duration, 2 fixed work
  int priority = 500;
  Moment start, finish;
  Duration duration;
  TimeFormat format;
  Duration work;
  bool effort_driven = false;
  bool milestone = false;
  bool summary = false;  ///< called a heading by the file although nothing is below it
  double fixed_cost = 0;
  int fixed_cost_accrual = 3;
  int percent_complete = 0;
  Moment actual_start, actual_finish;
  Constraint constraint = Constraint::as_soon_as_possible;
  std::int64_t calendar = kNone;
  Moment constraint_date, deadline;
  /// Where it has a calendar: that alone says when it goes on, whoever works on it.
  bool ignores_resource_calendars = false;
  Moment baseline_start, baseline_finish;  ///< the first baseline of the schedule
  bool hide_bar = false;
  std::string notes;
  std::vector<Link> after;                         ///< in the order of the predecessors
  std::vector<std::pair<int, std::string>> texts;  ///< by the index of Project::text_fields
  bool operator==(const Task&) const = default;
};

enum class ResourceType { material, work, cost };

struct Resource {
  std::int64_t uid = kNone;
  std::int64_t id = 0;
  std::string name;
  ResourceType type = ResourceType::work;
  std::string initials, material_label, code, group, email;
  double max_units = 1;      ///< how many of them
  double standard_rate = 0;  ///< per unit of `rate_format`
  int rate_format = 2;       ///< 1 minute, 2 hour, 3 day, 4 week, 5 month, 7 year, 8 piece
  double overtime_rate = 0;
  int overtime_rate_format = 2;
  double cost_per_use = 0;
  std::int64_t calendar = kNone;
  std::string notes;
  bool operator==(const Resource&) const = default;
};

/// A resource at work on a task.
struct Assignment {
  std::int64_t uid = kNone;
  std::int64_t task = kNone;
  std::int64_t resource = kNone;
  int percent_complete = 0;
  Moment start, finish;
  double units = 1;
  Duration work;
  bool operator==(const Assignment&) const = default;
};

/// A schedule, whichever program it comes from. After reading, every uid is unique in its list,
/// every reference has its element, and links form no ring.
struct Project {
  std::string name, title, subject, company, manager, author;
  bool schedule_from_start = true;
  Moment start, finish;
  std::string currency_symbol, currency_code;
  std::int64_t calendar = kNone;
  int minutes_per_day = 480;
  int minutes_per_week = 2400;
  int days_per_month = 20;
  std::vector<Calendar> calendars;
  std::vector<Task> tasks;  ///< in the order of the outline
  std::vector<Resource> resources;
  std::vector<Assignment> assignments;
  std::vector<std::string> text_fields;  ///< columns of their own, at most kMostTextFields
  bool operator==(const Project&) const = default;

  /// Whether the task at `index` has deeper ones below it, or stands for the whole project.
  bool is_heading(std::size_t index) const {
    return tasks[index].level == 0 ||
           (index + 1 < tasks.size() && tasks[index + 1].level > tasks[index].level);
  }
};

}  // namespace rubicon::project_io
