#include "src/results/verify/schedule/check_critical.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

#include "src/motion/math/index.hpp"
#include "src/results/verify/replay/holds.hpp"
#include "src/results/verify/schedule/check_choices.hpp"
#include "src/results/verify/schedule/check_lifts.hpp"

namespace rubicon::verify {

namespace {

using math::at;

constexpr std::string_view kUncounted = "; its own work does not count";
constexpr std::string_view kNextShift = " later: the next shift";

constexpr std::string_view kThenWaits = ", then waits ";
constexpr std::string_view kForShift = " for the next shift";
constexpr std::string_view kGainsNothing = " sooner gains nothing)";
/// Waits for shifts are rounded to seconds.
constexpr Ticks kRounded = kSecond;

std::string duration_text(Ticks time) {
  std::vector<std::string> parts;
  if (time >= kHour) parts.push_back(fmt::format("{} h", time / kHour));
  if (time / kMinute % 60 > 0) parts.push_back(fmt::format("{} min", time / kMinute % 60));
  const double rest = static_cast<double>(time % kMinute) / static_cast<double>(kSecond);
  if (rest > 0 || parts.empty()) parts.push_back(fmt::format("{} s", rest));
  return fmt::format("{}", fmt::join(parts, " "));
}

std::string link_text(const SceneLink& link) {
  constexpr const char* kNames[] = {"FS", "SS", "FF", "SF"};
  std::string text = kNames[static_cast<int>(link.type)];
  if (link.lag > 0) text += " + " + duration_text(link.lag);
  if (link.lag < 0) text += " - " + duration_text(-link.lag);
  return text;
}

/// "15 h", "3 min 2.5 s"; nothing if it is no duration.
std::optional<Ticks> duration_of(std::string_view text) {
  Ticks time = 0;
  std::istringstream words{std::string(text)};
  std::string number, unit;
  while (words >> number) {
    char* end = nullptr;
    const double value = std::strtod(number.c_str(), &end);
    if (end != number.c_str() + number.size() || !(value < 1e9) || !(words >> unit)) return {};
    const Ticks size = unit == "h" ? kHour : unit == "min" ? kMinute : unit == "s" ? kSecond : 0;
    if (size == 0) return {};
    time += static_cast<Ticks>(std::llround(value * static_cast<double>(size)));
  }
  return text.empty() ? std::nullopt : std::optional(time);
}

/// What the end of a sentence says: ", D later: the next shift". Takes it off the sentence.
std::optional<Ticks> take_duration(std::string_view& text, std::string_view before,
                                   std::string_view after) {
  if (!text.ends_with(after)) return {};
  const std::size_t begin = text.rfind(before);
  if (begin == std::string_view::npos) return {};
  const std::size_t from = begin + before.size();
  if (from + after.size() > text.size()) return {};
  const auto time = duration_of(text.substr(from, text.size() - after.size() - from));
  if (time) text = text.substr(0, begin);
  return time;
}

/// Whether something is at a moment that a sentence says is later by `later`.
bool is_near(Ticks time, Ticks said, Ticks later) {
  return std::llabs(time - said) <= kTimeSlack + (later > 0 ? kRounded : 0);
}

class CriticalCheck {
 public:
  CriticalCheck(const Trace& trace, const std::vector<TaskRun>& runs, const WorkingHours& hours,
                const ScheduleJson& schedule, Faults& faults)
      : trace_(trace),
        runs_(runs),
        hours_(hours),
        rows_(schedule.critical),
        faults_(faults),
        kept_(kept_for_nothing(trace, runs)) {
    for (std::size_t i = 0; i < runs.size(); ++i) {
      holds_.push_back(holds_of(trace, runs, static_cast<int>(i)));
      runs_of_[trace.runs[at(runs[i].run)]].push_back(i);
    }
  }

  void check() {
    Ticks last = 0;
    for (const TaskRun& run : runs_) {
      if (run.happened && run.task >= 0) last = std::max(last, run.end);
    }
    if (rows_.empty()) {
      if (last > kTimeSlack) fault(0, "", "there is no critical path");
      return;
    }
    const auto ends_last = [&](const TaskRun& run) {
      return run.task >= 0 && last - run.end <= kTimeSlack;
    };
    if (last > 0 && !any_run(rows_.back().task, ends_last)) {
      fault(rows_.back().line, rows_.back().task,
            "the critical path ends here, and the task is not the last to finish");
    }
    for (std::size_t i = 0; i < rows_.size(); ++i) check(i);
  }

 private:
  void fault(int line, const std::string& task, std::string text) {
    faults_.push_back(
        {FaultKind::schedule, ResultFile::schedule_json, line, task, -1, std::move(text)});
  }

