#include "src/simulation/sampling/duration_law.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "src/motion/math/random.hpp"

namespace rubicon::sampling {

namespace {

const std::array<LawInfo, 9>& all_laws() {
  static const std::array<LawInfo, 9> kLaws = {{
      {Law::uniform, "uniform", {"low", "high"}, "anything between"},
      {Law::triangular,
       "triangular",
       {"low", "likely", "high"},
       "three estimates, straight between"},
      {Law::pert, "pert", {"low", "likely", "high"}, "three estimates, a beta distribution"},
      {Law::normal, "normal", {"mean", "deviation"}, "cut at 0 and at twice the mean"},
      {Law::lognormal, "lognormal", {"mean", "deviation"}, "of the time itself"},
      {Law::gamma, "gamma", {"mean", "deviation"}, "of the time itself"},
      {Law::exponential, "exponential", {"mean"}, "as of arrivals by chance"},
      {Law::sequence, "sequence", {"first", "second", "..."}, "listed, each in its turn"},
      {Law::measured, "measured", {"file", "unit"}, "times that were measured, from a file"},
  }};
  return kLaws;
}

/// FNV-1a (Fowler, Noll, Vo), 64 bits.
std::uint64_t hash_of(std::string_view text) {
  std::uint64_t hash = 14695981039346656037ull;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ull;
  return hash;
}

math::Random random_of(const Place& place) {
  const std::uint64_t by_seed = math::Random(place.seed).bits();
  const std::uint64_t by_run = math::Random(by_seed ^ place.run).bits();
  const std::uint64_t first = by_run ^ hash_of(place.name);
  if (place.use == 0) return math::Random(first);
  return math::Random(math::Random(first).bits() ^ place.use);
}

bool has_three(Law law) { return law == Law::triangular || law == Law::pert; }

/// Of a gamma distribution with scale 1.
double gamma_draw(math::Random& random, double shape) {
  if (shape >= 1) return random.gamma(shape);
  const double raised = random.gamma(shape + 1);
  return raised * math::exp_of(math::log_of(1 - random.uniform()) / shape);
}

}  // namespace

std::span<const LawInfo> laws() { return all_laws(); }

const LawInfo& info_of(Law law) { return all_laws()[static_cast<std::size_t>(law)]; }

std::optional<Law> find_law(std::string_view name) {
  for (const LawInfo& each : all_laws()) {
    if (each.name == name) return each.law;
  }
  return std::nullopt;
}

double DurationLaw::mean() const {
  switch (law) {
    case Law::uniform:
      return (values[0] + values[1]) / 2;
    case Law::triangular:
      return (values[0] + values[1] + values[2]) / 3;
    case Law::pert:
      return (values[0] + 4 * values[1] + values[2]) / 6;
    case Law::sequence:
      return std::accumulate(values.begin(), values.end(), 0.0) /
             static_cast<double>(values.size());
    case Law::measured:
      return measured->mean;
    case Law::normal:
    case Law::lognormal:
    case Law::gamma:
    case Law::exponential:
      break;
  }
  return values[0];
}

double DurationLaw::least() const {
  if (law == Law::measured) return measured->least;
  if (law == Law::sequence) return *std::min_element(values.begin(), values.end());
  return law == Law::uniform || has_three(law) ? values[0] : 0;
}

double DurationLaw::most() const {
  if (law == Law::measured) return measured->most;
  if (law == Law::sequence) return *std::max_element(values.begin(), values.end());
  if (law == Law::uniform) return values[1];
  if (has_three(law)) return values[2];
  if (law == Law::normal) return 2 * values[0];
  return std::numeric_limits<double>::infinity();
}

std::string DurationLaw::fault() const {
  const LawInfo& info = info_of(law);
  if (law == Law::measured) return measured ? "" : "there are no times";
  if (law == Law::sequence) {
    const bool fine = std::all_of(values.begin(), values.end(), [](double v) { return v >= 0; });
    if (values.empty()) return "a sequence has at least one value";
    return fine ? "" : "a value of the sequence is below 0";
  }
  if (values.size() != info.values.size()) {
    std::string wanted;
    for (const char* each : info.values) wanted += (wanted.empty() ? "" : ", ") + std::string(each);
    return std::string(info.name) + " takes " + std::to_string(info.values.size()) +
           (info.values.size() == 1 ? " value (" : " values (") + wanted + "), found " +
           std::to_string(values.size());
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!(values[i] >= 0)) return std::string("the ") + info.values[i] + " value is below 0";
  }
  if (law == Law::uniform || has_three(law)) {
    for (std::size_t i = 1; i < values.size(); ++i) {
      if (values[i] >= values[i - 1]) continue;
      return std::string("the ") + info.values[i] + " value is below the " + info.values[i - 1] +
             " value";
    }
    return {};
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!(values[i] > 0)) return std::string("the ") + info.values[i] + " is 0";
  }
  if (law == Law::normal && values[1] > values[0]) {
    return "the deviation is larger than the mean: take lognormal or gamma";
  }
  return {};
}

double draw(const DurationLaw& law, const Place& place) {
  if (law.law == Law::sequence) return law.values[place.use % law.values.size()];
  math::Random random = random_of(place);
  const std::vector<double>& v = law.values;
  switch (law.law) {
    case Law::uniform:
      return random.between(v[0], v[1]);
    case Law::triangular: {
      const double range = v[2] - v[0];
      if (range == 0) return v[0];
      const double u = random.uniform();
      const double peak = (v[1] - v[0]) / range;
      if (u < peak) return v[0] + std::sqrt(u * range * (v[1] - v[0]));
      return v[2] - std::sqrt((1 - u) * range * (v[2] - v[1]));
    }
    case Law::pert: {
      const double range = v[2] - v[0];
      if (range == 0) return v[0];
      const double a = 1 + 4 * (v[1] - v[0]) / range;
      const double b = 1 + 4 * (v[2] - v[1]) / range;
      return v[0] + range * random.beta(a, b);
    }
    case Law::normal: {
      double drawn = -1;
      while (drawn < 0 || drawn > 2 * v[0]) drawn = v[0] + v[1] * random.normal();
      return drawn;
    }
    case Law::lognormal: {
      const double variance = math::log_of(1 + v[1] * v[1] / (v[0] * v[0]));
      const double centre = math::log_of(v[0]) - variance / 2;
      return math::exp_of(centre + std::sqrt(variance) * random.normal());
    }
    case Law::gamma: {
      const double shape = v[0] * v[0] / (v[1] * v[1]);
      return gamma_draw(random, shape) * v[1] * v[1] / v[0];
    }
    case Law::measured:
      return law.measured->times[random.index(law.measured->times.size())];
    case Law::exponential:
    case Law::sequence:
      break;
  }
  return -v[0] * math::log_of(1 - random.uniform());
}

double uniform_draw(const Place& place) { return random_of(place).uniform(); }

}  // namespace rubicon::sampling
