#pragma once

#include <optional>
#include <string>
#include <vector>

#include "src/simulation/schedule/calendar_rules.hpp"
#include "src/simulation/schedule/network.hpp"

namespace rubicon::test {

/// The times of a network; the test fails where it has mistakes.
schedule::NetworkTimes calculated(const schedule::Network& network);

/// A network put together by names, for a plan that starts at `start`.
class NetworkBuilder {
 public:
  explicit NetworkBuilder(std::string start) : start_(std::move(start)) {}

  /// A crew; without rules it works day and night.
  NetworkBuilder& crew(const std::string& name,
                       const std::optional<schedule::CalendarRules>& rules = {});

  /// "after": a name, a type and a lag, as in {"a", LinkType::SS, 2 * kHour}.
  struct After {
    std::string task;
    schedule::LinkType type = schedule::LinkType::FS;
    schedule::Ticks lag = 0;
    schedule::LagClock clock = schedule::LagClock::elapsed;
  };
  /// A task by crews that are there. Tasks may come after those that follow in the file.
  NetworkBuilder& task(const std::string& name, schedule::Ticks work,
                       const std::vector<std::string>& crews = {},
                       const std::vector<After>& after = {}, double priority = 0);

  schedule::Network network() const;

  /// The times, which must be there.
  schedule::NetworkTimes times() const;

  /// The mistakes, one a line; "" if there are none.
  std::string mistakes() const;

  /// "START .. FINISH" of a task.
  std::string when(const std::string& task) const;

  /// The critical path in sentences.
  std::vector<std::string> chain() const;

  int index(const std::string& task) const;

 private:
  std::string start_;
  schedule::Network network_;
  std::vector<std::vector<After>> after_;
};

}  // namespace rubicon::test
