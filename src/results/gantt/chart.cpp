#include "src/results/gantt/chart.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

#include "src/results/gantt/chart_labels.hpp"
#include "src/results/gantt/chart_rows.hpp"

namespace rubicon::gantt {

namespace {

using taskplan::Schedule;
using taskplan::TaskOutcome;
using taskplan::TaskResult;

/// Shades of more times out of shift than this, in all lanes, make the file too large to open.
constexpr std::size_t kMostShades = 100'000;

/// Of what goes and stops more often only the whole is drawn.
constexpr std::size_t kMostStretches = 5'000;

class ChartBuilder {
 public:
  ChartBuilder(const Schedule& schedule, const TraceTimes* times)
      : schedule_(schedule), times_(times) {
    for (const auto& task : schedule.critical) critical_.insert(task.task);
  }

  Chart build(const std::string& title) {
    chart_.title = times_ != nullptr && !times_->plan.empty() ? times_->plan : title;
    chart_.facts = fact_labels(schedule_);
    chart_.start = schedule_.start_at;
    chart_.end = schedule_.process_time;
    for (const TaskOutcome& task : schedule_.tasks) {
      chart_.end = std::max(chart_.end, task.start + task.duration);
      if (task.baseline) chart_.end = std::max(chart_.end, task.baseline->finish);
    }
    find_off_times();
    for (const auto& use : schedule_.resources) add_resource(use);
    find_nobody();
    add_tasks();
    if (times_ != nullptr) {
      for (const MovingTimes& moving : times_->movings) add_moving(moving);
    }
    return std::move(chart_);
  }

 private:
  void find_off_times() {
    if (times_ == nullptr) return;
    std::map<std::string, std::vector<Span>> by_calendar;
    for (const auto& rules : times_->calendars) {
      by_calendar[rules.name] =
          off_times(rules, schedule_.start_at.value_or(schedule::kUndatedStart), chart_.end);
    }
    std::size_t shades = 0;
    for (const auto& [resource, calendar] : times_->calendar_of) {
      const auto found = by_calendar.find(calendar);
      if (found == by_calendar.end()) {
        throw std::invalid_argument("'" + resource + "' has a calendar that is not there");
      }
      shades += found->second.size();
      if (shades > kMostShades) return off_.clear();
      off_[resource] = found->second;
    }
    chart_.has_shifts = shades > 0;
  }

  void add_resource(const taskplan::ResourceUse& use) {
    resource_[use.name] = chart_.resources.size();
    Lane& lane = chart_.resources.emplace_back();
    lane.name = use.name;
    lane.note = use_label(schedule_, use);
    lane.brief = percent_label(use);
    const auto off = off_.find(use.name);
    if (off != off_.end()) lane.off = off->second;
  }

  void find_nobody() {
    chart_.nobody = {{0, chart_.end}};
    for (const Lane& lane : chart_.resources) chart_.nobody = in_both(chart_.nobody, lane.off);
    if (chart_.resources.empty()) chart_.nobody.clear();
  }

  void add_tasks() {
    std::vector<Bar> bars;
    std::vector<Bar> of_nobody;
    for (const TaskOutcome& task : schedule_.tasks) {
      if (task.result != TaskResult::done && !task.parking) {
        chart_.not_done.push_back(
            {task.task, std::string(name_of(task.result)) + ": " + task.reason});
      }
      if (task.result != TaskResult::done && task.duration == 0) continue;
      const Bar bar = make_bar(task);
      if (!add_to_lanes(task, bar)) of_nobody.push_back(bar);
      if (bar.span.to == bar.span.from) chart_.has_milestones = true;
      bars.push_back(bar);
      if (!task.baseline) continue;
      const Ticks from = std::clamp<Ticks>(task.baseline->start, 0, chart_.end);
      bars.back().baseline = Span{from, std::clamp<Ticks>(task.baseline->finish, from, chart_.end)};
      chart_.has_baselines = true;
    }
    chart_.rows = chart_rows(bars, chart_.rows_title);
    // Where each task has a row of its own, all are to be seen.
    if (chart_.rows.size() != bars.size()) add_lanes_of_nobody(std::move(of_nobody));
  }

  /// Lanes below those of machines and crews for what neither does: so many that no two overlap.
  void add_lanes_of_nobody(std::vector<Bar> bars) {
    std::stable_sort(bars.begin(), bars.end(),
                     [](const Bar& a, const Bar& b) { return a.span.from < b.span.from; });
    const std::size_t first = chart_.resources.size();
    for (Bar& bar : bars) {
      std::size_t lane = first;
      const auto is_taken = [&](const Lane& each) {
        return each.bars.back().span.to > bar.span.from;
      };
      while (lane < chart_.resources.size() && is_taken(chart_.resources[lane])) ++lane;
      if (lane == chart_.resources.size()) {
        chart_.resources.emplace_back().name = lane == first ? "no machine, no crew" : "";
      }
      chart_.resources[lane].bars.push_back(std::move(bar));
    }
  }

