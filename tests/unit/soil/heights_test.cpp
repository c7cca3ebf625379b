#include "src/earth/soil/heights.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace rubicon::soil {
namespace {

TEST(Heights, CopiesKeepTheirOwn) {
  Heights first(1300, 5);
  const Heights before = first;
  first.set(700, -3);
  first.set(1299, 9);
  EXPECT_EQ(first[700], -3);
  EXPECT_EQ(first[1299], 9);
  EXPECT_EQ(first.highest(), 9);
  EXPECT_EQ(first.lowest(), -3);
  for (std::size_t cell = 0; cell < before.size(); ++cell) ASSERT_EQ(before[cell], 5) << cell;
}

/// Tiles that are shared, copied and equal, and equal without being shared.
TEST(Heights, DifferencesAreThoseOfEachCell) {
  Heights a(2000, 0);
  Heights b = a;
  Heights c(2000, 0);
  for (const std::size_t cell : {0, 511, 512, 1024, 1999}) b.set(cell, 1);
  b.set(600, 7);
  b.set(600, 0);
  for (const Heights& other : {a, c}) {
    std::vector<std::size_t> found;
    b.for_each_difference(other, [&](std::size_t cell) { found.push_back(cell); });
    EXPECT_EQ(found, (std::vector<std::size_t>{0, 511, 512, 1024, 1999}));
  }
  EXPECT_EQ(a.next_difference(c, 0), 2000u);
}

}  // namespace
}  // namespace rubicon::soil
