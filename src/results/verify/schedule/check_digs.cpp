#include "src/results/verify/schedule/check_digs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

namespace rubicon::verify {

namespace {

/// Rounds times trucks beyond which they are not gone through.
constexpr double kMostWork = 2e8;

/// More loads than this are not compared one by one.
constexpr std::int64_t kMostLoads = 2'000'000;

/// Of a queue: before the diggers of a crew, or before those of a stage who serve.
struct Served {
  std::int64_t count = 0;
  Ticks waited = 0, longest = 0;  ///< by these
  Ticks in_all = 0;               ///< by those too whose turn did not come
};

/// A load that was tipped.
struct RoundLoad {
  std::int64_t number = 0, volume = 0;
  int truck = 0;
  int digger = -1;  ///< crew; -1: it was loaded before
  Ticks arrived = 0, began = 0, loaded = 0, tipped = 0;
};

/// What came of the rounds.
struct Rounds {
  Ticks time = 0;
  std::int64_t loads = 0, tipped = 0, passes = 0;
  std::vector<Served> queues;       ///< in the order of `serving`
  std::vector<RoundLoad> tippings;  ///< where asked for, in their order
  double driving = 0;               ///< s, of all trucks together
  std::vector<double> serving;  ///< s, of the diggers of each crew, then those of each stage served
};

/// Goes through the rounds: of all trucks, which are in a list, the next event is looked for anew.
class RoundsReplay {
 public:
  explicit RoundsReplay(const SceneDig& dig, bool keeps_loads = false)
      : dig_(dig), keeps_loads_(keeps_loads), soil_(dig.volume), uses_(dig.stages.size() + 1, 0) {
    trucks_.resize(static_cast<std::size_t>(dig.trucks));
    free_ = dig.diggers;
    for (const SceneStage& stage : dig.stages) free_.push_back(stage.servers);
    serving_.resize(free_.size(), 0);
    queues_.resize(free_.size());
  }

  Rounds run() {
    for (std::size_t i = 0; i < trucks_.size(); ++i) {
      Truck& truck = trucks_[i];
      if (static_cast<int>(i) < dig_.loaded && soil_ > 0) {
        take_soil(truck, -1);
        truck.load.arrived = now_;
        go(truck, 0);
      } else {
        come(truck);
      }
    }
    Rounds rounds;
    while (rounds.tipped < dig_.volume) {
      Truck* const next = next_event();
      if (next == nullptr || (dig_.limit > 0 && next->until > dig_.limit)) {
        now_ = dig_.limit;
        break;
      }
      now_ = next->until;
      next->state = State::idle;
      const int place = next->place;
      const int stage = next->stage;
      if (stage < 0) next->load.loaded = now_;
      if (stage == static_cast<int>(dig_.tip)) {
        ++rounds.loads;
        rounds.tipped += next->load.volume;
        next->load.tipped = now_;
        if (keeps_loads_) rounds.tippings.push_back(next->load);
        if (rounds.tipped == dig_.volume) break;
      }
      if (place >= 0) ++free_[at(place)];
      if (at(stage + 1) < dig_.stages.size()) {
        go(*next, stage + 1);
      } else {
        come(*next);
      }
      if (place >= 0) serve(place);
    }
    rounds.time = now_;
    rounds.passes = passes_;
    for (const Truck& truck : trucks_) {
      if (truck.state == State::waits) queues_[at(truck.place)].in_all += now_ - truck.since;
    }
    count_work(rounds);
    return rounds;
  }

 private:
  enum class State { idle, waits, busy };
  struct Truck {
    State state = State::idle;
    int stage = -1;  ///< -1: it is loaded
    int place = -1;  ///< queue or server: the diggers first, then those of each stage; -1: none
    Ticks until = 0;
    RoundLoad load;
    Ticks since = 0;         ///< it waits
    std::int64_t order = 0;  ///< of what it began last: to wait, or what goes on
  };

