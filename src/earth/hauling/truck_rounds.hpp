#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "src/earth/hauling/hauling.hpp"

namespace rubicon::hauling {

/// Trucks that go round while somebody else says when one is loaded: the rounds of a digger whose
/// loading takes as long as its motions do. A value. Time goes on with what is asked; it never goes
/// back. Events at the same moment come in the order in which their stages began.
class TruckRounds {
 public:
  TruckRounds() = default;
  /// All trucks wait at the digger. Of the operation only trucks, stages and efficiency count; it
  /// must outlive this. `task`: place of the draws; `seed`, `run`: by which they are made, or none.
  TruckRounds(const Operation& operation, std::optional<std::pair<std::uint64_t, std::uint64_t>> by,
              std::string task);

  /// When the next truck is there to be loaded, `now` or later, if none leaves the digger before.
  Nanoseconds next_arrival(Nanoseconds now);
  /// The truck that has waited longest drives up.
  void call(Nanoseconds now);
  bool is_loading() const { return loading_.truck >= 0; }
  /// That is being loaded; -1: none.
  int truck() const { return loading_.truck; }
  /// Bank volume in the truck that is being loaded.
  CubicMillimetres loaded() const { return loading_.volume; }
  void load(CubicMillimetres volume) { loading_.volume += volume; }
  /// It drives off.
  void leave(Nanoseconds now);
  /// When the last of those under way has tipped; nothing has to come after that.
  Nanoseconds last_tip();

  /// Those that have been tipped, in this order; `diggers` is 0.
  const std::vector<Load>& loads() const { return loads_; }
  /// Of stages with servers.
  const std::vector<Queue>& queues() const { return queues_; }
  std::int64_t left() const { return begun_; }
  /// s up to `end`, no earlier than what was asked last: of all trucks together in stages, and of
  /// those who serve each of `queues`.
  struct Work {
    double driving = 0;
    std::vector<double> serving;
  };
  Work work_until(Nanoseconds end) const;

 private:
  struct Event {
    Nanoseconds time = 0;
    std::uint64_t order = 0;
    int truck = 0;
    int stage = 0;
    Nanoseconds duration = 0;
  };
  struct Station {
    int free = 0;
    std::deque<int> waiting;
  };
  struct Truck {
    Load load;
    Nanoseconds since = 0;
  };

  static std::size_t at(int index) { return static_cast<std::size_t>(index); }
  Nanoseconds duration_of(int stage);
  void enter(int truck, int stage, Nanoseconds now);
  void begin(int truck, int stage, Nanoseconds now);
  /// The event that comes first.
  std::size_t first_event() const;
  void process_first();

  const Operation* operation_ = nullptr;
  std::optional<std::pair<std::uint64_t, std::uint64_t>> by_;
  std::string task_;
  std::vector<std::uint64_t> uses_;  ///< of the draws of each stage
  std::vector<Station> stations_;    ///< to each stage
  std::vector<Queue> queues_;        ///< of those with servers
  std::vector<int> queue_of_;        ///< to each stage, -1: none
  std::vector<Truck> trucks_;
  std::vector<Event> events_;  ///< one a truck at most
  std::deque<int> waiting_;    ///< at the digger
  Load loading_{0, -1};        ///< of the truck at the digger; no truck: -1
  std::vector<Load> loads_;
  std::uint64_t order_ = 0;
  std::int64_t begun_ = 0;
  double driven_ = 0;  ///< s, of all stages that have begun
};

}  // namespace rubicon::hauling