  /// Whether something holds for a run of this name that happened. A machine may be asked out of
  /// the way several times.
  template <typename Holds>
  bool any_run(const std::string& name, const Holds& holds) const {
    const auto found = runs_of_.find(name);
    if (found == runs_of_.end()) return false;
    return std::any_of(found->second.begin(), found->second.end(),
                       [&](std::size_t i) { return runs_[i].happened && holds(runs_[i]); });
  }

  void check(std::size_t i) {
    const CriticalRow& row = rows_[i];
    const auto happened = [](const TaskRun&) { return true; };
    if (!any_run(row.task, happened)) {
      fault(row.line, row.task, "the critical path leads through a task that is not done");
      return;
    }
    std::string_view text = row.text;
    const bool uncounted = text.ends_with(kUncounted);
    if (uncounted) text.remove_suffix(kUncounted.size());
    if (uncounted && row.work_counts) {
      fault(row.line, row.task, "its work counts, and its sentence says that it does not");
    }
    const std::optional<Ticks> gain = take_duration(text, " (less than ", kGainsNothing);
    const std::optional<Ticks> waits = take_duration(text, kThenWaits, kForShift);
    const Ticks later = take_duration(text, ", ", kNextShift).value_or(0);
    if (waits && !waited_for_shift(row.task, *waits)) {
      fault(row.line, row.task,
            fmt::format("it says that it waits {} for a shift on its way, and its pauses say "
                        "otherwise",
                        duration_text(*waits)));
    }
    if (gain && !waits && later == 0) {
      fault(row.line, row.task, "what is sooner gains nothing, and it waits for no shift");
    }
    if (!text.starts_with(row.task)) {
      fault(row.line, row.task, "its sentence is about another task");
      return;
    }
    text.remove_prefix(row.task.size());
    if (is_reason(i, text, later) || misses_shift(row.task, text, gain.value_or(0))) return;
    fault(row.line, row.task,
          fmt::format("'{}' does not lead from the task before it in the critical path{}", row.text,
                      i > 0 ? ", " + rows_[i - 1].task : ""));
  }

  /// Whether some of its pauses for shifts, one after the other, take so long together.
  bool waited_for_shift(const std::string& name, Ticks time) const {
    return any_run(name, [&](const TaskRun& run) {
      std::vector<Ticks> pauses;
      for (const std::size_t number : run.records) {
        const Record& record = trace_.records[number];
        const auto* pause = std::get_if<Pause>(&record.what);
        if (pause == nullptr || (pause->why != "shift" && pause->why != "lift")) continue;
        pauses.push_back(record.time - pause->from);
      }
      for (std::size_t first = 0; first < pauses.size(); ++first) {
        Ticks sum = 0;
        for (std::size_t i = first; i < pauses.size(); ++i) {
          sum += pauses[i];
          if (std::llabs(sum - time) <= kRounded) return true;
        }
      }
      return false;
    });
  }

  /// " misses a shift waiting for 'crew', which other had": whether the other gave the crew back
  /// after a lift of the task began to wait for a shift and before the task had the crew, and
  /// without the wait for the crew the lift would have fit into the shift in which it began to
  /// wait.
  bool misses_shift(const std::string& name, std::string_view text, Ticks gain) const {
    return any_resource([&](int resource) {
      const std::string crew = resource_name(trace_.scene, resource);
      const std::string begin = fmt::format(" misses a shift waiting for '{}', which ", crew);
      if (!text.starts_with(begin) || !text.ends_with(" had")) return false;
      text.remove_prefix(begin.size());
      text.remove_suffix(std::string_view(" had").size());
      return any_run(name, [&](const TaskRun& run) {
        return any_hold(std::string(text), resource, [&](const Hold& given) {
          const auto taken_later = [&](const Hold& taken) {
            return taken.from >= given.to - kTimeSlack;
          };
          return any_hold(name, resource, taken_later) && misses_shift(run, given.to, gain);
        });
      });
    });
  }

  bool misses_shift(const TaskRun& run, Ticks given, Ticks gain) const {
    const std::optional<Lift> lift = find_lift(trace_, run);
    if (!lift) return false;
    const std::vector<int> calendars =
        calendars_of_lift(trace_.scene, trace_.scene.tasks[at(run.task)]);
    const auto is_within_shift = [&](Ticks from, Ticks to) {
      return to - from - hours_.between(calendars, from, to) <= kTimeSlack;
    };
    return std::any_of(run.records.begin(), run.records.end(), [&](std::size_t number) {
      const Record& record = trace_.records[number];
      const auto* pause = std::get_if<Pause>(&record.what);
      if (pause == nullptr || pause->why != "lift") return false;
      if (given <= pause->from) return false;
      // It may have missed that shift for another reason, and a later one for this.
      if (!is_within_shift(pause->from, pause->from + lift->own)) return true;
      return !is_within_shift(pause->from, given + lift->own - gain + kRounded);
    });
  }

