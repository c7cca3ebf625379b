#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "src/simulation/sampling/measured_times.hpp"

namespace rubicon::sampling {

/// How a duration that is not certain is spread.
enum class Law : std::uint8_t {
  uniform,
  triangular,
  pert,
  normal,
  lognormal,
  gamma,
  exponential,
  sequence,
  measured
};

/// A law as plans write it: its name, what its values are, and what it is.
struct LawInfo {
  Law law;
  const char* name;
  std::vector<const char*> values;  ///< what each value is called
  const char* text;
};
std::span<const LawInfo> laws();
const LawInfo& info_of(Law law);
std::optional<Law> find_law(std::string_view name);

/// A law and its values (s), as many as it has.
///
/// uniform(low, high); triangular(low, likely, high); pert(low, likely, high), a beta distribution
/// with shapes 1 + 4 (likely - low) / (high - low) and 1 + 4 (high - likely) / (high - low)
/// (Malcolm and others, Operations Research 7(5), 1959); normal(mean, deviation), cut at 0 and at
/// twice the mean, so that the mean stays; lognormal(mean, deviation) and gamma(mean, deviation) of
/// the time itself; exponential(mean). sequence(first, second, ...) leaves nothing to chance: the
/// uses of a place have these durations in turn, and again from the first. measured(...): one of
/// the times of a file, each as likely as any other, and nothing between them.
struct DurationLaw {
  Law law = Law::uniform;
  std::vector<double> values;
  /// Of `measured`, which has no values; shared, since many works may have the same file.
  std::shared_ptr<const MeasuredTimes> measured = {};

  /// Of a sequence that of its values.
  double mean() const;
  bool is_certain() const { return law == Law::sequence; }
  /// The least and the greatest duration, s.
  double least() const;
  double most() const;
  /// What is wrong with the values, in words for users; "" if they are as many as the law has and
  /// nothing is.
  std::string fault() const;
};

/// Where a draw is made: it depends on nothing else.
struct Place {
  std::uint64_t seed = 1;
  std::uint64_t run = 0;
  std::string_view name;  ///< such as "set_3.hook"
  std::uint64_t use = 0;  ///< how often it was used before
};

/// A duration (s) by the law, which must have no fault; the same for the same place on every
/// machine.
double draw(const DurationLaw& law, const Place& place);

/// A number in [0, 1); the same for the same place on every machine.
double uniform_draw(const Place& place);

}  // namespace rubicon::sampling