  /// All that began, without what the end cuts off.
  void count_work(Rounds& rounds) const {
    long double driving = driving_;
    std::vector<long double> serving = serving_;
    for (const Truck& truck : trucks_) {
      if (truck.state != State::busy || truck.until <= now_) continue;
      const Ticks rest = truck.until - now_;
      if (truck.stage >= 0) driving -= rest;
      if (truck.place >= 0) serving[at(truck.place)] -= rest;
    }
    const auto seconds = [](long double time) {
      return static_cast<double>(time / static_cast<long double>(kSecond));
    };
    rounds.driving = seconds(driving);
    for (std::size_t k = 0; k < serving.size(); ++k) {
      if (k < dig_.diggers.size() || dig_.stages[k - dig_.diggers.size()].servers > 0) {
        rounds.serving.push_back(seconds(serving[k]));
        rounds.queues.push_back(queues_[k]);
      }
    }
  }

  static std::size_t at(int index) { return static_cast<std::size_t>(index); }
  int diggers() const { return static_cast<int>(dig_.diggers.size()); }

  Ticks duration(int stage) {
    const SceneStage& each = stage < 0 ? dig_.loading : dig_.stages[at(stage)];
    const std::size_t use = uses_[at(stage + 1)]++;
    const double seconds =
        each.law == "sequence" ? each.values[use % each.values.size()] : each.seconds;
    return std::llround(seconds / dig_.efficiency * static_cast<double>(kSecond));
  }

  void take_soil(Truck& truck, int digger) {
    RoundLoad& load = truck.load;
    load.number = ++begun_;
    load.truck = static_cast<int>(&truck - trucks_.data());
    load.digger = digger;
    load.volume = std::min(dig_.load, soil_);
    load.began = load.loaded = now_;
    soil_ -= load.volume;
  }

  void begin(Truck& truck, int stage, int place) {
    truck.state = State::busy;
    truck.stage = stage;
    truck.place = place;
    Ticks time = 0;
    std::int64_t passes = 1;
    if (stage < 0 && dig_.bucket > 0) {
      passes = (truck.load.volume + dig_.bucket - 1) / dig_.bucket;
      passes_ += passes;
    }
    for (std::int64_t i = 0; i < passes; ++i) time += duration(stage);
    truck.until = now_ + time;
    if (stage >= 0) driving_ += time;
    if (place >= 0) serving_[at(place)] += time;
    truck.order = ++order_;
  }

  void queue(Truck& truck, int stage, int place) {
    truck.state = State::waits;
    truck.stage = stage;
    truck.place = place;
    truck.since = now_;
    truck.order = ++order_;
    serve(place);
  }

  void go(Truck& truck, int stage) {
    if (dig_.stages[at(stage)].servers > 0) {
      queue(truck, stage, diggers() + stage);
    } else {
      begin(truck, stage, -1);
    }
  }

  void come(Truck& truck) {
    if (soil_ == 0) return;
    int best = 0;
    double fewest = std::numeric_limits<double>::infinity();
    for (int k = 0; k < diggers(); ++k) {
      const auto there = std::count_if(trucks_.begin(), trucks_.end(), [&](const Truck& other) {
        return other.state != State::idle && other.stage < 0 && other.place == k;
      });
      const double length = static_cast<double>(there) / dig_.diggers[at(k)];
      if (length >= fewest) continue;
      fewest = length;
      best = k;
    }
    truck.load.arrived = now_;
    queue(truck, -1, best);
  }

  /// The one that has waited longest at the place goes on, while somebody is free there.
  void serve(int place) {
    while (free_[at(place)] > 0) {
      Truck* first = nullptr;
      for (Truck& truck : trucks_) {
        if (truck.state != State::waits || truck.place != place) continue;
        if (first == nullptr || truck.order < first->order) first = &truck;
      }
      if (first == nullptr) return;
      if (place < diggers()) {
        if (soil_ == 0) {
          send_home(place);
          return;
        }
        take_soil(*first, place);
      }
      Served& queue = queues_[at(place)];
      const Ticks waited = now_ - first->since;
      ++queue.count;
      queue.waited += waited;
      queue.in_all += waited;
      queue.longest = std::max(queue.longest, waited);
      --free_[at(place)];
      begin(*first, first->stage, place);
    }
  }

