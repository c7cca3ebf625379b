// What is known of starts and finishes, and what links make of it: without machines, crews or a
// queue of events.

#include "src/simulation/schedule/link_state.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace rubicon::schedule {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

struct Heard : LinkState::Listener {
  void may_start(int task, int before) override {
    said.push_back("start " + std::to_string(task) + " by " + std::to_string(before));
  }
  void may_finish(int task) override { said.push_back("finish " + std::to_string(task)); }
  std::vector<std::string> said;
};

/// Tasks of a second of work each, but for those in `unknown`.
LinkState state(const std::vector<std::vector<Link>> &links, const std::vector<int> &unknown = {}) {
  static const WorkCalendar day_and_night;
  Network network;
  std::vector<Ticks> work;
  for (const auto &after : links) {
    network.tasks.emplace_back().after = after;
    network.tasks.back().work = 1;
    work.push_back(1);
  }
  for (const int task : unknown) work[static_cast<std::size_t>(task)] = -1;
  return {std::move(network), std::move(work), {}, [](int) -> const WorkCalendar & {
            return day_and_night;
          }};
}

std::vector<std::string> propagate(LinkState &links) {
  Heard heard;
  links.propagate(heard);
  return heard.said;
}

TEST(LinkState, WhoHasNoLinksMayStart) {
  const LinkState links = state({{}, {{0, LinkType::FS, 0}}});
  EXPECT_TRUE(links.may_start(0));
  EXPECT_FALSE(links.may_start(1));
}

TEST(LinkState, EachTypeOfLinkWaitsForItsEvent) {
  LinkState links = state({{},
                           {{0, LinkType::FS, 0}},
                           {{0, LinkType::SS, 0}},
                           {{0, LinkType::FF, 0}},
                           {{0, LinkType::SF, 0}}},
                          {3, 4});
  EXPECT_TRUE(links.may_start(3));  // its links hold its finish only
  links.publish(0, TaskEnd::start, 5);
  EXPECT_THAT(propagate(links), ElementsAre("start 2 by 0", "finish 4"));
  links.publish(0, TaskEnd::finish, 6);
  EXPECT_THAT(propagate(links), ElementsAre("start 1 by 0", "finish 3"));
  EXPECT_THAT(propagate(links), IsEmpty());
}

TEST(LinkState, KnownWorkWaitsToStartForWhatHoldsItsFinish) {
  LinkState links = state({{}, {{0, LinkType::FF, 10}}});
  EXPECT_FALSE(links.may_start(1));
  EXPECT_THAT(links.open_links(1, TaskEnd::start), ElementsAre(0));
  links.publish(0, TaskEnd::finish, 100);
  EXPECT_THAT(propagate(links), ElementsAre("finish 1", "start 1 by 0"));
  EXPECT_EQ(links.ready_times(1, 0, 100).start, 109);
  EXPECT_EQ(links.bounds_of(1, true).finish, 110);
  EXPECT_EQ(links.bounds_of(1, false).finish, -kEndOfTime);
}

TEST(LinkState, WhatANegativeLagAllowsMayBeOverWhenItIsKnown) {
  LinkState links = state({{}, {{0, LinkType::FS, -30}}});
  links.publish(0, TaskEnd::finish, 20);
  propagate(links);
  const TaskTimes times = links.ready_times(1, 0, 20);
  EXPECT_EQ(times.start, 20);
  EXPECT_TRUE(times.known_late);
  EXPECT_EQ(times.link, 0);
}

TEST(LinkState, GoesBackToAMark) {
  LinkState links = state({{}, {{0, LinkType::FS, 0}}, {{0, LinkType::FF, 0}}}, {2});
  const auto mark = links.mark();
  links.publish(0, TaskEnd::start, 3);
  links.publish(0, TaskEnd::finish, 4);
  links.add_mid_wait(0, {});
  EXPECT_THAT(propagate(links), ElementsAre("start 1 by 0", "finish 2"));
  links.undo_to(mark);
  EXPECT_FALSE(links.is_known(0, TaskEnd::start));
  EXPECT_FALSE(links.may_start(1));
  EXPECT_FALSE(links.may_finish(2));
  EXPECT_THAT(links.times(0).mid_waits, IsEmpty());
  links.publish(0, TaskEnd::finish, 9);
  EXPECT_THAT(propagate(links), ElementsAre("start 1 by 0", "finish 2"));
  EXPECT_EQ(links.bounds_of(1, false).start, 9);
}

TEST(LinkState, WhoIsLeftOutHoldsNobody) {
  LinkState links = state({{}, {{0, LinkType::FF, 0}}, {{1, LinkType::FS, 0}}}, {1, 2});
  EXPECT_FALSE(links.may_finish(1));
  links.leave_out(0);
  EXPECT_TRUE(links.let_go(1, 0, LinkType::FF));
  EXPECT_TRUE(links.may_finish(1));
  EXPECT_EQ(links.bounds_of(1, true).finish_link, -1);
  links.leave_out(2);
  links.publish(1, TaskEnd::finish, 1);
  EXPECT_THAT(propagate(links), IsEmpty());
  links.leave_out(1);
  links.count_links();
  EXPECT_TRUE(links.may_start(2));
}

}  // namespace
}  // namespace rubicon::schedule
