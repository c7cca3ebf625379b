#include "src/results/gantt/trace_times.hpp"

#include <stdexcept>
#include <variant>

#include "src/simulation/trace/header.hpp"
#include "src/simulation/trace/record.hpp"

namespace rubicon::gantt {

namespace {

schedule::CalendarRules read_calendar(const trace::HeaderCalendar& calendar) {
  schedule::CalendarRules rules;
  rules.name = calendar.name;
  rules.carry_over = calendar.carry_over;
  for (const trace::HeaderCalendar::Shift& shift : calendar.shifts) {
    rules.shifts.push_back({shift.first_day, shift.last_day, shift.minutes});
  }
  for (const std::string& day : calendar.off) {
    const auto date = schedule::parse_date(day);
    if (!date) throw std::invalid_argument("expected YYYY-MM-DD in 'off'");
    rules.off.push_back(*date);
  }
  return rules;
}

}  // namespace

void TraceTimesReader::line(std::string_view text) {
  reader_.read(
      text, [&](const trace::TraceHeader& header) { read_header(header); },
      [&](const trace::Record& record) {
        if (const auto* start = std::get_if<trace::TaskStart>(&record.what)) {
          begin(record, start->t);
        } else if (const auto* over = std::get_if<trace::TaskEnd>(&record.what)) {
          end(record, *over);
        } else if (const auto* work = std::get_if<trace::Work>(&record.what)) {
          add(record, {Stretch::Kind::work, work->from, work->t, std::string(work->crew),
                       std::string(work->what)});
        } else if (const auto* pause = std::get_if<trace::Pause>(&record.what)) {
          add(record, {Stretch::Kind::wait, pause->from, pause->t, {}, std::string(pause->why)});
        } else if (const auto* lost = std::get_if<trace::LostDays>(&record.what)) {
          lose_days(*lost);
        } else if (const auto* moving = std::get_if<trace::Moving>(&record.what)) {
          for (MovingTimes& each : times_.movings) {
            if (each.name == moving->name) each.stops.push_back({moving->t, moving->by.empty()});
          }
        }
      });
}

void TraceTimesReader::read_header(const trace::TraceHeader& header) {
  times_.plan = header.plan;
  short_form_ = header.short_form;
  for (const trace::HeaderCalendar& calendar : header.calendars) {
    times_.calendars.push_back(read_calendar(calendar));
  }
  const auto keep_calendar = [&](const std::string& name, const std::string& calendar) {
    if (!calendar.empty()) times_.calendar_of[name] = calendar;
  };
  for (const trace::HeaderRobot& robot : header.robots) keep_calendar(robot.name, robot.calendar);
  for (const trace::HeaderCrew& crew : header.crews) keep_calendar(crew.name, crew.calendar);
  for (const trace::HeaderMoving& moving : header.movings) {
    times_.movings.push_back({moving.name, moving.timetable, {}});
  }
  for (const trace::HeaderTask& task : header.tasks) times_.held[task.name] = task.crews;
}

/// Days that the weather took are days off of a chart.
void TraceTimesReader::lose_days(const trace::LostDays& lost) {
  for (schedule::CalendarRules& rules : times_.calendars) {
    if (rules.name != lost.calendar) continue;
    for (const std::string_view day : lost.days) {
      const auto date = schedule::parse_date(day);
      if (!date) throw std::invalid_argument("expected YYYY-MM-DD in 'days'");
      rules.off.push_back(*date);
    }
  }
}

void TraceTimesReader::begin(const trace::Record& record, Ticks start) {
  open_[std::string(record.task)] = {start, 0, !record.robot.empty(), {}};
}

void TraceTimesReader::end(const trace::Record& record, const trace::TaskEnd& end) {
  auto run = open_.extract(std::string(record.task));
  const bool happened = end.result == "done" || short_form_;
  if (run.empty() || !happened) return;
  run.mapped().end = end.t;
  times_.runs[{run.key(), run.mapped().start}] = run.mapped();
}

void TraceTimesReader::add(const trace::Record& record, Stretch stretch) {
  if (stretch.to < stretch.from) {
    throw std::invalid_argument("this is no line of a trace: it ends before it begins");
  }
  open_[std::string(record.task)].stretches.push_back(std::move(stretch));
}

}  // namespace rubicon::gantt
