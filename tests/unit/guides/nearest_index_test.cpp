#include "src/motion/guides/nearest_index.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "src/motion/math/random.hpp"

namespace rubicon::guides {
namespace {

/// After each point that is added the nearest of some others is that of looking at all, the first
/// of equal ones.
void check_against_all(const std::vector<double>& weights, const std::vector<double>& turns,
                       bool on_a_grid) {
  math::Random random(weights.size() + (on_a_grid ? 100 : 0));
  const auto draw = [&] {
    std::vector<double> point;
    for (const double turn : turns) {
      const double half = turn > 0 ? turn / 2 : 10;
      const double each = (2 * random.uniform() - 1) * half;
      point.push_back(on_a_grid ? std::round(each / half * 3) / 3 * half : each);
    }
    return point;
  };
  NearestIndex index(weights, turns);
  EXPECT_EQ(index.nearest(draw()).index, -1);
  std::vector<std::vector<double>> points;
  for (int n = 0; n < 1500; ++n) {
    points.push_back(draw());
    index.add(points.back());
    for (int k = 0; k < 3; ++k) {
      const std::vector<double> from = draw();
      const auto square = [&](int i) {
        double sum = 0;
        for (std::size_t d = 0; d < from.size(); ++d) {
          double way = std::fabs(from[d] - points[static_cast<std::size_t>(i)][d]);
          if (turns[d] > 0) way = std::min(way, turns[d] - way);
          const double off = way * weights[d];
          sum += off * off;
        }
        return sum;
      };
      int nearest = 0;
      for (int i = 1; i <= n; ++i) {
        if (square(i) < square(nearest)) nearest = i;
      }
      const NearestIndex::Found found = index.nearest(from);
      ASSERT_EQ(found.index, nearest) << n;
      ASSERT_EQ(found.square, square(nearest)) << n;
    }
  }
}

TEST(NearestIndex, IsThatOfLookingAtAll) {
  check_against_all({1, 2}, {0, 0}, false);
  check_against_all({1, 0.5, 3}, {0, 360, 0}, false);
  check_against_all({1, 0.5, 3, 1, 1, 0.1, 2}, {360, 360, 0, 0, 360, 0, 0}, false);
}

TEST(NearestIndex, OfEqualOnesItIsTheFirst) {
  check_against_all({1, 2}, {0, 0}, true);
  check_against_all({1, 1, 1}, {0, 360, 360}, true);
}

}  // namespace
}  // namespace rubicon::guides
