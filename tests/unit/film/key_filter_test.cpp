#include "src/results/film/key_filter.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "tests/unit/film/film_decoder.hpp"

namespace rubicon::film {
namespace {

struct Filtered {
  std::vector<Key> all;
  test::DecodedTrack kept;
};

std::vector<std::int64_t> numbers_of(const Column& column) {
  std::string bytes;
  column.append_to(bytes);
  std::vector<std::int64_t> values;
  for (std::size_t i = 0; i < bytes.size();) {
    std::uint64_t zigzag = 0;
    for (int shift = 0;; shift += 7) {
      const auto byte = static_cast<unsigned char>(bytes[i++]);
      zigzag |= static_cast<std::uint64_t>(byte & 127) << shift;
      if (byte < 128) break;
    }
    const auto value =
        static_cast<std::int64_t>(zigzag >> 1) ^ -static_cast<std::int64_t>(zigzag & 1);
    values.push_back(value + (values.empty() ? 0 : values.back()));
  }
  EXPECT_EQ(values.size(), column.count());
  return values;
}

Filtered filter(const std::vector<Key>& keys) {
  KeyFilter filter(keys.front());
  for (std::size_t i = 1; i < keys.size(); ++i) filter.add(keys[i]);
  filter.finish();
  KeyColumns columns(keys.front().q.size());
  columns.add(filter.first());
  columns.add(filter.kept());
  Filtered result{keys, {numbers_of(columns.t()), {}}};
  for (const Column& column : columns.q()) result.kept.q.push_back(numbers_of(column));
  return result;
}

/// How far the kept keys are from any key that was given, at most.
double worst_miss(const Filtered& filtered) {
  double worst = 0;
  for (const Key& key : filtered.all) {
    for (std::size_t p = 0; p < key.q.size(); ++p) {
      double best = 1e18;
      for (const double value : filtered.kept.at(p, key.t)) {
        best = std::min(best, std::abs(value - static_cast<double>(key.q[p])));
      }
      worst = std::max(worst, best);
    }
  }
  return worst;
}

TEST(KeyFilter, KeepsTheEndsOfALine) {
  std::vector<Key> keys;
  for (std::int64_t i = 0; i <= 1000; ++i) keys.push_back({i * 333, {i * 7, -i * 13, 5}});
  const Filtered filtered = filter(keys);
  EXPECT_EQ(filtered.kept.t, (std::vector<std::int64_t>{0, 333000}));
  EXPECT_EQ(filtered.kept.q[1], (std::vector<std::int64_t>{0, -13000}));
}

TEST(KeyFilter, KeepsCorners) {
  const Filtered filtered =
      filter({{0, {0}}, {10, {10}}, {20, {20}}, {30, {10}}, {40, {10}}, {60, {10}}});
  EXPECT_EQ(filtered.kept.t, (std::vector<std::int64_t>{0, 20, 30, 60}));
}

TEST(KeyFilter, AJumpIsTwoKeys) {
  const Filtered filtered =
      filter({{0, {0}}, {10, {10}}, {10, {50}}, {10, {70}}, {20, {70}}, {30, {70}}, {30, {1}}});
  EXPECT_EQ(filtered.kept.t, (std::vector<std::int64_t>{0, 10, 10, 30, 30}));
  EXPECT_EQ(filtered.kept.q[0], (std::vector<std::int64_t>{0, 10, 70, 70, 1}));
}

TEST(KeyFilter, AJumpAtTheVeryBeginning) {
  const Filtered filtered = filter({{5, {0}}, {5, {10}}, {5, {20}}, {15, {20}}});
  EXPECT_EQ(filtered.kept.t, (std::vector<std::int64_t>{5, 5, 15}));
  EXPECT_EQ(filtered.kept.q[0], (std::vector<std::int64_t>{0, 20, 20}));
}

TEST(KeyFilter, StandingStillTakesNoKeys) {
  const Filtered filtered =
      filter({{0, {7}}, {0, {7}}, {10, {7}}, {10, {7}}, {20, {7}}, {50, {7}}});
  EXPECT_EQ(filtered.kept.t, (std::vector<std::int64_t>{0, 50}));
}

TEST(KeyFilter, NeverMissesByMoreThanItMay) {
  std::mt19937_64 random(7);
  const auto pick = [&](std::int64_t below) {
    return static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(below));
  };
  std::size_t left_out = 0;
  for (int walk = 0; walk < 300; ++walk) {
    std::vector<Key> keys = {{pick(1000), {pick(1000), pick(1000)}}};
    std::vector<std::int64_t> speed = {0, 0};
    for (int i = 0; i < 200; ++i) {
      Key next = keys.back();
      if (pick(10) == 0) speed = {pick(21) - 10, pick(3) - 1};
      const std::int64_t time = pick(12) == 0 ? 0 : 1 + pick(1000);
      next.t += time;
      // Near a line, and now and then off it or a jump.
      for (std::size_t p = 0; p < 2; ++p) next.q[p] += speed[p] * time + pick(3) - 1;
      keys.push_back(next);
    }
    const Filtered filtered = filter(keys);
    ASSERT_TRUE(std::is_sorted(filtered.kept.t.begin(), filtered.kept.t.end()));
    // Of several jumps at one moment those between are not kept.
    Filtered seen = filtered;
    std::erase_if(seen.all, [&](const Key& key) {
      return std::count_if(keys.begin(), keys.end(),
                           [&](const Key& other) { return other.t == key.t; }) > 2;
    });
    ASSERT_LE(worst_miss(seen), KeyFilter::kOffTheLine + 1e-9);
    left_out += keys.size() - filtered.kept.t.size();
  }
  EXPECT_GT(left_out, 5000u);
}

}  // namespace
}  // namespace rubicon::film