  /// No soil is left for those who wait.
  void send_home(int place) {
    for (Truck& truck : trucks_) {
      if (truck.state != State::waits || truck.place != place) continue;
      queues_[at(place)].in_all += now_ - truck.since;
      truck.state = State::idle;
    }
  }

  /// Of the same moment: served ones first, the last of the round before the others; then those by
  /// themselves; then who began first.
  Truck* next_event() {
    Truck* next = nullptr;
    const auto key = [&](const Truck& truck) {
      const bool alone = truck.place < 0;
      return std::tuple(truck.until, alone, alone ? truck.stage : -truck.stage, truck.order);
    };
    for (Truck& truck : trucks_) {
      if (truck.state != State::busy) continue;
      if (next == nullptr || key(truck) < key(*next)) next = &truck;
    }
    return next;
  }

  const SceneDig& dig_;
  bool keeps_loads_;
  Ticks now_ = 0;
  std::int64_t begun_ = 0, passes_ = 0;
  std::vector<Served> queues_;  ///< at each place
  std::int64_t soil_;
  std::int64_t order_ = 0;
  std::vector<Truck> trucks_;
  std::vector<int> free_;
  long double driving_ = 0;           ///< of all that began
  std::vector<long double> serving_;  ///< at each place
  std::vector<std::size_t> uses_;
};

bool is_certain(const SceneStage& stage) { return stage.law.empty() || stage.law == "sequence"; }

bool is_certain(const SceneDig& dig) {
  return is_certain(dig.loading) && std::all_of(dig.stages.begin(), dig.stages.end(),
                                                [](const SceneStage& s) { return is_certain(s); });
}

/// The least seconds of a stage.
double least_of(const SceneStage& stage, const Scene& scene) {
  if (stage.times >= 0) return scene.times[static_cast<std::size_t>(stage.times)].times.front();
  const bool is_bounded = stage.law == "uniform" || stage.law == "triangular" ||
                          stage.law == "pert" || stage.law == "sequence";
  if (stage.law.empty()) return stage.seconds;
  return is_bounded && !stage.values.empty()
             ? *std::min_element(stage.values.begin(), stage.values.end())
             : 0;
}

std::string seconds_text(Ticks time) {
  return fmt::format("{:g} s", static_cast<double>(time) / static_cast<double>(kSecond));
}

bool is_near(double a, double b) { return std::fabs(a - b) <= 1e-6 + 1e-9 * std::fabs(b); }

/// What is wrong with the time that trucks drive and others serve them; "" if nothing is. Where
/// durations were drawn it is held against what the time and the least durations allow.
std::string work_fault(const SceneDig& dig, const TaskEnd& told, const Rounds* rounds,
                       const Scene& scene) {
  if (!told.driving) return {};
  std::vector<int> servers = dig.diggers;
  double to_tip = 0;
  for (std::size_t i = 0; i < dig.stages.size(); ++i) {
    if (dig.stages[i].servers > 0) servers.push_back(dig.stages[i].servers);
    if (i <= dig.tip) to_tip += least_of(dig.stages[i], scene) / dig.efficiency;
  }
  if (told.serving.size() != servers.size()) return "it does not tell how long each serves trucks";
  if (rounds != nullptr) {
    for (std::size_t i = 0; i < servers.size(); ++i) {
      if (is_near(told.serving[i], rounds->serving[i])) continue;
      return fmt::format("its trucks are served for {:g} s, by its rounds {:g} s", told.serving[i],
                         rounds->serving[i]);
    }
    if (is_near(*told.driving, rounds->driving)) return {};
    return fmt::format("its trucks drive for {:g} s, by its rounds {:g} s", *told.driving,
                       rounds->driving);
  }
  const double time = static_cast<double>(dig.time) / static_cast<double>(kSecond);
  const double slack = 1e-6 + 1e-9 * time * dig.trucks;
  double loading = 0, serving = 0;
  for (std::size_t i = 0; i < servers.size(); ++i) {
    if (told.serving[i] < -slack || told.serving[i] > servers[i] * time + slack) {
      return fmt::format("trucks are served for {:g} s by {} in {:g} s", told.serving[i],
                         servers[i], time);
    }
    (i < dig.diggers.size() ? loading : serving) += told.serving[i];
  }
  const double most = dig.trucks * time - loading;
  const double least = std::max(serving, static_cast<double>(dig.loads) * to_tip);
  if (*told.driving >= least - slack && *told.driving <= most + slack) return {};
  return fmt::format("its trucks drive for {:g} s, and that is from {:g} s to {:g} s",
                     *told.driving, least, most);
}

/// What is wrong with the result of a dig; "" if nothing is.
std::string fault_of(const SceneDig& dig, const TaskEnd* told, const Scene& scene) {
  const bool sampled = scene.sampled;
  const std::int64_t all = (dig.volume + dig.load - 1) / dig.load;
  const bool is_complete = dig.tipped == dig.volume;
  // The last load is what is left, and may overtake one before it.
  const auto fits = [&] {
    const std::int64_t with_last = (dig.loads - 1) * dig.load + dig.volume - (all - 1) * dig.load;
    return dig.tipped == dig.loads * dig.load || dig.tipped == with_last;
  };
  if (dig.loads < 0 || dig.loads > all || (is_complete ? dig.loads != all : !fits())) {
    return fmt::format("{} loads of {} mm3 are not the {} mm3 that it tips", dig.loads, dig.load,
                       dig.tipped);
  }
  if (!is_complete && dig.limit == 0) return "it leaves soil and has no limit";
  if (!is_complete && dig.time != dig.limit) return "it leaves soil before its limit";
  if (dig.limit > 0 && dig.time > dig.limit) return "it goes on after its limit";
  if (!sampled || is_certain(dig)) {
    if (static_cast<double>(all) * dig.trucks > kMostWork) return {};
    const Rounds rounds = RoundsReplay(dig).run();
    if (rounds.time == dig.time && rounds.loads == dig.loads && rounds.tipped == dig.tipped) {
      return told != nullptr ? work_fault(dig, *told, &rounds, scene) : std::string();
    }
    return fmt::format("it tips {} loads in {}, and its rounds {} in {}", dig.loads,
                       seconds_text(dig.time), rounds.loads, seconds_text(rounds.time));
  }
  int diggers = 0;
  for (const int each : dig.diggers) diggers += each;
  const std::int64_t passes = dig.bucket > 0 ? dig.load / dig.bucket : 1;
  const double full = static_cast<double>(std::max<std::int64_t>(dig.loads - 1 - dig.loaded, 0));
  const double least = full / diggers * static_cast<double>(passes) * least_of(dig.loading, scene) /
                       dig.efficiency * static_cast<double>(kSecond);
  if (static_cast<double>(dig.time) + 1 >= least * (1 - 1e-9)) {
    return told != nullptr ? work_fault(dig, *told, nullptr, scene) : std::string();
  }
  return fmt::format("it takes {}, and its diggers need {:g} s at least", seconds_text(dig.time),
                     least / static_cast<double>(kSecond));
}

/// m3 of the boxes of the soil that a dig takes away; nothing where there is no such component.
std::optional<double> soil_volume(const Scene& scene, const std::string& soil) {
  const auto found = scene.component_index.find(soil);
  if (found == scene.component_index.end()) return std::nullopt;
  double sum = 0;
  for (const ShapeData& shape : scene.components[static_cast<std::size_t>(found->second)].shapes) {
    if (shape.kind != ShapeData::Kind::box) return std::nullopt;
    sum += (shape.b - shape.a).prod();
  }
  return sum;
}

class DigRowCheck {
 public:
  DigRowCheck(const Scene& scene, const SceneDig& dig, const TaskEnd* told, const ScheduleRow& row,
              Faults& faults)
      : scene_(scene), dig_(dig), told_(told), row_(row), found_(*row.dig), faults_(faults) {
    const double all = static_cast<double>((dig.volume + dig.load - 1) / dig.load) * dig.trucks;
    if ((!scene.sampled || is_certain(dig)) && all <= kMostWork) {
      rounds_ = RoundsReplay(dig, dig.loads <= kMostLoads).run();
    }
  }

