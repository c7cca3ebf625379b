#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "src/simulation/sampling/duration_law.hpp"

namespace rubicon::hauling {

/// Working time: breaks and nights are left out.
using Nanoseconds = std::int64_t;
/// Bank volume, as the soil lies undisturbed. Whole, so that every balance is exact.
using CubicMillimetres = std::int64_t;
inline constexpr double kPerCubicMetre = 1e9;
inline constexpr double kPerSecond = 1e9;

/// How long a stage takes: certain, or by a law, and then `seconds` is its mean.
struct StageTime {
  double seconds = 0;
  std::optional<sampling::DurationLaw> law = {};

  bool is_certain() const { return !law || law->is_certain(); }
};

/// What a truck does after it was loaded, such as to haul, be weighed, tip, return.
struct Stage {
  std::string name;  ///< also that of the place of its draws, after the task's
  StageTime time;
  std::string by = {};  ///< who serves it; "": nobody, no truck waits for another there
  int servers = 0;      ///< of these; 0 where nobody serves
};

/// Diggers alike with one queue of trucks before them.
struct Diggers {
  std::string name;
  int count = 1;
};

/// A fleet at work. Trucks go round: they choose the queue with the fewest trucks for each digger
/// (of several the first), are loaded in the order of arrival, pass the stages in their order, and
/// come back until no soil is left.
struct Operation {
  CubicMillimetres volume = 0;
  CubicMillimetres load = 0;    ///< that a full truck takes; above 0
  CubicMillimetres bucket = 0;  ///< of a pass; 0: `loading` is that of a truck
  StageTime loading;            ///< of a pass, or of a truck, full or not
  std::vector<Diggers> diggers;
  int trucks = 1;
  int loaded = 0;  ///< the first so many trucks are loaded when it begins, all others queue
  std::vector<Stage> stages;
  std::size_t tip = 0;    ///< the stage with which a load is where it belongs
  double efficiency = 1;  ///< of the time that is worked, above 0 up to 1: all takes longer by it
  std::optional<Nanoseconds> until = {};  ///< all stop then, whatever is left

  int passes(CubicMillimetres load) const;
  std::int64_t loads() const;
  int digger_count() const;
  /// Stages, loading included, whose durations are not certain.
  int uncertain_stages() const;
  /// Seconds of a round without waiting, and of loading, of a full truck by the means.
  double mean_loading() const;
  double mean_round() const;
  /// Trucks x loading time / (diggers x round), by the means (Burt and Caccetta, Operations
  /// Research 2007): below 1 diggers wait for trucks, above 1 trucks for diggers.
  double match_factor() const;
};

/// The most loads of an operation, and the most passes of all of them.
inline constexpr std::int64_t kMostLoads = 2'000'000;
inline constexpr std::int64_t kMostPasses = 20'000'000;

/// The longest operation: it ends then, and is not complete. 1e8 s, some three years.
inline constexpr Nanoseconds kLongest = 100'000'000'000'000'000;

/// By what draws are made; the place of a stage is "TASK.STAGE", that of loading "TASK.load".
struct Draws {
  std::uint64_t seed = 1;
  std::uint64_t run = 0;
  std::string_view task;
};

/// One load, from the truck's arrival in the queue to where it was tipped.
struct Load {
  std::int64_t number = 0;  ///< in the order in which loading began; those loaded before are first
  int truck = 0;
  int diggers = -1;  ///< that filled it, -1: it was loaded before
  CubicMillimetres volume = 0;
  Nanoseconds arrived = 0, began = 0, loaded = 0, tipped = 0;
};

/// Before the diggers or the servers of a stage.
struct Queue {
  std::string name;  ///< of the stage; "load" before diggers
  std::string by;
  int servers = 0;
  std::int64_t served = 0;      ///< trucks that came to their turn
  Nanoseconds waited = 0;       ///< by these
  Nanoseconds longest = 0;      ///< wait of one
  Nanoseconds time_in_all = 0;  ///< waited by all, those too that wait at the end
  Nanoseconds busy = 0;         ///< servers together

  double mean_wait() const;                    ///< s
  double mean_length(Nanoseconds time) const;  ///< trucks that wait, over the time
  double utilisation(Nanoseconds time) const;
};

struct Result {
  Nanoseconds time = 0;  ///< until the last load was tipped, or the end of its time came
  std::int64_t loads = 0;
  CubicMillimetres tipped = 0;
  std::int64_t passes = 0;    ///< begun
  std::vector<Queue> queues;  ///< of the diggers, in their order, then of stages with servers
  double driving = 0;        ///< s, of all trucks together in stages: neither loaded nor in a queue
  bool is_complete = false;  ///< all of the volume was tipped

  double per_hour() const;  ///< m3 of bank volume in an hour that is worked
};

/// Runs the operation. Of events at the same moment those of servers come first, the last of the
/// round before the others, then those of trucks by themselves in the order of the stages, then who
/// began first. `on_load` may be empty. The operation must have diggers, trucks, a stage, and no
/// more than kMostLoads loads, none of them of 0.
Result simulate(const Operation& operation, const std::optional<Draws>& draws,
                const std::function<void(const Load&)>& on_load = {});

}  // namespace rubicon::hauling