  /// What moves by itself: when it goes, stays as its path says, and is stopped.
  void add_moving(const MovingTimes& moving) {
    std::vector<trace::MovingStretch> stretches =
        trace::moving_stretches(moving.timetable, moving.stops, chart_.end, kMostStretches);
    Lane& lane = chart_.movings.emplace_back();
    lane.name = moving.name;
    if (stretches.empty()) return;
    Bar bar;
    bar.name = moving.name;
    bar.span = {stretches.front().from, stretches.back().to};
    int stops = 0;
    Ticks late = 0;
    const bool many = stretches.size() == kMostStretches;
    for (const trace::MovingStretch& each : stretches) {
      using Kind = trace::MovingStretch::Kind;
      const bool stopped = each.kind == Kind::stopped;
      if (stopped) late += each.to - each.from;
      const auto kind = stopped                    ? Part::Kind::wait
                        : each.kind == Kind::stays ? Part::Kind::off
                                                   : Part::Kind::motion;
      if (stopped) ++stops;
      if (!bar.parts.empty() && bar.parts.back().kind == kind) {
        bar.parts.back().span.to = each.to;
      } else {
        bar.parts.push_back({kind, {each.from, each.to}});
      }
    }
    if (many) {
      // Of what goes round for months it only tells that it does.
      bar.span.to = chart_.end;
      bar.parts = {{Part::Kind::motion, bar.span}};
    } else if (stops > 0) {
      lane.note = stopped_label(stops, late);
      lane.brief = duration_label(late) + " late";
    }
    bar.text = moving.name + (lane.note.empty() ? "" : ": " + lane.note);
    lane.bars.push_back(std::move(bar));
  }

  const TaskTimes* times_of(const TaskOutcome& task) const {
    if (times_ == nullptr) return nullptr;
    const auto found = times_->runs.find({task.task, task.start});
    return found == times_->runs.end() ? nullptr : &found->second;
  }

  Bar make_bar(const TaskOutcome& task) const {
    Bar bar;
    bar.name = task.task;
    bar.span = {task.start, task.start + task.duration};
    bar.critical = !task.parking && critical_.contains(task.task);
    bar.text = task_label(schedule_, task, bar.critical);
    const TaskTimes* times = times_of(task);
    if (times == nullptr) {
      bar.parts.push_back({task.robot.empty() ? Part::Kind::work : Part::Kind::motion, bar.span});
      return bar;
    }
    Ticks now = bar.span.from;
    for (const Stretch& stretch : times->stretches) {
      if (stretch.from > now) bar.parts.push_back({Part::Kind::motion, {now, stretch.from}});
      add_stretch(bar, task, stretch);
      now = std::max(now, stretch.to);
    }
    // Crew work that waits for nothing more than a link to its finish stands still, as the machine.
    const Part::Kind rest = task.robot.empty() ? Part::Kind::wait : Part::Kind::motion;
    if (now < bar.span.to) bar.parts.push_back({rest, {now, bar.span.to}});
    return bar;
  }

  /// Work but for the nights in it; or waiting.
  void add_stretch(Bar& bar, const TaskOutcome& task, const Stretch& stretch) const {
    const Span span = {stretch.from, stretch.to};
    if (stretch.kind == Stretch::Kind::wait) {
      const bool night = stretch.what == "shift";
      bar.parts.push_back({night ? Part::Kind::off : Part::Kind::wait, span});
      return;
    }
    std::vector<Span> at_work = {span};
    std::vector<std::string> who = {stretch.crew};
    if (stretch.crew.empty()) {
      who = task.crews;
      who.push_back(task.robot);
    }
    for (const std::string& name : who) {
      const auto off = off_.find(name);
      if (off == off_.end()) continue;
      std::vector<Span> left;
      for (const Span& each : at_work) {
        for (const Span& piece : without(each, off->second)) left.push_back(piece);
      }
      at_work = std::move(left);
    }
    Ticks now = span.from;
    for (const Span& each : at_work) {
      if (each.from > now) bar.parts.push_back({Part::Kind::off, {now, each.from}});
      bar.parts.push_back({Part::Kind::work, each});
      now = each.to;
    }
    if (now < span.to) bar.parts.push_back({Part::Kind::off, {now, span.to}});
  }

  Lane* lane_of(const std::string& name) {
    const auto found = resource_.find(name);
    return found == resource_.end() ? nullptr : &chart_.resources[found->second];
  }

  /// Whether there is a lane of a machine or a crew for it.
  bool add_to_lanes(const TaskOutcome& task, const Bar& bar) {
    bool is_shown = false;
    if (Lane* lane = lane_of(task.robot)) {
      lane->bars.push_back(bar);
      is_shown = true;
    }
    const TaskTimes* times = times_of(task);
    for (const std::string& crew : task.crews) {
      Lane* lane = lane_of(crew);
      if (lane == nullptr) continue;
      is_shown = true;
      if (times == nullptr || task.robot.empty() || holds(task, crew)) {
        lane->bars.push_back(bar);
      } else {
        for (const Stretch& work : times->stretches) {
          if (work.crew == crew) lane->bars.push_back(work_bar(task, bar, work));
        }
      }
    }
    return is_shown;
  }

  /// Whether a crew is there from the start of a task to its end.
  bool holds(const TaskOutcome& task, const std::string& crew) const {
    const auto found = times_->held.find(task.task);
    return found != times_->held.end() &&
           std::find(found->second.begin(), found->second.end(), crew) != found->second.end();
  }

  /// The bar of a crew that comes for one work only.
  Bar work_bar(const TaskOutcome& task, const Bar& whole, const Stretch& work) const {
    Bar bar;
    bar.name = whole.name;
    bar.span = {work.from, work.to};
    bar.critical = whole.critical;
    bar.text = work.what + " of " + whole.text;
    add_stretch(bar, task, work);
    return bar;
  }

  const Schedule& schedule_;
  const TraceTimes* times_;
  Chart chart_;
  std::set<std::string> critical_;
  std::map<std::string, std::vector<Span>> off_;  ///< by resource
  std::map<std::string, std::size_t> resource_;   ///< place in chart_.resources
};

}  // namespace

Chart make_chart(const Schedule& schedule, const TraceTimes* times, const std::string& title) {
  return ChartBuilder(schedule, times).build(title);
}

}  // namespace rubicon::gantt