  void check_figures() {
    const double tipped = metres(dig_.tipped);
    expect("volume", found_.volume, metres(dig_.volume));
    expect("tipped", found_.tipped, tipped);
    expect("load", found_.load, metres(dig_.load));
    expect("loads", static_cast<double>(found_.loads), static_cast<double>(dig_.loads));
    expect("working", seconds(found_.working), seconds(dig_.time));
    expect("per_hour", found_.per_hour, dig_.time > 0 ? tipped / seconds(dig_.time) * 3600 : 0);
    if (found_.cost_per_m3 && row_.cost)
      expect("cost_per_m3", *found_.cost_per_m3, *row_.cost / tipped);
    if (found_.fuel_per_m3 && row_.fuel)
      expect("fuel_per_m3", *found_.fuel_per_m3, *row_.fuel / tipped);
    expect("trucks", found_.trucks, dig_.trucks);
    const std::int64_t passes = dig_.bucket > 0 ? (dig_.load + dig_.bucket - 1) / dig_.bucket : 1;
    const double loading = static_cast<double>(passes) * dig_.loading.seconds / dig_.efficiency;
    double round = loading;
    for (const SceneStage& stage : dig_.stages) round += stage.seconds / dig_.efficiency;
    int diggers = 0;
    for (const int each : dig_.diggers) diggers += each;
    expect("mean_loading", found_.mean_loading, loading);
    expect("mean_round", found_.mean_round, round);
    expect("match_factor", found_.match_factor, dig_.trucks * loading / (diggers * round));
    if (found_.passes && rounds_) {
      expect("passes", static_cast<double>(*found_.passes), static_cast<double>(rounds_->passes));
    }
    check_queues();
  }

