#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "interpreter/check/plan_model.hpp"
#include "interpreter/machine/machine.hpp"
#include "interpreter/program/events.hpp"
#include "interpreter/syntax/source.hpp"
#include "src/motion/coverage/joints.hpp"
#include "src/simulation/trace/trace_sink.hpp"

namespace rubicon::trace {

/// A machine broke down: after `worked`, the first safe place after `every`.
struct MachineBreakdown {
  std::string_view machine;
  std::string_view during;  ///< the task that it had
  interpreter::Ticks every = 0;
  interpreter::Ticks worked = 0;
  interpreter::Ticks repair = 0;  ///< in its working hours
  interpreter::Ticks from = 0;
  interpreter::Ticks until = 0;
};

/// Of rounds of trucks by durations, s: in which the trucks together drive, and each of those who
/// serve them has one.
struct TruckTimes {
  double driving = 0;
  std::vector<double> serving;
};

/// So many searches of a run are told with where their robot may not stand, the first: each takes
/// tens of thousands of tests. What is taken back counts.
inline constexpr int kMostGrids = 32;

/// Writes a run as JSON lines (docs/trace.md), record by record as it happens. One line is kept at
/// a time. Plan, sources and sink must outlive it.
class TraceWriter : public interpreter::EventSink {
 public:
  TraceWriter(TraceSink& sink, const interpreter::PlanModel& plan,
              const interpreter::SourceMap& sources, TraceDetail detail);

  /// The first line; once, before anything else.
  void header();

  /// Names the task and the robot (index into the plan's, -1 none) that all later records belong
  /// to.
  void set_task(std::string_view task, int robot);

  /// `because`: a sentence why it starts now; `after`: the task it waited for, "" for none;
  /// `chosen`: whom it has of its pools; `to`: where a vehicle of a fleet goes out of the way, as
  /// values of the parameters of its park.
  void task_start(interpreter::Ticks time, std::string_view because = {},
                  std::string_view after = {}, std::string_view chosen = {},
                  const std::vector<std::pair<int, double>>& to = {});
  /// `result` is done, short, rejected or "not reached"; `time` the clock from which the plan goes
  /// on.
  void task_end(interpreter::Ticks time, std::string_view result, std::string_view reason,
                const std::optional<TruckTimes>& rounds = {});
  /// The component joins the tool; X_TO is where its frame {O} is in the tool frame.
  void attach(std::string_view component, const math::Pose& X_TO, interpreter::Ticks time);
  /// The component stands on its own again, at X_WO.
  /// `overtime`: of its lift, out of the shifts of all that it needs.
  void detach(std::string_view component, const math::Pose& X_WO, interpreter::Ticks time,
              interpreter::Ticks overtime = 0);
  /// The component leaves the site.
  void remove(std::string_view component, interpreter::Ticks time);
  /// Crew work from `from` to `to`, of which `time` is in shifts; `what` is hook, adjust, release
  /// or takes.
  void work(std::string_view what, std::string_view crew, interpreter::Ticks from,
            interpreter::Ticks to, interpreter::Ticks time);
  /// People turn the load about the vertical from `from` to `to`, after which it hangs at X_TO;
  /// `refused` is what the shorter way would have met.
  void turn(std::string_view component, double angle_deg, const math::Pose& X_TO,
            interpreter::Ticks from, interpreter::Ticks to,
            const std::optional<interpreter::HitPair>& refused);
  /// The task stood still; `why` is machine, crew, shift, held, lift or repair.
  void pause(std::string_view why, std::string_view whom, interpreter::Ticks from,
             interpreter::Ticks to);
  /// Something with a timetable stops before `by`, or goes on (""); `delay`: by how much its
  /// timetable has shifted up to then.
  void moving(std::string_view name, std::string_view by, interpreter::Ticks delay,
              interpreter::Ticks time);
  /// What a task laid has a joint that is over its limit.
  void cold_joint(const coverage::ColdJoint& joint, interpreter::Ticks time);
  void breakdown(const MachineBreakdown& breakdown);
  /// Of the `of` days with working time that a calendar has up to `end` the weather took these.
  void lost_days(std::string_view calendar, int of, const std::vector<std::string>& days,
                 interpreter::Ticks end);
  /// A bucket has taken so many mm3 of the component; cells and their new heights in mm.
  void soil(std::string_view component, soil::CubicMillimetres volume,
            const std::map<int, soil::Millimetres>& heights, interpreter::Ticks from,
            interpreter::Ticks to);
  void motion_end(const interpreter::MotionEnd& end);

  void goal(int k, int n) override;
  void guide(const interpreter::GuidePlan& plan) override;
  void think(const interpreter::Thinking& thinking) override;
  void foreseen(const interpreter::ForeseenWay& way, interpreter::Ticks time) override;
  void way_point(int k, int n) override;
  void set(const std::string& variable, double value, interpreter::Span span) override;
  void enter(interpreter::LoopKind kind, interpreter::Span span) override;
  void exit(interpreter::LoopKind kind, interpreter::Span span, bool reached,
            int successes) override;
  void which(const std::string& label, interpreter::Span span) override;
  void attempt(const interpreter::Attempt& attempt) override;
  void wait(int n, interpreter::Ticks time, interpreter::Span span) override;
  void stop(interpreter::Ticks time) override;

 private:
  void begin(const char* type);
  void finish();
  void place(interpreter::Span span);
  void span_of_time(interpreter::Ticks from, interpreter::Ticks to);
  void load(const char* type, std::string_view component, const math::Pose& X,
            interpreter::Ticks time, interpreter::Ticks overtime);
  void hit(const interpreter::HitPair& pair);
  void configuration(std::span<const double> q);
  void configuration_key(int parameter);
  void append_graph(const guides::PlanReport& report);
  void append_list(const char* name, std::span<const double> values);
  void forbidden(const guides::ForbiddenGrid& grid, interpreter::Ticks time);
  bool steps() const { return detail_ == TraceDetail::steps; }

  TraceSink& sink_;
  const interpreter::PlanModel& plan_;
  const interpreter::SourceMap& sources_;
  TraceDetail detail_;
  std::string whose_;              ///< the task and robot members of every record
  std::vector<std::string> keys_;  ///< "name": per parameter of the robot
  std::map<std::pair<interpreter::FileId, std::uint32_t>, std::string>
      places_;  ///< file, line and column members, by start of span
  std::string line_;
  int grids_left_ = kMostGrids;  ///< of those that are sampled
};

}  // namespace rubicon::trace
