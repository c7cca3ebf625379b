#include "tests/unit/schedule/network_cases.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include "src/simulation/schedule/critical_chain.hpp"
#include "tests/unit/schedule/calendar_cases.hpp"

namespace rubicon::test {

using schedule::Network;
using schedule::NetworkMistakes;
using schedule::NetworkTimes;
using schedule::TaskTimes;

NetworkTimes calculated(const Network& network) {
  auto times = times_of(network);
  if (const auto* mistakes = std::get_if<NetworkMistakes>(&times)) {
    ADD_FAILURE() << mistakes->messages.front();
    return {std::vector<TaskTimes>(network.tasks.size()), 0};
  }
  return std::get<NetworkTimes>(std::move(times));
}

NetworkBuilder& NetworkBuilder::crew(const std::string& name,
                                     const std::optional<schedule::CalendarRules>& rules) {
  int index = -1;
  if (rules) {
    index = static_cast<int>(network_.calendars.size());
    network_.calendars.push_back(calendar(*rules, start_));
  }
  network_.resources.push_back({name, index});
  return *this;
}

NetworkBuilder& NetworkBuilder::task(const std::string& name, schedule::Ticks work,
                                     const std::vector<std::string>& crews,
                                     const std::vector<After>& after, double priority) {
  schedule::NetworkTask task;
  task.name = name;
  task.work = work;
  task.priority = priority;
  for (const std::string& crew : crews) {
    for (std::size_t i = 0; i < network_.resources.size(); ++i) {
      if (network_.resources[i].name == crew) task.resources.push_back(static_cast<int>(i));
    }
  }
  EXPECT_EQ(task.resources.size(), crews.size()) << name;
  network_.tasks.push_back(task);
  after_.push_back(after);
  return *this;
}

Network NetworkBuilder::network() const {
  Network result = network_;
  for (std::size_t task = 0; task < after_.size(); ++task) {
    for (const After& each : after_[task]) {
      result.tasks[task].after.push_back({index(each.task), each.type, each.lag, each.clock});
    }
  }
  return result;
}

NetworkTimes NetworkBuilder::times() const {
  auto result = schedule::times_of(network());
  EXPECT_EQ(mistakes(), "");
  if (std::holds_alternative<NetworkMistakes>(result)) {
    return {std::vector<TaskTimes>(network_.tasks.size()), 0};
  }
  return std::get<NetworkTimes>(std::move(result));
}

std::string NetworkBuilder::mistakes() const {
  const auto result = schedule::times_of(network());
  const auto* mistakes = std::get_if<NetworkMistakes>(&result);
  return mistakes ? fmt::format("{}", fmt::join(mistakes->messages, "\n")) : "";
}

std::string NetworkBuilder::when(const std::string& task) const {
  const schedule::TaskTimes found = times().tasks[static_cast<std::size_t>(index(task))];
  return moment_text(start_, found.start) + " .. " + moment_text(start_, found.finish);
}

std::vector<std::string> NetworkBuilder::chain() const {
  std::vector<std::string> result;
  for (const schedule::ChainStep& step : schedule::critical_chain(network(), times())) {
    result.push_back(schedule::text_of(network(), step));
  }
  return result;
}

int NetworkBuilder::index(const std::string& task) const {
  for (std::size_t i = 0; i < network_.tasks.size(); ++i) {
    if (network_.tasks[i].name == task) return static_cast<int>(i);
  }
  ADD_FAILURE() << "no task " << task;
  return 0;
}

}  // namespace rubicon::test