  /// Each load of a file; rounds that are not gone through again have only as many.
  void check_loads(const std::vector<const LoadRow*>& loads) {
    if (static_cast<std::int64_t>(loads.size()) != dig_.loads) {
      fault(ResultFile::loads_csv, loads.empty() ? 0 : loads.front()->line,
            fmt::format("dig: {} loads are listed, and it tips {}", loads.size(), dig_.loads));
      return;
    }
    if (!rounds_ || rounds_->tippings.size() != loads.size()) return;
    for (std::size_t i = 0; i < loads.size(); ++i) {
      const LoadRow& row = *loads[i];
      const RoundLoad& load = rounds_->tippings[i];
      const std::string by =
          load.digger < 0 ? ""
                          : crew_name(dig_.digger_crews[static_cast<std::size_t>(load.digger)]);
      constexpr double kRounded = 0.0005 + 1e-6;  // s
      const auto is_at = [&](double found, Ticks time) {
        return std::fabs(found - seconds(time)) <= kRounded + 1e-12 * std::fabs(found);
      };
      const bool same = row.number == load.number && row.truck == load.truck + 1 && row.by == by &&
                        is_at(row.arrived, load.arrived) && is_at(row.began, load.began) &&
                        is_at(row.loaded, load.loaded) && is_at(row.tipped, load.tipped) &&
                        std::fabs(row.volume - metres(load.volume)) <= 1e-6;
      if (same) continue;
      fault(ResultFile::loads_csv, row.line,
            fmt::format("dig: load {} is not that of its rounds", row.number));
      return;
    }
  }

