#include "src/earth/hauling/truck_rounds.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace rubicon::hauling {

namespace {

/// Of one stage, s.
constexpr double kLongestStage = 2e9;

}  // namespace

TruckRounds::TruckRounds(const Operation& operation,
                         std::optional<std::pair<std::uint64_t, std::uint64_t>> by,
                         std::string task)
    : operation_(&operation),
      by_(by),
      task_(std::move(task)),
      uses_(operation.stages.size(), 0),
      trucks_(at(operation.trucks)) {
  for (const Stage& stage : operation.stages) {
    stations_.push_back({stage.servers, {}});
    queue_of_.push_back(stage.servers > 0 ? static_cast<int>(queues_.size()) : -1);
    if (stage.servers == 0) continue;
    Queue& queue = queues_.emplace_back();
    queue.name = stage.name;
    queue.by = stage.by;
    queue.servers = stage.servers;
  }
  for (int truck = 0; truck < operation.trucks; ++truck) waiting_.push_back(truck);
}

Nanoseconds TruckRounds::duration_of(int stage) {
  const StageTime& time = operation_->stages[at(stage)].time;
  double seconds = time.seconds;
  if (time.law && (time.law->is_certain() || by_)) {
    const std::string place = task_ + "." + operation_->stages[at(stage)].name;
    const auto [seed, run] = by_.value_or(std::pair<std::uint64_t, std::uint64_t>(1, 0));
    seconds = sampling::draw(*time.law, {seed, run, place, uses_[at(stage)]});
  }
  ++uses_[at(stage)];
  return std::llround(std::min(seconds / operation_->efficiency, kLongestStage) * kPerSecond);
}

void TruckRounds::begin(int truck, int stage, Nanoseconds now) {
  const Nanoseconds duration = duration_of(stage);
  if (queue_of_[at(stage)] >= 0) {
    Queue& queue = queues_[at(queue_of_[at(stage)])];
    const Nanoseconds waited = now - trucks_[at(truck)].since;
    ++queue.served;
    queue.waited += waited;
    queue.time_in_all += waited;
    queue.longest = std::max(queue.longest, waited);
    queue.busy += duration;
  }
  driven_ += static_cast<double>(duration) / kPerSecond;
  events_.push_back({now + duration, ++order_, truck, stage, duration});
}

void TruckRounds::enter(int truck, int stage, Nanoseconds now) {
  Truck& one = trucks_[at(truck)];
  one.since = now;
  if (at(stage) == operation_->stages.size()) {
    one.load = {};
    one.load.arrived = now;
    waiting_.push_back(truck);
    return;
  }
  if (queue_of_[at(stage)] < 0) return begin(truck, stage, now);
  Station& station = stations_[at(stage)];
  if (station.free == 0) {
    station.waiting.push_back(truck);
    return;
  }
  --station.free;
  begin(truck, stage, now);
}

std::size_t TruckRounds::first_event() const {
  const auto first =
      std::min_element(events_.begin(), events_.end(), [](const Event& a, const Event& b) {
        return std::tie(a.time, a.order) < std::tie(b.time, b.order);
      });
  return static_cast<std::size_t>(first - events_.begin());
}

void TruckRounds::process_first() {
  const std::size_t first = first_event();
  const Event event = events_[first];
  events_.erase(events_.begin() + static_cast<std::ptrdiff_t>(first));
  if (at(event.stage) == operation_->tip) {
    Load& load = trucks_[at(event.truck)].load;
    load.tipped = event.time;
    loads_.push_back(load);
  }
  if (queue_of_[at(event.stage)] >= 0) {
    Station& station = stations_[at(event.stage)];
    if (station.waiting.empty()) {
      ++station.free;
    } else {
      const int next = station.waiting.front();
      station.waiting.pop_front();
      begin(next, event.stage, event.time);
    }
  }
  enter(event.truck, event.stage + 1, event.time);
}

Nanoseconds TruckRounds::next_arrival(Nanoseconds now) {
  while (!events_.empty() && events_[first_event()].time <= now) process_first();
  while (waiting_.empty() && !events_.empty()) process_first();
  return waiting_.empty() ? kLongest : std::max(now, trucks_[at(waiting_.front())].load.arrived);
}

void TruckRounds::call(Nanoseconds now) {
  const int truck = waiting_.front();
  waiting_.pop_front();
  loading_ = {};
  loading_.number = ++begun_;
  loading_.truck = truck;
  loading_.diggers = 0;
  loading_.arrived = trucks_[at(truck)].load.arrived;
  loading_.began = now;
}

void TruckRounds::leave(Nanoseconds now) {
  while (!events_.empty() && events_[first_event()].time <= now) process_first();
  loading_.loaded = now;
  trucks_[at(loading_.truck)].load = loading_;
  const int truck = loading_.truck;
  loading_ = {};
  loading_.truck = -1;
  enter(truck, 0, now);
}

Nanoseconds TruckRounds::last_tip() {
  while (static_cast<std::int64_t>(loads_.size()) < begun_ && !events_.empty()) process_first();
  return loads_.empty() ? 0 : loads_.back().tipped;
}

TruckRounds::Work TruckRounds::work_until(Nanoseconds end) const {
  Work work;
  work.driving = driven_;
  for (const Queue& queue : queues_) {
    work.serving.push_back(static_cast<double>(queue.busy) / kPerSecond);
  }
  for (const Event& event : events_) {
    const Nanoseconds beyond = std::clamp<Nanoseconds>(event.time - end, 0, event.duration);
    work.driving -= static_cast<double>(beyond) / kPerSecond;
    const int queue = queue_of_[at(event.stage)];
    if (queue >= 0) work.serving[at(queue)] -= static_cast<double>(beyond) / kPerSecond;
  }
  return work;
}

}  // namespace rubicon::hauling
