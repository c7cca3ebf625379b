#include "src/results/verify/schedule/check_earth_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include "src/motion/math/index.hpp"
#include "src/results/verify/replay/holds.hpp"

namespace rubicon::verify {

namespace {

using math::at;

/// s: as times are written.
constexpr double kSlack = 2e-9;

double seconds(Ticks time) { return static_cast<double>(time) / static_cast<double>(kSecond); }
double metres(std::int64_t volume) { return static_cast<double>(volume) * 1e-9; }
bool is_figure(double a, double b) { return std::fabs(a - b) <= 1e-9 + 1e-9 * std::fabs(b); }

/// What a truck took away, by the trace; times that are worked, from the beginning of its task.
struct LoadTold {
  std::string dig;
  std::int64_t volume = 0;
  Ticks began = 0, loaded = 0, fell = 0;
};

class EarthRows {
 public:
  EarthRows(const Trace& trace, const std::vector<TaskRun>& runs, const WorkingHours& hours,
            const ScheduleJson& schedule, Faults& faults)
      : trace_(trace), runs_(runs), hours_(hours), schedule_(schedule), faults_(faults) {
    for (std::size_t i = 0; i < runs.size(); ++i) {
      if (runs[i].happened && runs[i].task >= 0) run_of_[runs[i].task] = static_cast<int>(i);
    }
    for (const auto& [task, run] : run_of_) note_loads(task, run);
  }

  void check(const std::optional<std::vector<LoadRow>>& loads) {
    for (const ScheduleRow& row : schedule_.rows) {
      const auto known = trace_.scene.task_index.find(row.task);
      if (known == trace_.scene.task_index.end()) continue;
      row_ = &row;
      const SceneTask& task = trace_.scene.tasks[at(known->second)];
      const auto run = run_of_.find(known->second);
      const bool is_done = row.result == "done" && run != run_of_.end();
      const bool digs = task.motion_dig && is_done;
      const bool hauls = task.haul && is_done;
      if (row.motion_dig.has_value() != digs || row.haul.has_value() != hauls) {
        fault("what it dug or hauled is not told, or the trace has nothing of it");
        continue;
      }
      if (digs) check_dig(*task.motion_dig, known->second, run->second, *row.motion_dig);
      if (hauls) check_haul(run->second, loads_of_[known->second], *row.haul);
      if (hauls && loads) check_listed(*row.haul, *loads);
    }
    check_together();
  }

 private:
  void fault(const std::string& text) {
    faults_.push_back({FaultKind::schedule, ResultFile::schedule_json, row_ ? row_->line : 0,
                       row_ ? row_->task : "", row_ ? row_->start : -1, text});
  }

  void expect(const char* what, double found, double expected) {
    if (is_figure(found, expected)) return;
    fault(fmt::format("earthwork: '{}' is {:.10g}, by the trace {:.10g}", what, found, expected));
  }
  void expect(const char* what, const std::optional<double>& found, double expected) {
    if (found) expect(what, *found, expected);
  }
  void require(bool holds, const char* what) {
    if (!holds) fault(fmt::format("earthwork: '{}' cannot be so", what));
  }

  Ticks worked(int run, Ticks to) const {
    return hours_.between(calendars_of(trace_, runs_, run), runs_[at(run)].start, to);
  }

  const std::string* dig_of_soil(const SceneHaul& haul, int component) const {
    for (const std::string& name : haul.digs) {
      const auto found = trace_.scene.task_index.find(name);
      if (found == trace_.scene.task_index.end()) continue;
      const auto& dig = trace_.scene.tasks[at(found->second)].motion_dig;
      if (dig && dig->soil == component) return &name;
    }
    return nullptr;
  }

  void note_loads(int task, int run) {
    const auto& haul = trace_.scene.tasks[at(task)].haul;
    if (!haul) return;
    std::vector<LoadTold>& loads = loads_of_[task];
    const std::vector<int> calendars = calendars_of(trace_, runs_, run);
    const auto since_start = [&](Ticks time) {
      return hours_.between(calendars, runs_[at(run)].start, time);
    };
    for (const int index : runs_[at(run)].records) {
      const Record& record = trace_.records[at(index)];
      const auto* taken = std::get_if<SoilTaken>(&record.what);
      if (taken == nullptr) continue;
      if (taken->volume > 0) {
        const std::string* const dig = dig_of_soil(*haul, taken->component);
        loads.push_back({dig != nullptr ? *dig : "", taken->volume, since_start(taken->from),
                         since_start(record.time)});
        ++loads_taken_[loads.back().dig];
      } else if (!loads.empty()) {
        loads.back().fell = since_start(record.time);
      }
    }
  }