 private:
  static double metres(std::int64_t volume) { return static_cast<double>(volume) * 1e-9; }
  static double seconds(Ticks time) {
    return static_cast<double>(time) / static_cast<double>(kSecond);
  }
  const std::string& crew_name(int crew) const {
    return scene_.crews[static_cast<std::size_t>(crew)].name;
  }

  void fault(ResultFile file, int line, std::string text) {
    faults_.push_back({FaultKind::schedule, file, line, row_.task, row_.start, std::move(text)});
  }

  void expect(const std::string& what, double found, double expected) {
    if (is_near(found, expected)) return;
    fault(ResultFile::schedule_json, row_.line,
          fmt::format("dig: '{}' is {:.10g}, by the trace {:.10g}", what, found, expected));
  }

  void check_queues() {
    std::vector<RowQueue> expected;
    for (std::size_t i = 0; i < dig_.diggers.size(); ++i) {
      expected.push_back({"load", crew_name(dig_.digger_crews[i]), dig_.diggers[i], 0, 0, 0, 0, 0});
    }
    for (const SceneStage& stage : dig_.stages) {
      if (stage.servers == 0) continue;
      expected.push_back({stage.name, crew_name(stage.crew), stage.servers, 0, 0, 0, 0, 0});
    }
    if (found_.queues.size() != expected.size()) {
      fault(ResultFile::schedule_json, row_.line,
            fmt::format("dig: it has {} queues, by the trace {}", found_.queues.size(),
                        expected.size()));
      return;
    }
    for (std::size_t i = 0; i < expected.size(); ++i) {
      const RowQueue& queue = found_.queues[i];
      const std::string name = fmt::format("queue of {} ", expected[i].by);
      if (queue.stage != expected[i].stage || queue.by != expected[i].by ||
          queue.servers != expected[i].servers) {
        fault(ResultFile::schedule_json, row_.line,
              fmt::format("dig: the {}is another in the trace", name));
        continue;
      }
      check_queue(name, queue, i);
    }
  }

  void check_queue(const std::string& name, const RowQueue& queue, std::size_t i) {
    const double time = seconds(dig_.time);
    const double longest = seconds(queue.longest_wait);
    const std::vector<double>* const serving = rounds_ ? &rounds_->serving
                                               : told_ != nullptr && told_->driving
                                                   ? &told_->serving
                                                   : nullptr;
    if (serving != nullptr && i < serving->size() && time > 0) {
      expect(name + "utilisation", queue.utilisation, (*serving)[i] / (time * queue.servers));
    }
    if (!rounds_) {
      const bool may_be = queue.utilisation >= 0 && queue.utilisation <= 1 + 1e-9 &&
                          queue.served >= 0 && queue.mean_wait >= 0 &&
                          queue.mean_wait <= longest + 1e-6 && longest <= time + 1e-6 &&
                          queue.mean_length >= 0 && queue.mean_length <= dig_.trucks;
      if (!may_be) {
        fault(ResultFile::schedule_json, row_.line, fmt::format("dig: the {}cannot be so", name));
      }
      return;
    }
    const Served& served = rounds_->queues[i];
    const auto count = static_cast<double>(served.count);
    expect(name + "served", static_cast<double>(queue.served), count);
    expect(name + "mean_wait", queue.mean_wait,
           served.count > 0 ? seconds(served.waited) / count : 0);
    expect(name + "longest_wait", longest, seconds(served.longest));
    expect(name + "mean_length", queue.mean_length, time > 0 ? seconds(served.in_all) / time : 0);
  }

