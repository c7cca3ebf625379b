#include "src/earth/hauling/hauling.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <queue>
#include <tuple>

namespace rubicon::hauling {

namespace {

/// Of one stage, s.
constexpr double kMostSeconds = 2e9;

/// Draws of one stage, one after the other.
class Clock {
 public:
  Clock(const StageTime& time, const std::optional<Draws>& draws, const std::string& stage,
        double efficiency)
      : time_(time), efficiency_(efficiency) {
    if (!draws) return;
    seed_ = draws->seed;
    run_ = draws->run;
    place_ = std::string(draws->task) + "." + stage;
  }

  Nanoseconds next() {
    double seconds = time_.seconds;
    if (time_.law && (time_.law->is_certain() || !place_.empty())) {
      seconds = sampling::draw(*time_.law, {seed_, run_, place_, uses_});
    }
    ++uses_;
    return std::llround(std::min(seconds / efficiency_, kMostSeconds) * kPerSecond);
  }

 private:
  const StageTime& time_;
  double efficiency_;
  std::uint64_t seed_ = 1, run_ = 0;
  std::string place_;
  std::uint64_t uses_ = 0;
};

/// What ends: a stage of a truck, -1 its loading.
struct Event {
  Nanoseconds time = 0;
  int rank = 0;
  std::uint64_t order = 0;
  int truck = 0;
  int stage = -1;

  bool operator>(const Event& other) const {
    return std::tie(time, rank, order) > std::tie(other.time, other.rank, other.order);
  }
};

class Run {
 public:
  Run(const Operation& operation, const std::optional<Draws>& draws,
      const std::function<void(const Load&)>& on_load)
      : operation_(operation),
        on_load_(on_load),
        loading_(operation.loading, draws, "load", operation.efficiency),
        end_(std::min(operation.until.value_or(kLongest), kLongest)),
        soil_(operation.volume),
        trucks_(static_cast<std::size_t>(operation.trucks)) {
    for (const Diggers& each : operation.diggers) add_station("load", each.name, each.count);
    for (const Stage& each : operation.stages) {
      clocks_.emplace_back(each.time, draws, each.name, operation.efficiency);
      station_of_.push_back(each.servers > 0 ? static_cast<int>(stations_.size()) : -1);
      if (each.servers > 0) add_station(each.name, each.by, each.servers);
    }
  }

  Result run() {
    for (int truck = 0; truck < operation_.trucks; ++truck) {
      if (truck < operation_.loaded && soil_ > 0) {
        take_soil(truck, -1);
        enter(truck, 0);
      } else {
        join(truck);
      }
    }
    while (!events_.empty() && events_.top().time <= end_) {
      const Event event = events_.top();
      events_.pop();
      now_ = event.time;
      finish(event);
      if (result_.tipped == operation_.volume) break;
    }
    result_.is_complete = result_.tipped == operation_.volume;
    if (!result_.is_complete) now_ = end_;
    close();
    return std::move(result_);
  }

 private:
  /// Servers alike with one queue.
  struct Station {
    int free = 0;
    std::deque<int> waiting;
  };
  struct Truck {
    Load load;
    Nanoseconds since = 0;  ///< it waits
    int station = -1;       ///< where it is served
  };

  static std::size_t at(int index) { return static_cast<std::size_t>(index); }

  void add_station(const std::string& name, const std::string& by, int servers) {
    stations_.push_back({servers, {}});
    Queue queue;
    queue.name = name;
    queue.by = by;
    queue.servers = servers;
    result_.queues.push_back(queue);
  }

  void take_soil(int truck, int diggers) {
    Load& load = trucks_[at(truck)].load;
    load.number = ++begun_;
    load.truck = truck;
    load.diggers = diggers;
    load.volume = std::min(operation_.load, soil_);
    load.began = load.loaded = now_;
    if (diggers < 0) load.arrived = now_;
    soil_ -= load.volume;
  }

  /// An empty truck comes to the queue with the fewest trucks for each digger. Where no soil is
  /// left it goes home.
  void join(int truck) {
    if (soil_ == 0) return;
    const auto length = [&](std::size_t k) {
      const Station& station = stations_[k];
      const int servers = operation_.diggers[k].count;
      const int there = static_cast<int>(station.waiting.size()) + servers - station.free;
      return static_cast<double>(there) / servers;
    };
    std::size_t best = 0;
    for (std::size_t k = 1; k < operation_.diggers.size(); ++k) {
      if (length(k) < length(best)) best = k;
    }
    trucks_[at(truck)].load.arrived = now_;
    wait(truck, static_cast<int>(best));
  }

  void wait(int truck, int station) {
    trucks_[at(truck)].since = now_;
    stations_[at(station)].waiting.push_back(truck);
    serve(station);
  }

  bool is_diggers(int station) const { return at(station) < operation_.diggers.size(); }

  void serve(int index) {
    Station& station = stations_[at(index)];
    while (station.free > 0 && !station.waiting.empty()) {
      if (is_diggers(index) && soil_ == 0) {
        for (const int truck : station.waiting) note_wait(index, truck, false);
        station.waiting.clear();
        return;
      }
      const int truck = station.waiting.front();
      station.waiting.pop_front();
      --station.free;
      trucks_[at(truck)].station = index;
      note_wait(index, truck, true);
      Nanoseconds duration = 0;
      int stage = -1;
      if (is_diggers(index)) {
        take_soil(truck, index);
        duration = loading_time(trucks_[at(truck)].load.volume);
      } else {
        while (station_of_[at(++stage)] != index) continue;
        duration = clocks_[at(stage)].next();
      }
      result_.queues[at(index)].busy += duration;
      begin(truck, stage, duration);
    }
  }