  void check_dig(const SceneMotionDig& dig, int task, int run, const RowMotionDig& row) {
    std::int64_t dug = 0;
    std::int64_t cuts = 0;
    for (const int index : runs_[at(run)].records) {
      const auto* taken = std::get_if<SoilTaken>(&trace_.records[at(index)].what);
      if (taken == nullptr || taken->component != dig.soil) continue;
      dug += taken->volume;
      ++cuts;
    }
    const double volume = metres(dug);
    const double time = seconds(row.working);
    const double all = seconds(worked(run, runs_[at(run)].end));
    expect("volume", row.volume, metres(dig.volume));
    expect("dug", row.dug, volume);
    expect("bucket", row.bucket, metres(dig.bucket));
    // A bucket may be filled by several cuts.
    const bool fits = row.buckets <= cuts && row.buckets >= (dug + dig.bucket - 1) / dig.bucket;
    require(fits, "buckets");
    // By durations trucks go on when the last bucket is empty; the time is that of the last tip.
    expect("working", time, all);
    expect("per_hour", row.per_hour, time > 0 ? volume / (time / 3600) : 0);
    if (volume > 0) {
      expect("cost_per_m3", row.cost_per_m3, row_->cost.value_or(0) / volume);
      expect("fuel_per_m3", row.fuel_per_m3, row_->fuel.value_or(0) / volume);
    }
    const double parts = row.to_the_cut + row.cut + row.swing + row.dump;
    require(std::min({row.to_the_cut, row.cut, row.swing, row.dump}) >= 0 &&
                std::fabs(row.cycle - parts) <= 1e-6,
            "mean");
    require(row.cycle * static_cast<double>(row.buckets) <= all + kSlack * 1e3, "cycle");
    const std::string& name = trace_.scene.tasks[at(task)].name;
    if (dig.load_at) {
      expect("trucks", static_cast<double>(row.trucks.value_or(0)),
             static_cast<double>(trucks_of(name)));
      expect("loads", static_cast<double>(row.loads.value_or(0)),
             static_cast<double>(loads_taken_[name]));
    } else if (dig.trucks > 0) {
      expect("trucks", static_cast<double>(row.trucks.value_or(0)),
             static_cast<double>(dig.trucks));
      expect("load", row.load.value_or(0), metres(dig.load));
    }
    require(row.waited >= 0 && seconds(row.waited) <= all + kSlack, "waited");
  }

  /// Tasks that haul for a dig.
  std::int64_t trucks_of(const std::string& dig) const {
    return std::count_if(
        trace_.scene.tasks.begin(), trace_.scene.tasks.end(), [&](const SceneTask& task) {
          return task.haul && std::find(task.haul->digs.begin(), task.haul->digs.end(), dig) !=
                                  task.haul->digs.end();
        });
  }

  void check_haul(int run, const std::vector<LoadTold>& told, const RowHaul& row) {
    if (row.loads.size() != told.size()) {
      fault(fmt::format("earthwork: it hauled {} loads, by the trace {}", row.loads.size(),
                        told.size()));
      return;
    }
    std::int64_t hauled = 0;
    RowHaul means;
    Ticks before = 0;
    for (std::size_t i = 0; i < told.size(); ++i) {
      const RowLoad& load = row.loads[i];
      const LoadTold& expected = told[i];
      const bool same = load.dig == expected.dig &&
                        is_figure(load.volume, metres(expected.volume)) &&
                        is_at(load.began, expected.began) && is_at(load.loaded, expected.loaded);
      if (!same) fault(fmt::format("earthwork: load {} is another in the trace", i + 1));
      require(load.arrived >= before && load.arrived <= load.began, "arrived");
      // The soil falls while it tips.
      const bool tips = load.at_tip >= load.loaded && load.at_tip <= expected.fell &&
                        load.tipped >= expected.fell;
      require(tips, "tipped");
      hauled += expected.volume;
      means.queue += seconds(load.began - load.arrived);
      means.loading += seconds(load.loaded - load.began);
      means.haul += seconds(load.at_tip - load.loaded);
      means.tip += seconds(load.tipped - load.at_tip);
      if (i > 0) means.back += seconds(load.arrived - before);
      before = load.tipped;
    }
    const auto count = static_cast<double>(told.size());
    expect("hauled", row.hauled, metres(hauled));
    expect("working", seconds(row.working), seconds(worked(run, runs_[at(run)].end)));
    if (count == 0) return;
    expect("queue", row.queue, means.queue / count);
    expect("loading", row.loading, means.loading / count);
    expect("haul", row.haul, means.haul / count);
    expect("tip", row.tip, means.tip / count);
    expect("back", row.back, count > 1 ? means.back / (count - 1) : 0);
  }

