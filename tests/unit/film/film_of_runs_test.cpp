// Films of real runs against their traces, read here by other means.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "interpreter/check/plan_model.hpp"
#include "src/exchange/files/disk_io.hpp"
#include "src/results/film/film_writer.hpp"
#include "src/simulation/taskplan/run_plan.hpp"
#include "tests/support/places.hpp"
#include "tests/unit/film/film_decoder.hpp"

namespace rubicon::film {
namespace {

using nlohmann::ordered_json;
using test::DecodedFilm;
using test::DecodedTrack;

/// Millionths: 2 that docs/film.md allows, and half a one of rounding the value of the trace.
constexpr double kSlack = 2.5;
constexpr double kTurn = 360e6;

/// The lines of a trace, and the film of them.
class Ran : public trace::TraceSink {
 public:
  Ran(const std::string& plan, trace::TraceDetail detail) {
    files::DiskFiles disk;
    interpreter::SourceMap sources;
    interpreter::Diagnostics diagnostics;
    const auto model =
        interpreter::load_plan(test::source_dir() + "/" + plan, sources, disk, diagnostics);
    if (!model) throw std::runtime_error("cannot read " + plan);
    taskplan::RunOptions options;
    options.detail = detail;
    taskplan::run_plan(*model, sources, this, options);
  }

  void line(std::string_view text) override {
    lines.emplace_back(text);
    writer_.line(text);
  }
  void restart() override {
    lines.clear();
    writer_.restart();
  }
  Film finish() { return writer_.finish(""); }

  std::vector<std::string> lines;

