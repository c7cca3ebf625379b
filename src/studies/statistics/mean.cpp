#include "src/studies/statistics/mean.hpp"

#include <array>
#include <cmath>

namespace rubicon::statistics {

double student_975(std::size_t degrees) {
  constexpr std::array kTable = {12.70620, 4.30265, 3.18245, 2.77645, 2.57058,
                                 2.44691,  2.36462, 2.30600, 2.26216};
  if (degrees <= kTable.size()) return kTable[degrees - 1];
  constexpr double z = 1.959963984540054;
  constexpr double z3 = z * z * z;
  constexpr double z5 = z3 * z * z;
  constexpr double z7 = z5 * z * z;
  constexpr double z9 = z7 * z * z;
  const double n = static_cast<double>(degrees);
  return z + (z3 + z) / (4 * n) + (5 * z5 + 16 * z3 + 3 * z) / (96 * n * n) +
         (3 * z7 + 19 * z5 + 17 * z3 - 15 * z) / (384 * n * n * n) +
         (79 * z9 + 776 * z7 + 1482 * z5 - 1920 * z3 - 945 * z) / (92160 * n * n * n * n);
}

Mean mean_of(std::span<const double> values) {
  Mean result;
  result.count = values.size();
  if (values.empty()) return result;
  const double n = static_cast<double>(values.size());
  // Of what is above the first: exact where all are equal, and little is lost elsewhere.
  double sum = 0;
  for (const double value : values) sum += value - values.front();
  result.mean = values.front() + sum / n;
  if (values.size() < 2) return result;
  double squares = 0;
  for (const double value : values) squares += (value - result.mean) * (value - result.mean);
  result.deviation = std::sqrt(squares / (n - 1));
  const double half = student_975(values.size() - 1) * result.deviation / std::sqrt(n);
  result.interval = Interval{result.mean - half, result.mean + half};
  return result;
}

}  // namespace rubicon::statistics