  static bool is_at(Ticks found, Ticks expected) {
    return std::fabs(seconds(found - expected)) <= kSlack;
  }

  /// The rows of loads.csv against those of schedule.json; rounded to ms.
  void check_listed(const RowHaul& row, const std::vector<LoadRow>& loads) {
    std::size_t number = 0;
    const auto differs = [&](const LoadRow& listed) {
      faults_.push_back({FaultKind::schedule, ResultFile::loads_csv, listed.line, row_->task,
                         row_->start,
                         fmt::format("load {} is not that of schedule.json", listed.number)});
    };
    for (const LoadRow& listed : loads) {
      if (listed.task != row_->task) continue;
      if (number == row.loads.size()) return differs(listed);
      const RowLoad& load = row.loads[number++];
      const auto is_rounded = [](double found, Ticks time) {
        return std::fabs(found - seconds(time)) <= 0.0005 + 1e-6 + 1e-12 * std::fabs(found);
      };
      const bool same =
          listed.number == static_cast<std::int64_t>(number) && listed.truck == 1 &&
          listed.by == load.dig && is_rounded(listed.arrived, load.arrived) &&
          is_rounded(listed.began, load.began) && is_rounded(listed.loaded, load.loaded) &&
          is_rounded(listed.tipped, load.tipped) && std::fabs(listed.volume - load.volume) <= 1e-6;
      if (!same) return differs(listed);
    }
    if (number == row.loads.size()) return;
    faults_.push_back({FaultKind::schedule, ResultFile::loads_csv, 1, row_->task, row_->start,
                       fmt::format("it lists {} loads of {}", number, row.loads.size())});
  }

  /// All hauls together, with what dug it: as their rows, which were looked at, tell.
  void check_together() {
    row_ = nullptr;
    double volume = 0, working = 0, cost = 0, fuel = 0;
    double trucks = 0, loading = 0, round = 0;
    std::set<std::string> diggers;
    bool any = false;
    for (const ScheduleRow& row : schedule_.rows) {
      const auto known = trace_.scene.task_index.find(row.task);
      if (known == trace_.scene.task_index.end()) continue;
      const SceneTask& task = trace_.scene.tasks[at(known->second)];
      const bool dug = row.motion_dig && task.motion_dig && trucks_of(task.name) > 0;
      if (dug) diggers.insert(row.robot);
      if (dug || row.haul) {
        cost += row.cost.value_or(0);
        fuel += row.fuel.value_or(0);
      }
      if (!row.haul) continue;
      any = true;
      volume += row.haul->hauled;
      working = std::max(working, seconds(row.haul->working));
      if (row.haul->loads.size() < 2) continue;
      ++trucks;
      loading += row.haul->loading;
      round += row.haul->loading + row.haul->haul + row.haul->tip + row.haul->back;
    }
    if (schedule_.hauling.has_value() != any) {
      fault("earthwork: what was hauled together is not told, or nothing was hauled");
      return;
    }
    if (!any) return;
    const HaulingRow& together = *schedule_.hauling;
    expect("hauled", together.hauled, volume);
    expect("working", together.working, working);
    expect("per_hour", together.per_hour, working > 0 ? volume / working * 3600 : 0);
    if (volume > 0) {
      expect("cost_per_m3", together.cost_per_m3, cost / volume);
      expect("fuel_per_m3", together.fuel_per_m3, fuel / volume);
    }
    const bool has_match = trucks > 0 && !diggers.empty() && round > 0;
    require(together.match_factor.has_value() == has_match, "match_factor");
    if (has_match) {
      expect("match_factor", together.match_factor,
             trucks * loading / (static_cast<double>(diggers.size()) * round));
    }
  }

  const Trace& trace_;
  const std::vector<TaskRun>& runs_;
  const WorkingHours& hours_;
  const ScheduleJson& schedule_;
  Faults& faults_;
  const ScheduleRow* row_ = nullptr;
  std::map<int, int> run_of_;  ///< by task, of those that happened
  std::map<int, std::vector<LoadTold>> loads_of_;
  std::map<std::string, std::int64_t> loads_taken_;  ///< by dig
};

}  // namespace

void check_earth_rows(const Trace& trace, const std::vector<TaskRun>& runs,
                      const WorkingHours& hours, const ScheduleJson& schedule,
                      const std::optional<std::vector<LoadRow>>& loads, Faults& faults) {
  EarthRows(trace, runs, hours, schedule, faults).check(loads);
}

}  // namespace rubicon::verify
