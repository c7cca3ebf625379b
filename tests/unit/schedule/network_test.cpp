// Crews that share their time, milestones, tasks tied at both ends, and what cannot be done: worked
// by hand.

#include "src/simulation/schedule/network.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "tests/unit/schedule/calendar_cases.hpp"
#include "tests/unit/schedule/network_cases.hpp"

namespace rubicon::schedule {
namespace {

using enum LinkType;
using test::NetworkBuilder;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr const char* kMonday = "2026-03-02 07:00";
constexpr const char* kThursday = "2026-03-05 07:00";

TEST(Network, GivesACrewToTheFirstInTheFile) {
  NetworkBuilder plan(kMonday);
  plan.crew("c").task("a", 2 * kHour, {"c"}).task("b", 3 * kHour, {"c"});
  EXPECT_EQ(plan.when("a"), "2026-03-02 07:00 .. 2026-03-02 09:00");
  EXPECT_EQ(plan.when("b"), "2026-03-02 09:00 .. 2026-03-02 12:00");
  EXPECT_EQ(plan.times().finish, 5 * kHour);
  EXPECT_THAT(plan.chain(),
              ElementsAre("a starts with the plan", "b starts when 'c' is free, which a had"));
}

TEST(Network, GivesACrewToTheHigherPriority) {
  NetworkBuilder plan(kMonday);
  plan.crew("c").task("a", 2 * kHour, {"c"}, {}, 1).task("b", 3 * kHour, {"c"}, {}, 2);
  EXPECT_EQ(plan.when("b"), "2026-03-02 07:00 .. 2026-03-02 10:00");
  EXPECT_EQ(plan.when("a"), "2026-03-02 10:00 .. 2026-03-02 12:00");
}

TEST(Network, DoesNotKeepACrewIdleForAPriority) {
  // b is more urgent but cannot start before 08:00; the crew is free at 07:00, so a has it first.
  NetworkBuilder plan(kMonday);
  plan.crew("c").task("wait", kHour).task("a", 4 * kHour, {"c"});
  plan.task("b", kHour, {"c"}, {{"wait"}}, 9).task("late", kHour, {"c"}, {{"wait"}}, 1);
  EXPECT_EQ(plan.when("a"), "2026-03-02 07:00 .. 2026-03-02 11:00");
  EXPECT_EQ(plan.when("b"), "2026-03-02 11:00 .. 2026-03-02 12:00");
  EXPECT_EQ(plan.when("late"), "2026-03-02 12:00 .. 2026-03-02 13:00");
}

TEST(Network, TakesAllCrewsOrNone) {
  // lift needs both and goes first; then each goes on alone.
  NetworkBuilder plan(kMonday);
  plan.crew("c").crew("d");
  plan.task("one", kHour, {"c"}).task("two", 3 * kHour, {"d"});
  plan.task("lift", kHour, {"c", "d"}, {}, 5).task("short", kHour, {"c"});
  EXPECT_EQ(plan.when("one"), "2026-03-02 08:00 .. 2026-03-02 09:00");
  EXPECT_EQ(plan.when("lift"), "2026-03-02 07:00 .. 2026-03-02 08:00");
  EXPECT_EQ(plan.when("two"), "2026-03-02 08:00 .. 2026-03-02 11:00");
  EXPECT_EQ(plan.when("short"), "2026-03-02 09:00 .. 2026-03-02 10:00");
}

TEST(Network, WaitsForTheCrewThatIsFreeLast) {
  NetworkBuilder plan(kMonday);
  plan.crew("c").crew("d");
  plan.task("one", kHour, {"c"}, {}, 9).task("two", 3 * kHour, {"d"}, {}, 9);
  plan.task("lift", kHour, {"c", "d"}).task("short", kHour, {"c"});
  EXPECT_EQ(plan.when("lift"), "2026-03-02 10:00 .. 2026-03-02 11:00");
  EXPECT_EQ(plan.when("short"), "2026-03-02 08:00 .. 2026-03-02 09:00");
  EXPECT_THAT(plan.chain(), ElementsAre("two starts with the plan",
                                        "lift starts when 'd' is free, which two had"));
}

TEST(Network, WorksWhenAllCrewsDo) {
  // Weekdays 07-12, 13-16 and every day 10-18: Thursday 10-12, 13-16 is 5 h, Friday 10-12 2 h.
  CalendarRules late;
  late.name = "late";
  late.shifts = {{0, 6, {{10 * 60, 18 * 60}}}};
  NetworkBuilder plan(kThursday);
  plan.crew("c", test::weekday_shift()).crew("d", late);
  plan.task("both", 7 * kHour, {"c", "d"}).task("next", kHour, {"d"}, {{"both"}});
  EXPECT_EQ(plan.when("both"), "2026-03-05 10:00 .. 2026-03-06 12:00");
  EXPECT_EQ(plan.when("next"), "2026-03-06 12:00 .. 2026-03-06 13:00");
}

TEST(Network, CallsACrewAgainAfterTheWeekendByPriority) {
  // first ends with Friday's shift; on Tuesday the crew goes to the more urgent one, though the
  // other was ready on Thursday.
  NetworkBuilder plan(kThursday);
  plan.crew("c", test::weekday_shift());
  plan.task("first", 16 * kHour, {"c"}, {}, 9).task("old", kHour, {"c"});
  plan.task("weekend", 40 * kHour, {}, {{"first"}});  // by nobody: Friday 16:00 to Sunday 08:00
  plan.task("urgent", kHour, {"c"}, {{"weekend"}}, 5);
  EXPECT_EQ(plan.when("weekend"), "2026-03-06 16:00 .. 2026-03-08 08:00");
  EXPECT_EQ(plan.when("urgent"), "2026-03-10 07:00 .. 2026-03-10 08:00");
  EXPECT_EQ(plan.when("old"), "2026-03-10 08:00 .. 2026-03-10 09:00");
  EXPECT_THAT(plan.chain(),
              ElementsAre("first starts with the plan", "weekend starts after first (FS)",
                          "urgent starts after weekend (FS), 47 h later: the next shift (less than "
                          "40 h sooner gains nothing)",
                          "old starts when 'c' is free, which urgent had"));
}

TEST(Network, PutsMilestonesWhereTheirLinksDo) {
  // Work ends with Friday's shift and so does the milestone, though no shift follows until Tuesday;
  // it waits for no crew either.
  NetworkBuilder plan(kThursday);
  plan.crew("c", test::weekday_shift());
  plan.task("a", 16 * kHour, {"c"}).task("done", 0, {"c"}, {{"a"}}).task("alone", 0);
  plan.task("sunday", 0, {}, {{"a", FS, 48 * kHour}}).task("b", kHour, {"c"}, {{"done"}});
  EXPECT_EQ(plan.when("done"), "2026-03-06 16:00 .. 2026-03-06 16:00");
  EXPECT_EQ(plan.when("sunday"), "2026-03-08 16:00 .. 2026-03-08 16:00");
  EXPECT_EQ(plan.when("alone"), "2026-03-05 07:00 .. 2026-03-05 07:00");
  EXPECT_EQ(plan.when("b"), "2026-03-10 07:00 .. 2026-03-10 08:00");
}

TEST(Network, TakesTheLatestOfSeveralLinks) {
  NetworkBuilder plan(kMonday);
  plan.task("a", 2 * kHour).task("b", 5 * kHour).task("c", 4 * kHour);
  plan.task("d", kHour, {}, {{"a"}, {"b"}, {"c", FS, 30 * kMinute}});
  EXPECT_EQ(plan.when("d"), "2026-03-02 12:00 .. 2026-03-02 13:00");
  EXPECT_THAT(plan.chain(), ElementsAre("b starts with the plan", "d starts after b (FS)"));
}

TEST(Network, StartsAndFinishesByDifferentLinks) {
  // e starts with b (12:00) but must not finish before d + 1 h (16:00): 2 h of work start at 14:00.
  NetworkBuilder plan(kMonday);
  plan.task("a", 5 * kHour).task("b", kHour, {}, {{"a"}}).task("d", 8 * kHour);
  plan.task("e", 2 * kHour, {}, {{"b", SS}, {"d", FF, kHour}});
  EXPECT_EQ(plan.when("e"), "2026-03-02 14:00 .. 2026-03-02 16:00");
  EXPECT_THAT(plan.chain(), ElementsAre("d starts with the plan",
                                        "e finishes after d (FF + 1 h); "
                                        "its own work does not count"));
}

TEST(Network, NamesTheLinkWhereALinkAndACrewSayTheSame) {
  NetworkBuilder plan(kMonday);
  plan.crew("c").task("a", kHour, {"c"}).task("b", kHour, {"c"}, {{"a"}});
  EXPECT_THAT(plan.chain(), ElementsAre("a starts with the plan", "b starts after a (FS)"));
}

TEST(Network, BeginsTheChainAtTheFirstInTheFileOfThoseThatFinishLast) {
  NetworkBuilder plan(kMonday);
  plan.task("a", kHour).task("b", 3 * kHour).task("c", 3 * kHour);
  EXPECT_THAT(plan.chain(), ElementsAre("b starts with the plan"));
}

TEST(Network, FollowsTheChainThroughTheStartOfATask) {
  NetworkBuilder plan(kMonday);
  plan.task("a", 5 * kHour).task("b", kHour, {}, {{"a"}});
  plan.task("c", 90 * kMinute, {}, {{"b", SS, 45 * kMinute}});
  EXPECT_EQ(plan.when("c"), "2026-03-02 12:45 .. 2026-03-02 14:15");
  EXPECT_THAT(plan.chain(), ElementsAre("a starts with the plan",
                                        "b starts after a (FS); its own work does not count",
                                        "c starts after b (SS + 45 min)"));
}

TEST(Network, SaysHowMuchSoonerHelps) {
  // concrete is poured and cures by nobody until Saturday 07:00; strip waits for Tuesday's shift.
  // It would start sooner only if the concrete were ready within Friday's shift: 15 h sooner and
  // more.
  NetworkBuilder plan(kThursday);
  plan.crew("c", test::weekday_shift());
  plan.task("cure", 48 * kHour).task("strip", kHour, {"c"}, {{"cure"}});
  const NetworkTimes times = plan.times();
  EXPECT_EQ(plan.when("strip"), "2026-03-10 07:00 .. 2026-03-10 08:00");
  EXPECT_EQ(times.tasks[1].first_gain, 15 * kHour);
  EXPECT_EQ(times.tasks[0].first_gain, 0);
}

TEST(Network, HoldsTheFinishOfTasksTiedAtBothEnds) {
  // guard starts with work and ends after it: it starts at once, its 1 h of work is done, its end
  // and its crew are held until work ends.
  NetworkBuilder plan(kMonday);
  plan.crew("c");
  plan.task("guard", kHour, {"c"}, {{"work", FF}}).task("work", 4 * kHour, {}, {{"guard", SS}});
  plan.task("later", kHour, {"c"});
  EXPECT_EQ(plan.when("guard"), "2026-03-02 07:00 .. 2026-03-02 11:00");
  EXPECT_EQ(plan.when("work"), "2026-03-02 07:00 .. 2026-03-02 11:00");
  EXPECT_EQ(plan.when("later"), "2026-03-02 11:00 .. 2026-03-02 12:00");
  EXPECT_THAT(plan.chain(),
              ElementsAre("guard starts with the plan; its own work does not count",
                          "work starts after guard (SS)",
                          "guard finishes after work (FF); its own work does not count",
                          "later starts when 'c' is free, which guard had"));
}

TEST(Network, AllowsATaskToHoldItsOwnFinish) {
  NetworkBuilder plan(kMonday);
  plan.task("cure", kHour, {}, {{"cure", SF, 5 * kHour}});
  EXPECT_EQ(plan.when("cure"), "2026-03-02 07:00 .. 2026-03-02 12:00");
}

TEST(Network, NamesWhatWaitsForWhatAnotherHolds) {
  // guard holds c until work is done, which needs c.
  NetworkBuilder plan(kMonday);
  plan.crew("c");
  plan.task("guard", kHour, {"c"}, {{"work", FF}}).task("work", kHour, {"c"}, {{"guard", SS}});
  EXPECT_EQ(plan.mistakes(),
            "task 'work' never gets 'c': 'guard' holds it until its links let it finish, and they "
            "wait for tasks that cannot go on");
}

TEST(Network, NamesRingsOfLinks) {
  NetworkBuilder plan(kMonday);
  plan.task("a", kHour, {}, {{"c"}}).task("b", kHour, {}, {{"a"}}).task("c", kHour, {}, {{"b"}});
  plan.task("free", kHour, {}, {{"c"}}).task("x", kHour, {}, {{"x"}});
  plan.task("p", kHour, {}, {{"q", SS}}).task("q", kHour, {}, {{"p", SS}});
  EXPECT_EQ(plan.mistakes(),
            "these tasks wait for each other: a after c after b after a\n"
            "task 'x' waits for itself\n"
            "these tasks wait for each other: p after q after p");
}

TEST(Network, NamesALongRingInShort) {
  NetworkBuilder plan(kMonday);
  constexpr int kTasks = 5000;
  for (int i = 0; i < kTasks; ++i) {
    plan.task("t" + std::to_string(i), kHour, {}, {{"t" + std::to_string((i + 1) % kTasks)}});
  }
  EXPECT_THAT(plan.mistakes(), HasSubstr("t11 after ... (4988 more) after t0"));
}

TEST(Network, RefusesCrewsWithoutCommonHours) {
  CalendarRules night;
  night.name = "night";
  night.shifts = {{0, 6, {{20 * 60, 24 * 60}}}};
  NetworkBuilder plan(kMonday);
  plan.crew("c", test::daily_shift()).crew("d", night).task("a", kHour, {"c", "d"});
  EXPECT_EQ(plan.mistakes(), "calendars 'daily', 'night' have no working hours in common");
}

TEST(Network, RefusesNumbersThatMakeNoSense) {
  Network network;
  network.resources = {{"c", 3}, {"d", -2}};
  network.tasks.resize(2);
  network.tasks[0].name = "a";
  network.tasks[0].work = -1;
  network.tasks[0].priority = std::numeric_limits<double>::quiet_NaN();
  network.tasks[0].resources = {0, 0, 9};
  network.tasks[0].after = {{7}, {-1}};
  const auto result = times_of(network);
  EXPECT_THAT(
      std::get<NetworkMistakes>(result).messages,
      ElementsAre("'c' works by calendar number 3, which is not there",
                  "'d' works by calendar number -2, which is not there",
                  "task 'a' has a negative amount of work", "the priority of task 'a' is no number",
                  "task 'a' needs the same resource twice",
                  "task 'a' needs resource number 9, which is not there",
                  "task 'a' comes after task number 7, which is not there",
                  "task 'a' comes after task number -1, which is not there"));
}

TEST(Network, RefusesWhatNeverEnds) {
  NetworkBuilder plan(kMonday);
  plan.task("a", kEndOfTime - kHour).task("b", std::numeric_limits<Ticks>::max(), {}, {{"a"}});
  plan.task("c", kHour, {}, {{"b", FS, std::numeric_limits<Ticks>::max()}});
  EXPECT_EQ(plan.mistakes(), "task 'b' is not done within 126 years of the start");
}

TEST(Network, IsDoneAtOnceWithoutTasks) {
  EXPECT_EQ(NetworkBuilder(kMonday).times().finish, 0);
  EXPECT_TRUE(NetworkBuilder(kMonday).chain().empty());
}

}  // namespace
}  // namespace rubicon::schedule
