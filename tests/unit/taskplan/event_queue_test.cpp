// The time of a run, and which task goes on when.

#include "src/simulation/taskplan/event_queue.hpp"

#include <gtest/gtest.h>

#include <optional>

namespace rubicon::taskplan {
namespace {

TEST(EventQueue, NothingIsDueBeforeItsTime) {
  EventQueue events;
  events.set(3, 10);
  EXPECT_EQ(events.take_due(), std::nullopt);
  EXPECT_EQ(events.next(), std::optional<Ticks>(10));
  events.advance_to(10);
  EXPECT_EQ(events.take_due(), std::optional(3));
  EXPECT_EQ(events.take_due(), std::nullopt);
  EXPECT_EQ(events.next(), std::nullopt);
}

TEST(EventQueue, OfSeveralAtAMomentTheOneThatWasSetFirstGoesOn) {
  EventQueue events;
  events.set(2, 5);
  events.set(1, 5);
  events.set(0, 4);
  events.advance_to(5);
  EXPECT_EQ(events.take_due(), std::optional(0));
  EXPECT_EQ(events.take_due(), std::optional(2));
  EXPECT_EQ(events.take_due(), std::optional(1));
}

TEST(EventQueue, ATaskHasOneEvent) {
  EventQueue events;
  events.set(1, 5);
  events.set(2, 5);
  events.set(1, 5);  // set again: behind the other
  events.advance_to(5);
  EXPECT_EQ(events.take_due(), std::optional(2));
  EXPECT_EQ(events.take_due(), std::optional(1));
  EXPECT_FALSE(events.is_set(1));
  events.set(1, 9);
  events.cancel(1);
  EXPECT_EQ(events.next(), std::nullopt);
}

TEST(EventQueue, ACopyIsAMomentToGoBackTo) {
  EventQueue events;
  events.set(1, 5);
  const EventQueue before = events;
  events.advance_to(5);
  events.take_due();
  events.set(2, 7);
  events = before;
  EXPECT_EQ(events.now(), 0);
  EXPECT_FALSE(events.is_set(2));
  EXPECT_EQ(events.next(), std::optional<Ticks>(5));
}

}  // namespace
}  // namespace rubicon::taskplan