  /// Whether it waited on its way for something with a timetable.
  bool waits_for_timetable(const std::string& name, std::string_view text) const {
    return any_run(name, [&](const TaskRun& run) {
      return std::any_of(run.records.begin(), run.records.end(), [&](std::size_t number) {
        const auto* pause = std::get_if<Pause>(&trace_.records[number].what);
        if (pause == nullptr || pause->why != "machine") return false;
        const std::string waits = fmt::format(" waits on its way for '{}'", pause->whom);
        return text == waits || text == waits + ", which came later than its timetable says";
      });
    });
  }

  bool is_reason(std::size_t i, std::string_view text, Ticks later) const {
    const std::string& name = rows_[i].task;
    if (i > 0) return leads(rows_[i - 1].task, name, text, later);
    if (text == " could start with the plan") return waits_for_zone(name);
    if (text == " starts with the plan") {
      return any_run(name, [&](const TaskRun& run) {
        return is_near(run.start, later, later) || run.task < 0 || later == 0;
      });
    }
    if (starts_at_its_date(name, text, later)) return true;
    if (waits_for_nobody(name, text) || waits_for_timetable(name, text)) return true;
    // The path may lead back to one of its own tasks: a machine that parks several times.
    return std::any_of(rows_.begin(), rows_.end(), [&](const CriticalRow& other) {
      return leads(other.task, name, text, later);
    });
  }

  bool starts_at_its_date(const std::string& name, std::string_view text, Ticks later) const {
    const auto known = trace_.scene.task_index.find(name);
    if (known == trace_.scene.task_index.end()) return false;
    const Ticks date = trace_.scene.tasks[at(known->second)].not_before;
    const std::string tail =
        fmt::format(" at its not_before, {} after the beginning of the plan", duration_text(date));
    if (date > 0 && text == " could start" + tail) return starts_after(name, date + later);
    return date > 0 && text == " starts" + tail && any_run(name, [&](const TaskRun& run) {
             return is_near(run.start, date + later, later);
           });
  }

  /// Whether a task with a zone, in which a machine stood meanwhile, starts later than it could.
  bool starts_after(const std::string& name, Ticks could_start) const {
    return waits_for_zone(name) &&
           any_run(name, [&](const TaskRun& run) { return run.start > could_start + kTimeSlack; });
  }

  /// Whether the path says of a later step of the task that a machine was in its way at the start.
  bool waits_for_zone(const std::string& name) const {
    return std::any_of(rows_.begin(), rows_.end(), [&](const CriticalRow& row) {
      return row.task == name && row.text.starts_with(name + " starts after it waited for '");
    });
  }

  /// A machine was in the way that no task had.
  bool waits_for_nobody(const std::string& name, std::string_view text) const {
    return any_resource([&](int resource) {
      const std::string quoted = fmt::format("'{}'", resource_name(trace_.scene, resource));
      return (text == " waits on its way for " + quoted + ", to be out of the way" ||
              text == " starts after it waited for " + quoted + ", to be out of the way") &&
             any_run(name, [](const TaskRun&) { return true; });
    });
  }

  template <typename Holds>
  bool any_resource(const Holds& holds) const {
    const int count = static_cast<int>(trace_.scene.robots.size() + trace_.scene.crews.size());
    for (int resource = 0; resource < count; ++resource) {
      if (holds(resource)) return true;
    }
    return false;
  }

  /// Whether the sentence says that the task waited for `before`, and it could be so.
  bool leads(const std::string& before, const std::string& name, std::string_view text,
             Ticks later) const {
    if (text == " starts because " + before + " asks for it") return true;
    if (text == " waits on its way for the zone of " + before ||
        text == " starts after it waited for the zone of " + before) {
      return true;
    }
    return by_resource(before, name, text, later) || by_link(before, name, text, later);
  }

