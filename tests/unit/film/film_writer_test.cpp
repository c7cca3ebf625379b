#include "src/results/film/film_writer.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "src/exchange/encoding/gzip.hpp"
#include "src/results/film/column.hpp"
#include "tests/support/header_json.hpp"
#include "tests/unit/film/film_decoder.hpp"

namespace rubicon::film {
namespace {

using nlohmann::ordered_json;
using test::DecodedFilm;
using testing::HasSubstr;

/// One robot with x and a cyclic theta, one component, one mesh.
ordered_json header(const std::string& plan = "site") {
  return test::whole_header(
      ordered_json::parse(R"({"type":"header","format":"rubicon-trace","version":1,"plan":")" +
                          plan + R"(","form":"full","start_at":null,
    "robots":[{"name":"crane","start":{"x":1.5,"theta":170},"parameters":[
        {"name":"x","cyclic":false,"start":0},{"name":"theta","cyclic":true,"start":0}]}],
    "components":[{"name":"panel"}],
    "meshes":[{"closed":true,"vertices":[0,0,0,1.25,0,0,0,1,-2],"triangles":[0,1,2]}]})"));
}

std::string step(double t, double x, double theta, bool ok = true) {
  return fmt::format(
      R"({{"type":"try","task":"a","robot":"crane","n":1,"command":"move_to","parameter":"x","file":"f.motion","line":3,"column":1,"ok":{},"reason":"{}","t":{},"q":{{"x":{},"theta":{}}}}})",
      ok, ok ? "" : "limit x", t, x, theta);
}

constexpr const char* kStart =
    R"({"type":"task_start","task":"a","robot":"crane","t":2,"because":"at once","after":""})";
constexpr const char* kDone =
    R"({"type":"task_end","task":"a","robot":"crane","t":9,"result":"done","reason":""})";
constexpr const char* kRejected =
    R"({"type":"task_end","task":"a","robot":"crane","t":2,"result":"rejected","reason":"no"})";

DecodedFilm film_of(const ordered_json& head, const std::vector<std::string>& lines,
                    const std::string& schedule = "") {
  FilmWriter writer;
  writer.line(head.dump());
  for (const std::string& line : lines) writer.line(line);
  return test::decode_film(writer.finish(schedule).bytes);
}

TEST(FilmWriter, TurnsAreUnrolled) {
  const DecodedFilm film =
      film_of(header(),
              {kStart, step(3, 1.5, 175), step(4, 1.5, -175), step(5, 1.5, 175), step(6, 1.5, -90),
               step(7, 1.5, 20), step(8, 1.5, 130), step(9, 1.5, -130), kDone});
  const test::DecodedTrack track = film.track(0);
  EXPECT_EQ(track.at(1, 4'000'000), std::vector<double>{185e6});
  EXPECT_EQ(track.at(1, 5'000'000), std::vector<double>{175e6});
  EXPECT_EQ(track.at(1, 9'000'000), std::vector<double>{590e6});
  EXPECT_EQ(track.q[0], std::vector<std::int64_t>(track.t.size(), 1'500'000));
}

TEST(FilmWriter, WaitsWorkAndPausesStandStill) {
  const DecodedFilm film = film_of(
      header(),
      {kStart, R"({"type":"wait","task":"a","robot":"crane","n":1,"t":3})", step(4, 2, 170),
       R"({"type":"work","task":"a","robot":"crane","what":"hook","crew":"","from":4,"t":5,"time":1})",
       step(6, 3, 170),
       R"({"type":"pause","task":"a","robot":"crane","why":"crew","for":"c","from":6,"t":7})",
       step(8, 4, 170), kDone});
  EXPECT_EQ(film.track(0).t,
            (std::vector<std::int64_t>{0, 2'000'000, 3'000'000, 4'000'000, 5'000'000, 6'000'000,
                                       7'000'000, 8'000'000}));
  EXPECT_EQ(film.track(0).q[0],
            (std::vector<std::int64_t>{1'500'000, 1'500'000, 1'500'000, 2'000'000, 2'000'000,
                                       3'000'000, 3'000'000, 4'000'000}));
}

TEST(FilmWriter, ARejectedTaskHasATrackOfItsOwn) {
  const DecodedFilm film = film_of(header(), {kStart, step(3, 5, 170), step(4, 9, 170, false),
                                              kRejected, kStart, step(8, 3, 170), kDone});
  EXPECT_EQ(film.track(0, 0).t, (std::vector<std::int64_t>{2'000'000, 3'000'000}));
  EXPECT_EQ(film.track(0, 0).q[0], (std::vector<std::int64_t>{1'500'000, 5'000'000}));
  // It is as if it had not been: the robot stands where it stood.
  EXPECT_EQ(film.track(0).q[0], (std::vector<std::int64_t>{1'500'000, 1'500'000, 3'000'000}));
  const auto& runs = film.head.at("runs");
  ASSERT_EQ(runs.size(), 2u);
  EXPECT_EQ(runs.at(0).dump(),
            R"({"task":"a","robot":0,"start":2,"end":3,"result":"rejected","reason":"no",)"
            R"("because":"at once","after":"","happened":false})");
  EXPECT_EQ(runs.at(1).at("happened"), true);
  EXPECT_EQ(film.head.at("end"), 9);
}

TEST(FilmWriter, WhatIsNotReachedHasARunAndNoTrack) {
  const DecodedFilm film = film_of(
      header(),
      {R"({"type":"task_end","task":"b","robot":"crane","t":4,"result":"not reached","reason":"after a"})"});
  EXPECT_EQ(film.head.at("runs").size(), 1u);
  EXPECT_EQ(film.head.at("tracks").size(), 1u);
  EXPECT_EQ(film.head.at("end"), 0);
}

TEST(FilmWriter, MeshesAreColumns) {
  const DecodedFilm film = film_of(header(), {});
  EXPECT_EQ(film.head.at("header").at("meshes").dump(),
            R"([{"closed":true,"vertices":"mesh.0.vertices","triangles":"mesh.0.triangles"}])");
  EXPECT_EQ(film.columns.at("mesh.0.vertices"),
            (std::vector<std::int64_t>{0, 0, 0, 1'250'000, 0, 0, 0, 1'000'000, -2'000'000}));
  EXPECT_EQ(film.columns.at("mesh.0.triangles"), (std::vector<std::int64_t>{0, 1, 2}));
}

TEST(FilmWriter, TextsSurvive) {
  const std::string long_name(10'000, 'x');
  for (const std::string& name :
       {std::string("a \"b\" \\ c"), std::string("crane \U0001F3D7 \u00e9"),
        std::string("</script><!-- ]]>"), long_name, std::string("tab\tline\nnul\x01")}) {
    ordered_json head = header();
    head["plan"] = name;
    head["components"][0]["name"] = name;
    ordered_json start = ordered_json::parse(kStart);
    start["task"] = start["because"] = name;
    ordered_json work = {{"type", "work"}, {"task", name}, {"robot", "crane"}, {"what", "hook"},
                         {"crew", name},   {"from", 2},    {"t", 3},           {"time", 1}};
    ordered_json set = {
        {"type", "set"}, {"task", name}, {"robot", "crane"}, {"var", name}, {"value", nullptr}};
    const DecodedFilm film = film_of(head, {start.dump(), work.dump(), set.dump()});
    EXPECT_EQ(film.head.at("header").at("plan"), name);
    EXPECT_EQ(film.head.at("header").at("components").at(0).at("name"), name);
    EXPECT_EQ(film.head.at("runs").at(0).at("task"), name);
    EXPECT_EQ(film.head.at("runs").at(0).at("because"), name);
    EXPECT_EQ(film.texts("work.crew"), std::vector<std::string>{name});
    EXPECT_EQ(film.texts("set.var"), std::vector<std::string>{name});
    EXPECT_EQ(film.texts("set.value"), std::vector<std::string>{"null"});
  }
}

TEST(FilmWriter, PosesFarAwayAreCoarser) {
  const auto attach = [](double x) {
    return fmt::format(
        R"({{"type":"attach","task":"a","robot":"crane","component":"panel","pose":[0,-1,0,{},1,0,0,2,0,0,1,3],"t":2}})",
        x);
  };
  const DecodedFilm near = film_of(header(), {kStart, attach(1.5)});
  EXPECT_EQ(near.head.at("columns").at("attach.pose").at("scale"), 1e-9);
  EXPECT_EQ(near.columns.at("attach.pose"),
            (std::vector<std::int64_t>{1'500'000'000, 2'000'000'000, 3'000'000'000, 0, 0,
                                       707'106'781, 707'106'781}));
  const DecodedFilm far = film_of(header(), {kStart, attach(5.8e6)});
  EXPECT_EQ(far.head.at("columns").at("attach.pose").at("scale"), 1e-6);
  EXPECT_EQ(far.columns.at("attach.pose").front(), 5'800'000'000'000);
}

TEST(FilmWriter, CarriesTheSchedule) {
  const DecodedFilm film = film_of(header(), {}, "{ \"tasks\": [1, 2.5, \"\\u00e9\"] }\n");
  EXPECT_EQ(film.head.at("schedule").dump(), "{\"tasks\":[1,2.5,\"\u00e9\"]}");
  EXPECT_THROW(film_of(header(), {}, "{ \"tasks\": "), std::invalid_argument);
}

TEST(FilmWriter, RestartForgetsAll) {
  FilmWriter writer;
  writer.line(header("first").dump());
  writer.line(kStart);
  writer.restart();
  EXPECT_FALSE(writer.has_header());
  writer.line(header("second").dump());
  const Film film = writer.finish("");
  EXPECT_EQ(film.plan, "second");
  EXPECT_EQ(film.bytes, [] {
    FilmWriter fresh;
    fresh.line(header("second").dump());
    return fresh.finish("").bytes;
  }());
}

TEST(FilmWriter, TimesGoAsFarAsPlansDo) {
  const DecodedFilm film = film_of(
      header(),
      {kStart, step(3'900'000'000.5, 1.5, 175),
       R"({"type":"task_end","task":"a","robot":"crane","t":3950000000,"result":"done","reason":""})"});
  EXPECT_EQ(film.columns.at("record.t"),
            (std::vector<std::int64_t>{2'000'000, 3'900'000'000'500'000, 3'950'000'000'000'000}));
  EXPECT_THAT(film.track(0).t, testing::Contains(3'900'000'000'500'000));
  EXPECT_THROW(time_millionths(4.1e9), std::invalid_argument);
  EXPECT_THROW(time_millionths(-1), std::invalid_argument);
}

/// What a line is answered with; "" if it is taken.
std::string answer(FilmWriter& writer, const std::string& line) {
  try {
    writer.line(line);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(FilmWriter, DamagedLinesAreErrors) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"", "no line of a trace"},
      {"nonsense", "no line of a trace"},
      {"[1, 2]", "should be an object"},
      {"{}", "it has no 'type'"},
      {R"({"type":"dance","task":"a","robot":"crane"})", "no type 'dance'"},
      {step(3, 1, 1).substr(0, 60), "no line of a trace"},
      {R"({"type":"goal","task":"b","robot":"crane","k":1,"n":1})", "task 'b' has not begun"},
      {R"({"type":"goal","task":"a","robot":"crane","k":1.5,"n":1})",
       "'k' should be a whole number"},
      {R"({"type":"goal","task":"a","robot":"crane","k":1})", "it has no 'n'"},
      {R"({"type":"goal","task":7,"robot":"crane","k":1,"n":1})", "'task' should be a text"},
      {kStart, "task 'a' begins twice"},
      {R"({"type":"task_start","task":"b","robot":"digger","t":1})", "no robot 'digger'"},
      {R"({"type":"remove","task":"a","robot":"crane","component":"roof","t":3})",
       "no component 'roof'"},
      {R"({"type":"wait","task":"a","robot":"crane","n":1,"t":1e300})", "'t' should be a time"},
      {R"({"type":"wait","task":"a","robot":"crane","n":1,"t":1e999})", "no line of a trace"},
      {step(1, 1, 1), "runs backwards"},
      {R"({"type":"wait","task":"a","robot":"crane","n":1,"t":1})", "runs backwards"},
      {R"({"type":"task_end","task":"a","robot":"crane","t":1,"result":"done","reason":""})",
       "runs backwards"},
      {step(3, 2e9, 1), "a film holds at most"},
      {R"({"type":"try","task":"a","robot":"crane","n":1,"command":"m","parameter":"x","file":"f","line":1,"column":1,"ok":true,"reason":"","t":3,"q":{"x":1}})",
       "it has no 'theta'"},
      {R"({"type":"attach","task":"a","robot":"crane","component":"panel","pose":[1,2],"t":3})",
       "'pose' should be a pose"},
      {R"({"type":"attach","task":"a","robot":"crane","component":"panel","pose":[0,0,0,0,0,0,0,0,0,0,0,0],"t":3})",
       "'pose' should be a pose"},
      {"{\"type\":\"goal\",\"task\":\"\xff\",\"robot\":\"crane\"}", "no line of a trace"},
      {std::string(100'000, '['), "no line of a trace"},
  };
  for (const auto& [line, message] : cases) {
    FilmWriter writer;
    writer.line(header().dump());
    writer.line(kStart);
    EXPECT_THAT(answer(writer, line), HasSubstr(message)) << line.substr(0, 100);
  }
}

TEST(FilmWriter, DamagedHeadersAreErrors) {
  const auto changed = [](const std::function<void(ordered_json&)>& change) {
    ordered_json head = header();
    change(head);
    return head.dump();
  };
  const std::string whole = header().dump();
  const std::vector<std::pair<std::string, std::string>> cases = {
      {whole.substr(0, whole.size() - 1) + R"(,"meshes":[]})", "two 'meshes'"},
      {changed([](auto& head) { head["meshes"][0]["triangles"].push_back(0); }), "three corners"},
      {changed([](auto& head) { head["meshes"][0]["vertices"].push_back(0); }), "three numbers"},
      {kStart, "this is no trace"},
      {"", "this is no trace"},
      {changed([](auto& head) { head["version"] = 2; }), "version 2"},
      {changed([](auto& head) { head.erase("robots"); }), "it has no 'robots'"},
      {changed([](auto& head) { head["robots"][0]["start"].erase("x"); }), "it has no 'x'"},
      {changed([](auto& head) { head["robots"][0]["start"]["x"] = 1e10; }), "holds at most"},
      {changed([](auto& head) { head["meshes"][0]["triangles"][0] = 3; }), "triangle at number 3"},
      {changed([](auto& head) { head["meshes"][0]["vertices"][0] = "1"; }), "expected a number"},
  };
  for (const auto& [line, message] : cases) {
    FilmWriter writer;
    EXPECT_THAT(answer(writer, line), HasSubstr(message)) << line.substr(0, 100);
    EXPECT_FALSE(writer.has_header());
  }
}

TEST(Gzip, UnpacksToTheSame) {
  std::string bytes;
  for (int i = 0; i < 300'000; ++i) bytes += static_cast<char>(std::int64_t{i} * i % 251);
  EXPECT_EQ(test::unpacked(encoding::gzip(bytes)), bytes);
  EXPECT_EQ(test::unpacked(encoding::gzip("")), "");
  // No time, and no name of a system.
  EXPECT_EQ(encoding::gzip("x").substr(0, 10), std::string("\x1f\x8b\x08\0\0\0\0\0\0\xff", 10));
}

}  // namespace
}  // namespace rubicon::film
