#pragma once

#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "src/simulation/trace/record.hpp"
#include "src/simulation/trace/trace_reader.hpp"
#include "src/simulation/trace/trace_sink.hpp"

namespace rubicon::golden {

/// Where a command stands: file, line, column.
using Place = std::tuple<std::string, int, int>;

/// Values of parameters by name (m or degrees).
using Values = std::map<std::string, double, std::less<>>;

/// The end of a motion: the values by name and, as they were, the refused attempts by reason.
struct ObservedEnd {
  std::string status;
  std::optional<int> period;
  int tries = 0;
  int accepted = 0;
  trace::RefusalCounts rejected;
  std::vector<std::pair<std::string, double>> residual;
  nlohmann::ordered_json q;
  nlohmann::ordered_json variables;
};

/// Listens to a trace and keeps it in the form of `expected.json` and of `expected.trace`.
class Observation : public trace::TraceSink {
 public:
  /// `command_texts`: the canonical text of every command, for people; `starts`: each robot's
  /// configuration at first. `with_tasks`: the plan has tasks; every event then says whose it is.
  Observation(std::map<Place, std::string> command_texts, std::map<std::string, Values> starts,
              bool with_tasks);

  void line(std::string_view record) override;
  void restart() override;

  const nlohmann::ordered_json& events() const { return events_; }
  /// The end of every motion, in order.
  const std::vector<ObservedEnd>& ends() const { return ends_; }
  /// The events as people read them, one line each.
  const std::string& text() const { return text_; }

 private:
  void add(const trace::Record& record);
  void write(const std::string& text);
  // The lines of text of a record; some records have none.
  template <typename Other>
  void write_event(const trace::Record&, const Other&) {}
  void write_event(const trace::Record& record, const trace::TaskStart& start);
  void write_event(const trace::Record& record, const trace::GoalStart& goal);
  void write_event(const trace::Record& record, const trace::Assignment& assignment);
  void write_event(const trace::Record& record, const trace::LoopStart& loop);
  void write_event(const trace::Record& record, const trace::LoopEnd& loop);
  void write_event(const trace::Record& record, const trace::Choice& choice);
  void write_event(const trace::Record& record, const trace::Attempt& attempt);
  void write_event(const trace::Record& record, const trace::Wait& wait);
  void write_event(const trace::Record& record, const trace::Stop& stop);
  void write_event(const trace::Record& record, const trace::Think& think);
  void write_event(const trace::Record& record, const trace::GuidePlan& plan);
  void write_event(const trace::Record& record, const trace::WayPoint& point);
  void write_event(const trace::Record& record, const trace::Attach& attach);
  void write_event(const trace::Record& record, const trace::Detach& detach);
  void write_event(const trace::Record& record, const trace::Turn& turn);
  void write_event(const trace::Record& record, const trace::MotionEnd& end);
  void write_event(const trace::Record& record, const trace::TaskEnd& end);

  trace::TraceReader reader_;
  std::map<Place, std::string> command_texts_;
  bool with_tasks_;
  nlohmann::ordered_json events_ = nlohmann::ordered_json::array();
  std::vector<ObservedEnd> ends_;
  std::string text_;
  int depth_ = 0;
  std::map<std::string, Values> starts_;
  std::map<std::string, Values> q_;  ///< per robot: the configuration before its next try
};

/// One event in one line, for differences.
std::string describe(const nlohmann::ordered_json& event);

/// A reason with its places as `(file:line)`: where the case lies must not matter to what is
/// expected.
std::string without_folders(std::string reason);

/// A number as people read it: at most six digits.
std::string brief(double value);

}  // namespace rubicon::golden
