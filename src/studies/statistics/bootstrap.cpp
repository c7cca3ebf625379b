#include "src/studies/statistics/bootstrap.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "src/motion/math/random.hpp"
#include "src/studies/statistics/quantile.hpp"

namespace rubicon::statistics {

namespace {

constexpr std::size_t kFewestPairs = 20;
constexpr std::uint64_t kSeed = 20261124;

double quantile_of(std::vector<double>& values, double p) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(quantile_rank(values.size(), p) - 1);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace

std::optional<Interval> quantile_difference(std::span<const double> a, std::span<const double> b,
                                            double p) {
  const std::size_t count = std::min(a.size(), b.size());
  if (count < kFewestPairs) return std::nullopt;
  math::Random random(kSeed);
  std::vector<double> differences;
  std::vector<double> one(count);
  std::vector<double> other(count);
  for (int i = 0; i < kResamples; ++i) {
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t drawn = random.index(count);
      one[k] = a[drawn];
      other[k] = b[drawn];
    }
    const double difference = quantile_of(other, p) - quantile_of(one, p);
    if (!std::isfinite(difference)) return std::nullopt;
    differences.push_back(difference);
  }
  std::sort(differences.begin(), differences.end());
  return Interval{quantile(differences, 0.025), quantile(differences, 0.975)};
}

}  // namespace rubicon::statistics