  const Scene& scene_;
  const SceneDig& dig_;
  const TaskEnd* told_;
  const ScheduleRow& row_;
  const RowDig& found_;
  Faults& faults_;
  std::optional<Rounds> rounds_;
};

/// The ends of tasks that happened, by task.
std::map<int, const TaskEnd*> task_ends(const Trace& trace, const std::vector<TaskRun>& runs) {
  std::map<int, const TaskEnd*> ends;
  for (const TaskRun& run : runs) {
    if (!run.happened || run.task < 0 || run.records.empty()) continue;
    const Record& last = trace.records[static_cast<std::size_t>(run.records.back())];
    if (const auto* end = std::get_if<TaskEnd>(&last.what)) ends[run.task] = end;
  }
  return ends;
}

}  // namespace

void check_digs(const Trace& trace, const std::vector<TaskRun>& runs, Faults& faults) {
  const std::map<int, const TaskEnd*> ends = task_ends(trace, runs);
  for (std::size_t i = 0; i < trace.scene.tasks.size(); ++i) {
    const SceneTask& task = trace.scene.tasks[i];
    if (!task.dig) continue;
    const auto end = ends.find(static_cast<int>(i));
    std::string text = fault_of(*task.dig, end == ends.end() ? nullptr : end->second, trace.scene);
    // Whole ns of long times are no longer whole as seconds.
    const Ticks slack = 1 + task.dig->time / 1'000'000'000'000'000;
    const bool is_its_work =
        task.takes.size() == 1 && std::llabs(task.takes.front().time - task.dig->time) <= slack;
    if (text.empty() && !is_its_work) text = "its work is not as long as its rounds";
    if (text.empty() && !task.dig->soil.empty()) {
      const double volume = static_cast<double>(task.dig->volume) * 1e-9;
      const auto soil = soil_volume(trace.scene, task.dig->soil);
      if (!soil || std::fabs(*soil - volume) > 1e-9 * volume) {
        text = fmt::format("it hauls {:.3f} m3, which is not the soil that it takes away", volume);
      }
    }
    if (text.empty()) continue;
    faults.push_back({FaultKind::schedule, ResultFile::trace, 1, task.name, -1, "dig: " + text});
  }
}

void check_dig_rows(const Trace& trace, const std::vector<TaskRun>& runs,
                    const std::vector<ScheduleRow>& rows,
                    const std::optional<std::vector<LoadRow>>& loads, Faults& faults) {
  const std::map<int, const TaskEnd*> ends = task_ends(trace, runs);
  std::map<std::string, std::vector<const LoadRow*>> loads_of;
  if (loads) {
    for (const LoadRow& load : *loads) loads_of[load.task].push_back(&load);
  }
  for (const ScheduleRow& row : rows) {
    const auto known = trace.scene.task_index.find(row.task);
    const SceneTask* const task = known == trace.scene.task_index.end()
                                      ? nullptr
                                      : &trace.scene.tasks[static_cast<std::size_t>(known->second)];
    const bool digs = task != nullptr && task->dig && row.result == "done";
    const bool has_loads = digs || (task != nullptr && (task->motion_dig || task->haul));
    if (const auto its = loads_of.find(row.task); its != loads_of.end() && !has_loads) {
      faults.push_back({FaultKind::schedule, ResultFile::loads_csv, its->second.front()->line,
                        row.task, row.start, "it is listed with loads, and hauls none"});
    }
    if (row.dig.has_value() != digs) {
      faults.push_back({FaultKind::schedule, ResultFile::schedule_json, row.line, row.task,
                        row.start, "what it dug is not told, or the trace has nothing of it"});
    } else if (digs) {
      const auto end = ends.find(known->second);
      DigRowCheck check(trace.scene, *task->dig, end == ends.end() ? nullptr : end->second, row,
                        faults);
      check.check_figures();
      if (loads) check.check_loads(loads_of[row.task]);
    }
    loads_of.erase(row.task);
  }
  for (const auto& [name, its] : loads_of) {
    faults.push_back({FaultKind::schedule, ResultFile::loads_csv, its.front()->line, name, -1,
                      "the schedule has no such task"});
  }
}

}  // namespace rubicon::verify