 private:
  FilmWriter writer_;
};

std::int64_t millionths_of(const ordered_json& value) {
  return std::llround(value.get<double>() * 1e6);
}

/// The runs of a trace: the numbers of their records.
struct TraceRuns {
  explicit TraceRuns(const std::vector<ordered_json>& records) {
    std::map<std::string, std::size_t> open;
    for (std::size_t i = 0; i < records.size(); ++i) {
      const std::string task = records[i].at("task");
      if (!open.contains(task)) {
        open[task] = runs.size();
        runs.emplace_back();
        result.emplace_back();
      }
      run_of.push_back(static_cast<std::int64_t>(open[task]));
      runs[open[task]].push_back(i);
      if (records[i].at("type") == "task_end") {
        result[open[task]] = records[i].at("result");
        open.erase(task);
      }
    }
  }
  std::vector<std::vector<std::size_t>> runs;
  std::vector<std::string> result;
  std::vector<std::int64_t> run_of;
};

int robot_of(const ordered_json& header, const ordered_json& record) {
  const auto& robots = header.at("robots");
  for (std::size_t i = 0; i < robots.size(); ++i) {
    if (robots.at(i).at("name") == record.at("robot")) return static_cast<int>(i);
  }
  return -1;
}

/// How far a track is from the q of a record, at its time, at most (millionths).
double miss(const DecodedTrack& track, const ordered_json& robot, const ordered_json& record) {
  double worst = 0;
  const auto& parameters = robot.at("parameters");
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const double wanted = record.at("q").at(parameters.at(i).at("name").get<std::string>());
    double best = kTurn;
    for (const double value : track.at(i, millionths_of(record.at("t")))) {
      const double off = value - wanted * 1e6;
      best = std::min(best,
                      std::abs(parameters.at(i).at("cyclic") ? std::remainder(off, kTurn) : off));
    }
    worst = std::max(worst, best);
  }
  return worst;
}

void expect_motion(const DecodedFilm& film, const ordered_json& header,
                   const std::vector<ordered_json>& records) {
  const TraceRuns trace(records);
  std::size_t rejected = 0;
  for (std::size_t run = 0; run < trace.runs.size(); ++run) {
    if (trace.result[run] == "not reached") continue;
    const bool happened = trace.result[run] != "rejected";
    const int robot = robot_of(header, records[trace.runs[run].front()]);
    if (robot < 0) continue;
    rejected += happened ? 0 : 1;
    const DecodedTrack track = film.track(robot, happened ? -1 : static_cast<int>(run));
    ASSERT_TRUE(std::is_sorted(track.t.begin(), track.t.end()));
    for (const std::size_t i : trace.runs[run]) {
      if (!records[i].contains("q") || !records[i].value("ok", true)) continue;
      ASSERT_LE(miss(track, header.at("robots").at(static_cast<std::size_t>(robot)), records[i]),
                kSlack)
          << records[i];
    }
  }
  EXPECT_EQ(film.head.at("tracks").size(), header.at("robots").size() + rejected);
}

/// A member of all records of a type, as text.
std::vector<std::string> members(const std::vector<ordered_json>& records, const char* type,
                                 const char* member) {
  std::vector<std::string> found;
  for (const ordered_json& record : records) {
    if (record.at("type") != type) continue;
    const ordered_json value = record.value(member, ordered_json(""));
    found.push_back(value.is_string() ? value.get<std::string>() : value.dump());
  }
  return found;
}

std::vector<std::string> places_of(const std::vector<ordered_json>& records, const char* type) {
  std::vector<std::string> found;
  for (const ordered_json& record : records) {
    if (record.at("type") != type) continue;
    found.push_back(record.at("file").get<std::string>() + ":" + record.at("line").dump() + ":" +
                    record.at("column").dump());
  }
  return found;
}

std::vector<std::string> as_text(const std::vector<std::int64_t>& numbers) {
  std::vector<std::string> texts;
  for (const std::int64_t number : numbers) texts.push_back(std::to_string(number));
  return texts;
}

std::vector<std::string> as_truth(const std::vector<std::int64_t>& numbers) {
  std::vector<std::string> texts;
  for (const std::int64_t number : numbers) texts.push_back(number == 0 ? "false" : "true");
  return texts;
}

void expect_records(const DecodedFilm& film, const std::vector<ordered_json>& records) {
  const std::vector<std::string> types = {
      "task_start", "goal",   "set",    "enter",  "exit", "which",    "try",  "wait", "work",
      "pause",      "attach", "detach", "remove", "end",  "task_end", "stop", "turn"};
  const TraceRuns trace(records);
  ASSERT_EQ(film.columns.at("record.kind").size(), records.size());
  EXPECT_EQ(film.columns.at("record.run"), trace.run_of);
  for (std::size_t i = 0; i < records.size(); ++i) {
    const auto kind = static_cast<std::size_t>(film.columns.at("record.kind")[i]);
    ASSERT_EQ(types.at(kind), records[i].at("type").get<std::string>());
    if (records[i].contains("t")) {
      ASSERT_EQ(film.columns.at("record.t")[i], millionths_of(records[i].at("t")));
    }
  }
  for (const char* name : {"try.command", "try.reason", "set.var", "set.value", "enter.kind",
                           "exit.kind", "which.label", "work.what", "work.crew", "pause.why",
                           "pause.for", "end.status", "end.message"}) {
    const std::string column = name;
    const std::size_t dot = column.find('.');
    EXPECT_EQ(film.texts(column),
              members(records, column.substr(0, dot).c_str(), column.substr(dot + 1).c_str()))
        << column;
  }
  for (const char* type : {"try", "enter", "exit", "which"}) {
    EXPECT_EQ(film.places(std::string(type) + ".place"), places_of(records, type));
  }
  EXPECT_EQ(as_truth(film.columns.at("try.ok")), members(records, "try", "ok"));
  EXPECT_EQ(as_truth(film.columns.at("exit.reached")), members(records, "exit", "reached"));
  EXPECT_EQ(as_truth(film.columns.at("end.reached")), members(records, "end", "reached"));
  EXPECT_EQ(as_text(film.columns.at("end.tries")), members(records, "end", "tries"));
  EXPECT_EQ(as_text(film.columns.at("end.accepted")), members(records, "end", "accepted"));
  EXPECT_EQ(as_text(film.columns.at("goal.k")), members(records, "goal", "k"));
  EXPECT_EQ(as_text(film.columns.at("exit.successes")), members(records, "exit", "successes"));
}

void expect_loads(const DecodedFilm& film, const ordered_json& header,
                  const std::vector<ordered_json>& records) {
  for (const std::string type : {"attach", "detach"}) {
    std::size_t n = 0;
    const auto& poses = film.columns.at(type + ".pose");
    const double scale = film.head.at("columns").at(type + ".pose").at("scale");
    for (const ordered_json& record : records) {
      if (record.at("type") != type) continue;
      const auto component = static_cast<std::size_t>(film.columns.at(type + ".component").at(n));
      EXPECT_EQ(header.at("components").at(component).at("name"), record.at("component"));
      std::array<double, 7> p{};
      for (std::size_t i = 0; i < 7; ++i) p[i] = scale * static_cast<double>(poses.at(7 * n + i));
      const auto& pose = record.at("pose");
      const double x = p[3], y = p[4], z = p[5], w = p[6];
      const std::array<double, 12> rows = {
          1 - 2 * (y * y + z * z), 2 * (x * y - z * w),     2 * (x * z + y * w),     p[0],
          2 * (x * y + z * w),     1 - 2 * (x * x + z * z), 2 * (y * z - x * w),     p[1],
          2 * (x * z - y * w),     2 * (y * z + x * w),     1 - 2 * (x * x + y * y), p[2]};
      for (std::size_t i = 0; i < 12; ++i) {
        EXPECT_NEAR(rows[i], pose.at(i).get<double>(), 1e-8);
      }
      ++n;
    }
    EXPECT_EQ(poses.size(), 7 * n);
  }
}

class FilmOfRuns : public testing::TestWithParam<const char*> {};

TEST_P(FilmOfRuns, TellsWhatTheTraceTells) {
  for (const auto detail : {trace::TraceDetail::steps, trace::TraceDetail::tasks}) {
    Ran ran(GetParam(), detail);
    const DecodedFilm film = test::decode_film(ran.finish().bytes);
    const ordered_json header = ordered_json::parse(ran.lines.front());
    std::vector<ordered_json> records;
    for (std::size_t i = 1; i < ran.lines.size(); ++i) {
      records.push_back(ordered_json::parse(ran.lines[i]));
    }
    ASSERT_NO_FATAL_FAILURE(expect_records(film, records));
    ASSERT_NO_FATAL_FAILURE(expect_motion(film, header, records));
    expect_loads(film, header, records);
    ordered_json shown = header;
    for (ordered_json& mesh : shown.at("meshes")) mesh.clear();
    ordered_json kept = film.head.at("header");
    for (ordered_json& mesh : kept.at("meshes")) mesh.clear();
    EXPECT_EQ(kept.dump(), shown.dump());
    EXPECT_TRUE(film.head.at("schedule").is_null());
  }
}

// Loads and crews; several machines and parking; a turn past half a turn; short plans; refusals.
INSTANTIATE_TEST_SUITE_P(Plans, FilmOfRuns,
                         testing::Values("taskplans/unit.plan", "taskplans/crane_and_trucks.plan",
                                         "taskplans/three_tow_motors.plan",
                                         "taskplans/people_below.plan",
                                         "tests/language/21_cyclic_rotation/site.plan",
                                         "tests/language/40_counted_turns/site.plan",
                                         "tests/language/41_geared_turns/site.plan",
                                         "tests/language/26_via_path/site.plan",
                                         "tests/language/31_together/site.plan",
                                         "tests/language/34_run_time_error/site.plan",
                                         "tests/language/23_which_labels/site.plan",
                                         "examples/08_what_cannot_be_done/site.plan"));

TEST(FilmOfRuns, LeavesOutWhatLiesOnALine) {
  Ran ran("taskplans/unit.plan", trace::TraceDetail::steps);
  const DecodedFilm film = test::decode_film(ran.finish().bytes);
  const auto& ok = film.columns.at("try.ok");
  const auto accepted = std::count(ok.begin(), ok.end(), 1);
  // Steps of a ramp lie on no line, and a stop is a key of its own.
  EXPECT_LT(3 * static_cast<std::ptrdiff_t>(film.columns.at("key.t").size()), 2 * accepted);
}

TEST(FilmOfRuns, TheSameBytesTwice) {
  Ran once("taskplans/people_below.plan", trace::TraceDetail::steps);
  Ran again("taskplans/people_below.plan", trace::TraceDetail::steps);
  EXPECT_EQ(once.finish().bytes, again.finish().bytes);
}

TEST(FilmOfRuns, OnlyTheSite) {
  Ran ran("taskplans/unit.plan", trace::TraceDetail::none);
  const DecodedFilm film = test::decode_film(ran.finish().bytes);
  EXPECT_TRUE(film.columns.at("record.kind").empty());
  EXPECT_TRUE(film.head.at("runs").empty());
  EXPECT_EQ(film.track(0).t, std::vector<std::int64_t>{0});
  EXPECT_EQ(film.head.at("end"), 0);
}

}  // namespace
}  // namespace rubicon::film
