#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "src/results/film/film_runs.hpp"
#include "src/results/film/film_writer.hpp"
#include "src/results/film/record_columns.hpp"
#include "src/results/film/robot_tracks.hpp"
#include "src/results/film/scene.hpp"
#include "src/results/film/string_table.hpp"
#include "src/simulation/trace/parameter_value.hpp"
#include "src/simulation/trace/trace_reader.hpp"

namespace rubicon::film {

/// All that a film writer has read so far.
class FilmBuilder {
 public:
  void line(std::string_view text);
  bool has_header() const { return reader_.has_header(); }
  Film finish(std::string_view schedule, std::string_view flow);

 private:
  void record(const trace::Record& record);
  int run_of(const trace::Record& record);
  int begin(const trace::Record& record);
  double time_of(const trace::Record& record, const FilmRun& run) const;

  // What the columns of each kind keep of a record of a run.
  void write(const trace::TaskStart& start, int run);
  void write(const trace::GoalStart& goal, int run);
  void write(const trace::Assignment& assignment, int run);
  void write(const trace::LoopStart& loop, int run);
  void write(const trace::LoopEnd& loop, int run);
  void write(const trace::Choice& choice, int run);
  void write(const trace::Attempt& attempt, int run);
  void write(const trace::Wait& wait, int run);
  void write(const trace::Work& work, int run);
  void write(const trace::Pause& pause, int run);
  void write(const trace::Attach& attach, int run);
  void write(const trace::Detach& detach, int run);
  void write(const trace::Removal& removal, int run);
  void write(const trace::MotionEnd& end, int run);
  void write(const trace::TaskEnd& end, int run);
  void write(const trace::Stop& stop, int run);
  void write(const trace::Think& think, int run);
  void write(const trace::GuidePlan& plan, int run);
  void write(const trace::WayPoint& point, int run);
  void write(const trace::Turn& turn, int run);
  void write(const trace::Moving&, int) {}  // of no run, as the next two
  void write(const trace::Breakdown&, int) {}
  void write(const trace::LostDays&, int) {}
  void write(const trace::ColdJoint& joint, int run);
  void write(const trace::Soil&, int) {}       // in soils_
  void write(const trace::Foreseen&, int) {}   // in foreseen_
  void write(const trace::Forbidden&, int) {}  // in graphs_

  std::int64_t string(std::string_view text) { return strings_.number(text); }
  std::int64_t place(const trace::InText& place);
  std::int64_t component(std::string_view name) const;
  void move(trace::Configuration q, int run);

  trace::TraceReader reader_;
  Scene scene_;
  std::optional<RobotTracks> tracks_;
  FilmRuns runs_;
  StringTable strings_;
  PlaceTable places_;
  RecordColumns columns_;
  std::vector<double> q_;
  /// Stops and starts of what keeps a timetable, as they happen; times in s.
  struct MovingStop {
    std::string name, by;
    double delay = 0, t = 0;
  };
  std::vector<MovingStop> movings_;
  /// Buckets of soil, as they are dug.
  struct SoilTaken {
    int run = 0;
    std::int64_t component = 0;
    double t = 0;
    std::vector<double> cells, heights;  ///< whole numbers; mm
  };
  std::vector<SoilTaken> soils_;
  /// What machines were foreseen to sweep, as the trace tells it.
  struct ForeseenWay {
    int run = 0;
    std::string machine;
    double seconds = 0, t = 0;
    std::vector<double> corners, points;
  };
  std::vector<ForeseenWay> foreseen_;
  /// Ways that guides walked in the plan view, as the trace tells them.
  struct Walk {
    int run = 0;
    double t = 0;
    std::vector<double> way;
    std::vector<std::string> events;
  };
  std::vector<Walk> walks_;
  /// Where a robot may not stand about what its guide searched through, as the trace tells it.
  struct ForbiddenCells {
    std::vector<std::string> parameters;
    std::vector<double> low, high, cells, layers, at, runs;
  };
  void add_forbidden(const trace::Forbidden& grid, int run);
  /// What guides searched through, in full traces: of each leg both configurations.
  struct SearchGraph {
    int run = 0;
    double t = 0;
    int legs = 0;
    std::vector<double> values;
    std::optional<ForbiddenCells> forbidden = {};
  };
  std::vector<SearchGraph> graphs_;
};

}  // namespace rubicon::film
