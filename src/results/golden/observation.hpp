#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "src/simulation/trace/trace_sink.hpp"

namespace rubicon::golden {

/// Where a command stands: file, line, column.
using Place = std::tuple<std::string, int, int>;

/// Listens to a trace and keeps it in the form of `expected.json` and of `expected.trace`.
class Observation : public trace::TraceSink {
 public:
  /// `command_texts`: the canonical text of every command, for people; `starts`: each robot's
  /// configuration at first. `with_tasks`: the plan has tasks; every event then says whose it is.
  Observation(std::map<Place, std::string> command_texts,
              std::map<std::string, nlohmann::ordered_json> starts, bool with_tasks);

  void line(std::string_view record) override;
  void restart() override;

  const nlohmann::ordered_json& events() const { return events_; }
  /// The `end` record of every motion, in order.
  const std::vector<nlohmann::ordered_json>& ends() const { return ends_; }
  /// The events as people read them, one line each.
  const std::string& text() const { return text_; }

 private:
  void add_text(const nlohmann::ordered_json& record);
  void write_try(const nlohmann::ordered_json& record, int n);

  std::map<Place, std::string> command_texts_;
  bool with_tasks_;
  nlohmann::ordered_json events_ = nlohmann::ordered_json::array();
  std::vector<nlohmann::ordered_json> ends_;
  std::string text_;
  int depth_ = 0;
  std::map<std::string, nlohmann::ordered_json> starts_;
  std::map<std::string, nlohmann::ordered_json>
      q_;  ///< per robot: the configuration before its next try
};

/// One event in one line, for differences.
std::string describe(const nlohmann::ordered_json& event);

/// A reason with its places as `(file:line)`: where the case lies must not matter to what is
/// expected.
std::string without_folders(std::string reason);

/// A number as people read it: at most six digits.
std::string brief(double value);

}  // namespace rubicon::golden
