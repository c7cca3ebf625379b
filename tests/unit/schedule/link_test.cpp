#include "src/simulation/schedule/link.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace rubicon::schedule {
namespace {

TEST(Link, CountsFromOneEndAndHoldsOne) {
  EXPECT_EQ(end_before(LinkType::FS), TaskEnd::finish);
  EXPECT_EQ(end_before(LinkType::SS), TaskEnd::start);
  EXPECT_EQ(end_before(LinkType::FF), TaskEnd::finish);
  EXPECT_EQ(end_before(LinkType::SF), TaskEnd::start);
  EXPECT_EQ(end_after(LinkType::FS), TaskEnd::start);
  EXPECT_EQ(end_after(LinkType::SS), TaskEnd::start);
  EXPECT_EQ(end_after(LinkType::FF), TaskEnd::finish);
  EXPECT_EQ(end_after(LinkType::SF), TaskEnd::finish);
}

TEST(Link, KeepsLagsWithinTime) {
  const WorkCalendar always;
  constexpr Ticks kMost = std::numeric_limits<Ticks>::max();
  constexpr Ticks kLeast = std::numeric_limits<Ticks>::min();
  EXPECT_EQ(bound_of({0, LinkType::FS, kMost}, kHour, always), kEndOfTime);
  EXPECT_EQ(bound_of({0, LinkType::FS, kLeast}, -kHour, always), -kEndOfTime);
  EXPECT_EQ(bound_of({0, LinkType::FS, kMost, LagClock::working}, kHour, always), kEndOfTime);
  EXPECT_EQ(bound_of({0, LinkType::FS, kLeast, LagClock::working}, -kHour, always), -kEndOfTime);
}

TEST(LinkBounds, KeepsTheLatestAndTheFirstOfEquals) {
  LinkBounds bounds;
  bounds.hold(TaskEnd::start, 5, 0);
  bounds.hold(TaskEnd::start, 7, 1);
  bounds.hold(TaskEnd::start, 7, 2);
  bounds.hold(TaskEnd::finish, -kEndOfTime, 3);
  EXPECT_EQ(bounds.start, 7);
  EXPECT_EQ(bounds.start_link, 1);
  EXPECT_EQ(bounds.finish_link, 3);
}

TEST(EarliestStart, OfUnknownDurationLeavesTheFinishToBeHeld) {
  LinkBounds bounds;
  bounds.hold(TaskEnd::start, 3 * kHour, 0);
  bounds.hold(TaskEnd::finish, 10 * kHour, 1);
  const EarliestStart known = earliest_start(bounds, 0, 2 * kHour, {});
  EXPECT_EQ(known.start, 8 * kHour);
  EXPECT_EQ(known.hold, StartHold::finish_link);
  const EarliestStart unknown = earliest_start_of_unknown(bounds, 0, {});
  EXPECT_EQ(unknown.start, 3 * kHour);
  EXPECT_EQ(unknown.hold, StartHold::start_link);
  EXPECT_EQ(held_finish(bounds, 5 * kHour), 10 * kHour);   // done early, held
  EXPECT_EQ(held_finish(bounds, 11 * kHour), 11 * kHour);  // done late
  EXPECT_EQ(held_finish({}, 11 * kHour), 11 * kHour);
}

TEST(EarliestStart, IsHeldByTheStartWhereBothSayTheSame) {
  LinkBounds bounds;
  bounds.hold(TaskEnd::start, 3 * kHour, 0);
  bounds.hold(TaskEnd::finish, 5 * kHour, 1);
  EXPECT_EQ(earliest_start(bounds, 0, 2 * kHour, {}).hold, StartHold::start_link);
  EXPECT_EQ(earliest_start(bounds, 0, 2 * kHour - 1, {}).hold, StartHold::finish_link);
}

TEST(EarliestStart, IsNotBeforeWhatIsGiven) {
  LinkBounds bounds;
  bounds.hold(TaskEnd::start, 3 * kHour, 0);
  const EarliestStart start = earliest_start(bounds, 4 * kHour, kHour, {});
  EXPECT_EQ(start.start, 4 * kHour);
  EXPECT_EQ(start.hold, StartHold::not_before);
  EXPECT_EQ(earliest_start({}, 0, kHour, {}).hold, StartHold::not_before);
}

}  // namespace
}  // namespace rubicon::schedule
