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

/// What came of the rounds.
struct Rounds {
  Ticks time = 0;
  std::int64_t loads = 0, tipped = 0;
  double driving = 0;           ///< s, of all trucks together
  std::vector<double> serving;  ///< s, of the diggers of each crew, then those of each stage served
};

/// Goes through the rounds: of all trucks, which are in a list, the next event is looked for anew.
class RoundsReplay {
 public:
  explicit RoundsReplay(const SceneDig& dig)
      : dig_(dig), soil_(dig.volume), uses_(dig.stages.size() + 1, 0) {
    trucks_.resize(static_cast<std::size_t>(dig.trucks));
    free_ = dig.diggers;
    for (const SceneStage& stage : dig.stages) free_.push_back(stage.servers);
    serving_.resize(free_.size(), 0);
  }

  Rounds run() {
    for (std::size_t i = 0; i < trucks_.size(); ++i) {
      Truck& truck = trucks_[i];
      if (static_cast<int>(i) < dig_.loaded && soil_ > 0) {
        take_soil(truck);
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
      if (stage == static_cast<int>(dig_.tip)) {
        ++rounds.loads;
        rounds.tipped += next->load;
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
    std::int64_t load = 0;
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

  void take_soil(Truck& truck) {
    truck.load = std::min(dig_.load, soil_);
    soil_ -= truck.load;
  }

  void begin(Truck& truck, int stage, int place) {
    truck.state = State::busy;
    truck.stage = stage;
    truck.place = place;
    Ticks time = 0;
    std::int64_t passes = 1;
    if (stage < 0 && dig_.bucket > 0) passes = (truck.load + dig_.bucket - 1) / dig_.bucket;
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
        if (soil_ == 0) return;
        take_soil(*first);
      }
      --free_[at(place)];
      begin(*first, first->stage, place);
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
  Ticks now_ = 0;
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

}  // namespace

void check_digs(const Trace& trace, const std::vector<TaskRun>& runs, Faults& faults) {
  std::map<int, const TaskEnd*> ends;  // by task
  for (const TaskRun& run : runs) {
    if (!run.happened || run.task < 0 || run.records.empty()) continue;
    const Record& last = trace.records[static_cast<std::size_t>(run.records.back())];
    if (const auto* end = std::get_if<TaskEnd>(&last.what)) ends[run.task] = end;
  }
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

}  // namespace rubicon::verify