  bool by_resource(const std::string& before, const std::string& name, std::string_view text,
                   Ticks later) const {
    return any_resource([&](int resource) {
      const std::string quoted = fmt::format("'{}'", resource_name(trace_.scene, resource));
      const std::string had = fmt::format(", which {} had", before);
      for (const bool repaired : {false, true}) {
        if (text == " starts when " + quoted + (repaired ? " is repaired" : " is free") + had) {
          return given_over(before, name, resource, later, repaired);
        }
      }
      if (text.starts_with(" could start when " + quoted + " is ") && text.ends_with(had)) {
        return any_hold(before, resource, [&](const Hold& given) {
          return starts_after(name, free_from(given) + later);
        });
      }
      if (text == " starts when " + quoted + " is kept for nobody any more" + had) {
        return kept_no_more(before, name, resource, later);
      }
      if (!any_hold(before, resource, [](const Hold&) { return true; })) return false;
      for (const char* way : {"", ", to be out of the way"}) {
        if (text == " waits on its way for " + quoted + had + way) return true;
        if (text == " starts after it waited for " + quoted + had + way) return true;
      }
      return false;
    });
  }

  template <typename Holds>
  bool any_hold(const std::string& name, int resource, const Holds& holds) const {
    const auto found = runs_of_.find(name);
    if (found == runs_of_.end()) return false;
    for (const std::size_t i : found->second) {
      for (const Hold& hold : holds_[i]) {
        if (hold.resource == resource && holds(hold)) return true;
      }
    }
    return false;
  }

  /// The one gives back what the other has from then, or from its repair, or from the next shift.
  bool given_over(const std::string& before, const std::string& name, int resource, Ticks later,
                  bool repaired) const {
    return any_hold(name, resource, [&](const Hold& taken) {
      return any_hold(before, resource, [&](const Hold& given) {
        const Ticks free = free_from(given);
        return repaired == (free > given.to) && is_near(taken.from, free + later, later);
      });
    });
  }

  /// The one had it, and the other has it from when it was kept no more, or from the next shift.
  bool kept_no_more(const std::string& before, const std::string& name, int resource,
                    Ticks later) const {
    return std::any_of(kept_.begin(), kept_.end(), [&](const Kept& kept) {
      if (kept.resource != resource) return false;
      const auto gave_back = [&](const Hold& given) { return given.to < kept.until; };
      const auto takes = [&](const Hold& taken) {
        return is_near(taken.from, kept.until + later, later);
      };
      return any_hold(before, resource, gave_back) && any_hold(name, resource, takes);
    });
  }

  /// A machine that breaks down at the end of a task is free when it is repaired.
  Ticks free_from(const Hold& given) const {
    const std::string& name = trace_.runs[at(runs_[at(given.run)].run)];
    for (const BreakdownRecord& each : trace_.breakdowns) {
      if (each.robot == given.resource && each.during == name &&
          std::llabs(each.from - given.to) <= kTimeSlack) {
        return each.until;
      }
    }
    return given.to;
  }

  bool by_link(const std::string& before, const std::string& name, std::string_view text,
               Ticks later) const {
    const auto known = trace_.scene.task_index.find(name);
    if (known == trace_.scene.task_index.end()) return false;
    const std::vector<SceneLink>& links = trace_.scene.tasks[at(known->second)].after;
    return std::any_of(links.begin(), links.end(), [&](const SceneLink& link) {
      if (trace_.scene.tasks[at(link.task)].name != before) return false;
      const std::string tail = fmt::format(" after {} ({})", before, link_text(link));
      const bool starts = text == " starts" + tail;
      const bool finishes = text == " finishes" + tail;
      const bool could_start = text == " could start" + tail;
      if (text == " could start so that it finishes" + tail) return waits_for_zone(name);
      if (!starts && !could_start && !finishes) return text == " starts so that it finishes" + tail;
      // What is allowed sooner than it was known comes when it was known.
      if (finishes || link.lag < 0) return true;
      const bool from_start = link.type == LinkType::SS || link.type == LinkType::SF;
      return any_run(before, [&](const TaskRun& first) {
        const Ticks wanted = (from_start ? first.start : first.end) + link.lag + later;
        if (could_start) return starts_after(name, wanted);
        return any_run(name, [&](const TaskRun& run) {
          return is_near(starts ? run.start : run.end, wanted, later);
        });
      });
    });
  }

  const Trace& trace_;
  const std::vector<TaskRun>& runs_;
  const WorkingHours& hours_;
  const std::vector<CriticalRow>& rows_;
  Faults& faults_;
  std::vector<Kept> kept_;
  std::vector<std::vector<Hold>> holds_;  ///< by run
  std::map<std::string, std::vector<std::size_t>> runs_of_;
};

}  // namespace

void check_critical(const Trace& trace, const std::vector<TaskRun>& runs, const WorkingHours& hours,
                    const ScheduleJson& schedule, Faults& faults) {
  if (!trace.scene.short_form) CriticalCheck(trace, runs, hours, schedule, faults).check();
}

}  // namespace rubicon::verify