  void note_wait(int index, int truck, bool is_served) {
    Queue& queue = result_.queues[at(index)];
    const Nanoseconds waited = now_ - trucks_[at(truck)].since;
    queue.time_in_all += waited;
    if (!is_served) return;
    ++queue.served;
    queue.waited += waited;
    queue.longest = std::max(queue.longest, waited);
  }

  Nanoseconds loading_time(CubicMillimetres volume) {
    if (operation_.bucket == 0) return loading_.next();
    Nanoseconds sum = 0;
    const int passes = operation_.passes(volume);
    for (int i = 0; i < passes; ++i) sum += loading_.next();
    result_.passes += passes;
    return sum;
  }

  void enter(int truck, int stage) {
    const int station = station_of_[at(stage)];
    if (station >= 0) {
      wait(truck, station);
    } else {
      begin(truck, stage, clocks_[at(stage)].next());
    }
  }

  void begin(int truck, int stage, Nanoseconds duration) {
    const int stages = static_cast<int>(operation_.stages.size());
    const bool is_served = stage < 0 || station_of_[at(stage)] >= 0;
    const int rank = is_served ? stages - 1 - stage : stages + 1 + stage;
    if (stage >= 0) result_.driving += static_cast<double>(duration) / kPerSecond;
    events_.push({now_ + duration, rank, ++order_, truck, stage});
  }

  void finish(const Event& event) {
    Truck& truck = trucks_[at(event.truck)];
    const bool is_served = event.stage < 0 || station_of_[at(event.stage)] >= 0;
    const int station = truck.station;
    if (is_served) ++stations_[at(station)].free;
    if (event.stage < 0) {
      truck.load.loaded = now_;
    } else if (at(event.stage) == operation_.tip) {
      tip(truck.load);
    }
    if (result_.tipped == operation_.volume) return;
    if (event.stage + 1 < static_cast<int>(operation_.stages.size())) {
      enter(event.truck, event.stage + 1);
    } else {
      join(event.truck);
    }
    if (is_served) serve(station);
  }

  void tip(Load& load) {
    load.tipped = now_;
    result_.tipped += load.volume;
    ++result_.loads;
    if (on_load_) on_load_(load);
  }

  /// Counts what is under way up to now.
  void close() {
    result_.time = now_;
    for (; !events_.empty(); events_.pop()) {
      const Event& event = events_.top();
      const bool is_served = event.stage < 0 || station_of_[at(event.stage)] >= 0;
      if (event.stage >= 0) result_.driving -= static_cast<double>(event.time - now_) / kPerSecond;
      if (!is_served) continue;
      result_.queues[at(trucks_[at(event.truck)].station)].busy -= event.time - now_;
    }
    for (std::size_t k = 0; k < stations_.size(); ++k) {
      for (const int truck : stations_[k].waiting) note_wait(static_cast<int>(k), truck, false);
    }
  }

  const Operation& operation_;
  const std::function<void(const Load&)>& on_load_;
  Clock loading_;
  Nanoseconds end_;
  CubicMillimetres soil_;  ///< that no truck has or is to have
  std::vector<Truck> trucks_;
  std::vector<Clock> clocks_;      ///< to each stage
  std::vector<int> station_of_;    ///< to each stage, -1: none
  std::vector<Station> stations_;  ///< of diggers, then of stages
  std::priority_queue<Event, std::vector<Event>, std::greater<>> events_;
  Nanoseconds now_ = 0;
  std::uint64_t order_ = 0;
  std::int64_t begun_ = 0;
  Result result_;
};

}  // namespace

int Operation::passes(CubicMillimetres of) const {
  return bucket > 0 ? static_cast<int>((of + bucket - 1) / bucket) : 1;
}

std::int64_t Operation::loads() const { return (volume + load - 1) / load; }

int Operation::digger_count() const {
  int sum = 0;
  for (const Diggers& each : diggers) sum += each.count;
  return sum;
}

int Operation::uncertain_stages() const {
  int count = loading.is_certain() ? 0 : 1;
  for (const Stage& each : stages) count += each.time.is_certain() ? 0 : 1;
  return count;
}

double Operation::mean_loading() const { return passes(load) * loading.seconds / efficiency; }

double Operation::mean_round() const {
  double sum = 0;
  for (const Stage& each : stages) sum += each.time.seconds;
  return mean_loading() + sum / efficiency;
}

double Operation::match_factor() const {
  return trucks * mean_loading() / (digger_count() * mean_round());
}

double Queue::mean_wait() const {
  return served > 0 ? static_cast<double>(waited) / static_cast<double>(served) / kPerSecond : 0;
}

double Queue::mean_length(Nanoseconds time) const {
  return time > 0 ? static_cast<double>(time_in_all) / static_cast<double>(time) : 0;
}

double Queue::utilisation(Nanoseconds time) const {
  return time > 0 ? static_cast<double>(busy) / (static_cast<double>(time) * servers) : 0;
}

double Result::per_hour() const {
  if (time == 0) return 0;
  return static_cast<double>(tipped) / kPerCubicMetre /
         (static_cast<double>(time) / kPerSecond / 3600);
}

Result simulate(const Operation& operation, const std::optional<Draws>& draws,
                const std::function<void(const Load&)>& on_load) {
  return Run(operation, draws, on_load).run();
}

}  // namespace rubicon::hauling
