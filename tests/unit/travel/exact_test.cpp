#include "src/motion/travel/exact.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "tests/unit/travel/rational.hpp"
#include "tests/unit/travel/travel_worlds.hpp"

namespace rubicon::travel {
namespace {

struct RationalPoint {
  Rational x, y;
};

RationalPoint rational(const LatticePoint& p) { return {p.x, p.y}; }

Rational cross(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

RationalPoint rational_crossing(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c,
                                const LatticePoint& d) {
  const RationalPoint p = rational(a), q = rational(b), r = rational(c), s = rational(d);
  const Rational t = ((r.x - p.x) * (s.y - r.y) - (r.y - p.y) * (s.x - r.x)) /
                     ((q.x - p.x) * (s.y - r.y) - (q.y - p.y) * (s.x - r.x));
  return {p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)};
}

LatticePoint corner(TestRandom& random, int reach) {
  return {random.whole(-reach, reach), random.whole(-reach, reach)};
}

TEST(Wide, AddsAndMultipliesLikeNumbersOfAnySize) {
  TestRandom random(1);
  for (int i = 0; i < 2000; ++i) {
    const auto a = static_cast<std::int64_t>(random.bits());
    const auto b = static_cast<std::int64_t>(random.bits());
    const auto c = static_cast<std::int64_t>(random.bits());
    const auto d = static_cast<std::int64_t>(random.bits());
    EXPECT_EQ(
        (Wide(a) * Wide(b) * Wide(c) - Wide(b) * Wide(c) * Wide(d) + Wide(d)).sign(),
        (BigInt(a) * BigInt(b) * BigInt(c) - BigInt(b) * BigInt(c) * BigInt(d) + BigInt(d)).sign());
    EXPECT_EQ((Wide(a) * Wide(b) * Wide(c) - Wide(c) * Wide(b) * Wide(a)).sign(), 0);
  }
}

TEST(Exact, SidesOfCrossingsAreThoseOfRationalArithmetic) {
  TestRandom random(2);
  int on_line = 0;
  for (int i = 0; i < 3000; ++i) {
    // Small lattices make many points fall on lines, large ones need all the bits.
    const int reach = i % 3 == 0 ? 3 : i % 3 == 1 ? 50 : 2'000'000'000;
    LatticePoint p[8];
    for (LatticePoint& each : p) each = corner(random, reach);
    if (turn(p[0], p[1], p[2], p[3]) == 0 || turn(p[4], p[5], p[6], p[7]) == 0) continue;
    const ExactPoint a = crossing(p[0], p[1], p[2], p[3]);
    const ExactPoint b = crossing(p[4], p[5], p[6], p[7]);
    const RationalPoint ra = rational_crossing(p[0], p[1], p[2], p[3]);
    const RationalPoint rb = rational_crossing(p[4], p[5], p[6], p[7]);
    EXPECT_NEAR(a.p.x() * kPitchesPerMetre, ra.x.value(), 1e-9 * reach);
    const int expected = cross(ra, rb, rational(p[1])).sign();
    on_line += expected == 0 ? 1 : 0;
    EXPECT_EQ(side(a, b, p[1]), expected);
    EXPECT_EQ(side(ExactPoint(p[0]), ExactPoint(p[1]), a), 0);
    EXPECT_EQ(compare(a, b),
              (ra.x - rb.x).sign() != 0 ? (ra.x - rb.x).sign() : (ra.y - rb.y).sign());
  }
  EXPECT_GT(on_line, 50);
}

TEST(Exact, FeetOfPerpendicularsAreOnTheLine) {
  TestRandom random(3);
  for (int i = 0; i < 500; ++i) {
    const LatticePoint a = corner(random, 1'000'000'000), b = corner(random, 1'000'000'000);
    const LatticePoint c = corner(random, 1'000'000'000);
    const ExactPoint f = foot(a, b, c);
    EXPECT_EQ(side(ExactPoint(a), ExactPoint(b), f), 0);
    EXPECT_NEAR((f.p - metres(c)).dot((metres(b) - metres(a)).normalized()), 0, 1e-9);
  }
}

TEST(Exact, AMiddleOnTheBorderIsNeitherInsideNorOutside) {
  const Ring ring = ring_of(u_shape(0, 0, 10, 8, 2));
  const auto place = [&ring](const Vec2& a, const Vec2& b) {
    return place_of_middle(snap(a), snap(b), ring);
  };
  EXPECT_EQ(place({1, 1}, {1, 1}), 1);
  EXPECT_EQ(place({4, 1}, {6, 1}), -1);
  EXPECT_EQ(place({0, 0}, {0, 8}), 0);
  EXPECT_EQ(place({0, 8}, {0, 8}), 0);
  EXPECT_EQ(place({2, 0}, {8, 0}), -1);    // between the arms, on the line of their ends
  EXPECT_EQ(place({-4, 8}, {-2, 8}), -1);  // on the line of an edge
}

TEST(Exact, RefusesWhatIsOutOfReach) {
  EXPECT_THROW(snap({600'000, 0}), std::invalid_argument);
  EXPECT_THROW(snap({0, std::numeric_limits<double>::quiet_NaN()}), std::invalid_argument);
}

}  // namespace
}  // namespace rubicon::travel
