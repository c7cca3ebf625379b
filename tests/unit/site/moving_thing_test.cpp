#include "src/simulation/site/moving_thing.hpp"

#include <gtest/gtest.h>

namespace rubicon::site {
namespace {

using math::translation;
using schedule::kHour;
using schedule::kSecond;

collision::BodyPtr ball() {
  return collision::prepare({{geometry::Sphere{{0, 0, 0}, 0.5}, math::Pose::Identity()}});
}

/// From 10 s: two and a half seconds of way, a stay of an hour, and back at once.
MovingThing thing(bool repeat) {
  return MovingThing("thing", ball(), nullptr,
                     {{{10 * kSecond, translation(0, 0, 0)},
                       {10 * kSecond + 5 * kSecond / 2, translation(5, 0, 0)},
                       {kHour, translation(5, 0, 0)},
                       {kHour + kSecond / 2, translation(0, 0, 0)}},
                      repeat},
                     1e-3);
}

TEST(MovingThing, LooksAheadASecondAndOverAStay) {
  const MovingThing once = thing(false);
  EXPECT_EQ(once.windows(), 5);
  EXPECT_FALSE(once.is_present(10 * kSecond - 1));
  EXPECT_EQ(once.next_window(0), 10 * kSecond);
  EXPECT_EQ(once.next_window(10 * kSecond), 11 * kSecond);
  EXPECT_EQ(once.next_window(11 * kSecond + 1), 12 * kSecond);
  EXPECT_EQ(once.next_window(12 * kSecond), 12 * kSecond + kSecond / 2);
  EXPECT_EQ(once.next_window(13 * kSecond), kHour);
  EXPECT_EQ(once.next_window(kHour), schedule::kEndOfTime);
  EXPECT_EQ(once.last_time(), kHour + kSecond / 2);
  EXPECT_TRUE(once.is_gone(kHour + kSecond / 2));
}

TEST(MovingThing, BeginsAgain) {
  const MovingThing again = thing(true);
  const Ticks round = again.period();
  EXPECT_EQ(round, kHour + kSecond / 2 - 10 * kSecond);
  EXPECT_EQ(again.next_window(kHour), kHour + kSecond / 2);
  EXPECT_EQ(again.next_window(100 * round + 11 * kSecond), 100 * round + 12 * kSecond);
  EXPECT_EQ(again.window_at(100 * round + 11 * kSecond), 1);
  EXPECT_FALSE(again.is_gone(1000 * round));
}

TEST(MovingThing, ShiftsItsTimetableByHowLongItStood) {
  MovingThing late = thing(false);
  late.stop({11 * kSecond, "wall", -1, -1});
  EXPECT_EQ(late.window_at(60 * kSecond), 1);
  EXPECT_FALSE(late.is_gone(2 * kHour));
  EXPECT_EQ(late.next_window(60 * kSecond), 61 * kSecond);  // if it went on at once
  late.go_on(60 * kSecond);
  EXPECT_EQ(late.state().delay, 49 * kSecond);
  EXPECT_EQ(late.window_begin(60 * kSecond, 0), 60 * kSecond);
  EXPECT_EQ(late.last_time(), kHour + kSecond / 2 + 49 * kSecond);
}

TEST(MovingThing, IsNotThereWhileItCannotCome) {
  MovingThing waiting = thing(false);
  waiting.stop({10 * kSecond, "car", 0, -1});
  EXPECT_FALSE(waiting.is_present(20 * kSecond));
  waiting.go_on(20 * kSecond);
  EXPECT_TRUE(waiting.is_present(20 * kSecond));
}

TEST(MovingThing, HasNoMoreThanTenThousandWindowsBetweenTwoPlaces) {
  const MovingThing slow("slow", ball(), nullptr,
                         {{{0, translation(0, 0, 0)}, {100 * kHour, translation(1, 0, 0)}}, false},
                         1e-3);
  EXPECT_EQ(slow.windows(), 10'000);
  EXPECT_EQ(slow.next_window(0), 36 * kSecond);
}

TEST(MovingThing, IsMetWhereItWillBeUntilAStepEnds) {
  const MovingThing crossing(
      "crossing", ball(), nullptr,
      {{{0, translation(0, -6, 0)}, {12 * kSecond, translation(0, 6, 0)}}, false}, 1e-3);
  const collision::BodyPtr post = ball();
  collision::SweptQuery query;
  query.items.push_back({{post.get(), geometry::stationary(math::Pose::Identity())}, true});
  collision::MovingBodies bodies(query);
  EXPECT_FALSE(crossing.meets(bodies, 0, 5 * kSecond, false));  // windows that begin before 5 s
  EXPECT_TRUE(crossing.meets(bodies, 0, 5 * kSecond + 1, false));
  EXPECT_TRUE(crossing.meets(bodies, 6 * kSecond, 6 * kSecond, false));
  EXPECT_FALSE(crossing.meets(bodies, 7 * kSecond, 20 * kSecond, false));
}

}  // namespace
}  // namespace rubicon::site
