#include "src/results/verify/schedule/check_digs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

namespace rubicon::verify {

namespace {

/// Rounds times trucks beyond which they are not gone through.
constexpr double kMostWork = 2e8;

/// What came of the rounds.
struct Rounds {
  Ticks time = 0;
  std::int64_t loads = 0, tipped = 0;
};

/// Goes through the rounds: of all trucks, which are in a list, the next event is looked for anew.
class RoundsReplay {
 public:
  explicit RoundsReplay(const SceneDig& dig)
      : dig_(dig), soil_(dig.volume), uses_(dig.stages.size() + 1, 0) {
    trucks_.resize(static_cast<std::size_t>(dig.trucks));
    free_ = dig.diggers;
    for (const SceneStage& stage : dig.stages) free_.push_back(stage.servers);
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

/// What is wrong with the result of a dig; "" if nothing is.
std::string fault_of(const SceneDig& dig, const Scene& scene) {
  const bool sampled = scene.sampled;
  const std::int64_t all = (dig.volume + dig.load - 1) / dig.load;
  const bool is_complete = dig.tipped == dig.volume;
  if (is_complete ? dig.loads != all : dig.tipped != dig.loads * dig.load) {
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
      return {};
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
  if (static_cast<double>(dig.time) + 1 >= least * (1 - 1e-9)) return {};
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

void check_digs(const Trace& trace, Faults& faults) {
  for (const SceneTask& task : trace.scene.tasks) {
    if (!task.dig) continue;
    std::string text = fault_of(*task.dig, trace.scene);
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
