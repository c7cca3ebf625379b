#pragma once

#include <simdjson.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "src/results/film/film_runs.hpp"
#include "src/results/film/film_writer.hpp"
#include "src/results/film/record_columns.hpp"
#include "src/results/film/record_simdjson.hpp"
#include "src/results/film/robot_tracks.hpp"
#include "src/results/film/scene.hpp"
#include "src/results/film/string_table.hpp"

namespace rubicon::film {

/// All that a film writer has read so far.
class FilmWriter::Reel {
 public:
  void line(std::string_view text);
  bool has_header() const { return scene_.has_value(); }
  Film finish(std::string_view schedule);

 private:
  Record parse(std::string_view text);
  void record(const Record& record);
  int run_of(const Record& record, RecordKind kind);
  double time_of(const Record& record, RecordKind kind, const FilmRun& run) const;

  void write_goal(const Record& record);
  void write_set(const Record& record);
  void write_enter(const Record& record);
  void write_exit(const Record& record);
  void write_which(const Record& record);
  void write_try(const Record& record, int run);
  void write_work(const Record& record, int run);
  void write_pause(const Record& record, int run);
  void write_load(const Record& record, Column& component, PoseColumn* pose);
  void write_end(const Record& record, int run);
  void end_task(const Record& record, int run);

  std::int64_t string(std::string_view text) { return strings_.number(text); }
  std::int64_t place(const Record& record);
  void move(const Record& record, int run);

  std::string padded_;  ///< the line, with what the parser wants behind it
  simdjson::dom::parser parser_;
  std::optional<Scene> scene_;
  std::optional<RobotTracks> tracks_;
  FilmRuns runs_;
  StringTable strings_;
  PlaceTable places_;
  RecordColumns columns_;
  std::vector<double> q_;
};

}  // namespace rubicon::film
