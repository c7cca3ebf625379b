// Traces that somebody damaged or made up: refused with a message, or shown without harm.

#include <gtest/gtest.h>

#include <functional>
#include <random>
#include <stdexcept>

#include "src/results/debug/clean_text.hpp"
#include "src/results/debug/recording_reader.hpp"
#include "tests/support/growth.hpp"
#include "tests/support/random_cases.hpp"
#include "tests/unit/debug/hand_trace.hpp"
#include "tests/unit/debug/shipped_traces.hpp"

namespace rubicon::test {

namespace {

std::string refusal(const std::vector<std::string>& lines) {
  try {
    recording_of(lines);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return {};
}

bool is_safe(const std::string& text) {
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte < 0x20 && c != '\n') || byte == 0x7f) return false;
  }
  return text.find("\xc2\x9b") == std::string::npos &&
         text.find("\xe2\x80\xae") == std::string::npos;
}

TEST(HostileTrace, WhatIsNoTraceIsRefused) {
  for (const char* line : {"", "x", "[]", "7", "\"type\"", "{}", "null", "{\"type\":7}", "[[[[",
                           "{\"type\":\"header\"}", "{\"type\":\"header\",\"format\":\"other\"}",
                           "{\"type\":\"header\",\"format\":\"rubicon-trace\"}", "\xff\xfe",
                           "{\"type\":\"try\",\"task\":\"p\"}"}) {
    EXPECT_FALSE(refusal({line}).empty()) << line;
  }
  const std::string deep(100'000, '[');
  EXPECT_FALSE(refusal({deep}).empty());
  EXPECT_FALSE(refusal({hand_header(), "{\"type\":\"try\",\"q\":" + deep}).empty());
}

TEST(HostileTrace, ARecordThatMakesNoSenseIsRefused) {
  EXPECT_EQ(refusal({hand_header(), hand_header()}), "this is no line of a trace: a second header");
  EXPECT_EQ(refusal({hand_header(), hand_record("dance", "")}),
            "this is no line of a trace: there is no type 'dance'; a later rubicon may know it");
  EXPECT_EQ(
      refusal({hand_header(), hand_record("goal", "\"k\":-1,\"n\":1")}),
      "this is no line of a trace: 'k' should be a whole number from 0 to 2147483647, found -1");
  EXPECT_EQ(refusal({hand_header(), hand_record("goal", "\"k\":\"a\",\"n\":1")}),
            "this is no line of a trace: 'k' should be a whole number, found \"a\"");
  EXPECT_EQ(refusal({hand_header(), hand_loop("exit", ",\"reached\":true,\"successes\":0")}),
            "this is no line of a trace: no such loop runs");
  EXPECT_EQ(
      refusal({hand_header(), hand_try(1, "x", 1, true, 1, 1, 1),
               hand_record("try", R"("n":2,"command":"move_to","parameter":"z","file":"s.motion",)"
                                  R"("line":1,"column":1,"ok":true,)"
                                  R"("reason":"","t":2,"q":{"z":1})")}),
      "this is no line of a trace: its 'q' is of another robot than before");
  EXPECT_FALSE(refusal({hand_header(), hand_record("wait", "\"n\":1e999,\"t\":0")}).empty());
  EXPECT_FALSE(
      refusal({hand_header(), hand_record("try", R"("n":1,"command":"move_to",)"
                                                 R"("parameter":"x","file":"s.motion","line":1,)"
                                                 R"("column":1,"ok":false,"reason":"hit",)"
                                                 R"("hit":["a"],"t":2,"q":{"x":1})")})
          .empty());
}

/// Every line of a real trace, with a byte changed, cut or doubled: read or refused, no harm.
TEST(HostileTrace, DamagedLinesDoNoHarm) {
  const auto& lines = trace_of("examples/09_two_machines/site.plan");
  std::mt19937 random(20260504);
  int refused = 0;
  for (int i = 0; i < cases(3000); ++i) {
    std::vector<std::string> damaged = lines;
    std::string& line = damaged[random() % damaged.size()];
    const std::size_t at = random() % line.size();
    switch (random() % 3) {
      case 0:
        line[at] = static_cast<char>(random() % 256);
        break;
      case 1:
        line.erase(at, 1 + random() % 20);
        break;
      default:
        line.insert(at, line.substr(at, 1 + random() % 20));
    }
    debug::RecordingReader reader;
    try {
      for (const std::string& each : damaged) reader.line(each);
    } catch (const std::invalid_argument&) {
      ++refused;
      continue;
    }
    debug::Recording recording = reader.take();
    if (!debug::Session::why_not(recording, "").empty()) continue;
    debug::Session session(std::move(recording), "", {});
    for (const char* command : {"c", "x", "w", "p", "l", "i", "v", "s 30", "i", "tasks"}) {
      EXPECT_TRUE(is_safe(session.execute(command)));
    }
  }
  EXPECT_GT(refused, cases(1000));
}

TEST(HostileTrace, ControlCharactersAreNeverPrinted) {
  std::vector<std::string> lines = {
      hand_header(),
      hand_record("goal", R"("k":1,"n":1)"),
      hand_record("set", R"("var":"a\u001b[31m","value":1)"),
      hand_record(
          "which",
          R"("label":"b\u0007\u009b","file":"\u001b]0;x\u0007.motion","line":1,"column":1)"),
      hand_record(
          "try",
          R"("n":1,"command":"move\n_to","parameter":"x\u001b","file":"s.motion","line":2,)"
          R"("column":3,"ok":false,"reason":"hit","hit":["\u202ea","b\r"],"t":1,"q":{"x\u001b":1})"),
      hand_end(R"("status":"\u001b","reached":false,"message":"\u001b[2J","tries":1,"accepted":0,)"
               R"("q":{"x\u001b":1},"t":1)")};
  debug::Session session = session_of(lines);
  for (const char* command :
       {"break hit", "record", "record", "record", "record", "where", "config", "print",
        "print \x1b[31m", "list", "info", "tasks", "breaks", "\x1b[2J", "step", "task \x9b",
        "break pair \xe2\x80\xae", "break \x1b:3"}) {
    const std::string said = session.execute(command);
    EXPECT_TRUE(is_safe(said)) << command << said;
  }
}

/// Very many different things of a kind are read in time that grows with the trace, or refused.
TEST(HostileTrace, VeryManyThingsCostNoMoreThanTheirLines) {
  using Line = std::function<std::string(int)>;
  const std::string place = R"("file":"s.motion","column":1,"line":)";
  const std::vector<Line> kinds = {
      [&](int i) { return hand_record("enter", R"("kind":"chain",)" + place + std::to_string(i)); },
      [](int i) { return hand_record("set", fmt::format(R"("var":"v{}","value":1)", i)); },
      [](int i) {
        return hand_record("which",
                           fmt::format(R"("label":"l{0}","file":"{0}","line":1,"column":1)", i));
      },
      [](int i) {
        return fmt::format(R"({{"type":"goal","task":"t{}","robot":"r","k":1,"n":1}})", i);
      },
      [&](int i) {
        const std::string more = R"("kind":"chain",)" + place + std::to_string(i / 2);
        return i % 2 == 0 ? hand_record("enter", more)
                          : hand_record("exit", more + R"(,"reached":true,"successes":0)");
      }};
  for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
    const auto read = [&](int count) {
      std::vector<std::string> lines = {hand_header()};
      for (int i = 0; i < count; ++i) lines.push_back(kinds[kind](i));
      if (refusal(lines).empty()) {
        debug::Session session = session_of(lines);
        for (const char* command :
             {"continue", "where", "print", "tasks", "list", "back", "reverse"}) {
          EXPECT_LT(session.execute(command).size(), 400'000u);
        }
      }
    };
    // 20 is linear, 400 quadratic.
    EXPECT_TRUE(grows_at_most(
        90, [&] { read(cases(3000)); }, [&] { read(cases(60'000)); }))
        << kind;
  }
}

TEST(HostileTrace, LongNamesAreCut) {
  const std::string name(100'000, 'n');
  std::vector<std::string> lines = {hand_header(), hand_record("goal", R"("k":1,"n":1)"),
                                    hand_record("set", "\"var\":\"" + name + "\",\"value\":1")};
  debug::Session session = session_of(lines);
  EXPECT_LT(session.execute("step").size(), 1000u);
  EXPECT_LT(session.execute("print").size(), 1000u);
  EXPECT_LT(session.execute(name).size(), 1000u);
  EXPECT_LT(session.execute(name.substr(0, 4000)).size(), 1000u);
}

TEST(HostileTrace, ALoopThatTellsAConfigurationEndsAllTheSame) {
  debug::Session session(
      recording_of({hand_header(), hand_loop("enter", R"(,"t":0,"q":{"x":1,"y":2})"),
                    hand_try(1, "x", 2, true, 1, 1, 0),
                    hand_loop("exit", R"(,"t":1,"reached":true,"successes":1)"),
                    hand_record("set", R"("var":"v","value":1e300)")}),
      "", {});
  session.execute("step");
  EXPECT_EQ(session.execute("where"),
            "#0  chain at s.motion:1: round 1, 1 tried, 1 accepted; ends reached after try 1, 1 "
            "success\n");
}

TEST(HostileTrace, CleanTextKeepsLetters) {
  EXPECT_EQ(debug::clean_text("Wand \xc3\xa4\xe2\x82\xac\xf0\x9f\x8f\x97 1"),
            "Wand \xc3\xa4\xe2\x82\xac\xf0\x9f\x8f\x97 1");
  EXPECT_EQ(debug::clean_text("a\tb\x1b\x7f\xc2\x9b\xff\xc3"), "a b?????");
  EXPECT_EQ(debug::clean_text("\xc3\xa4\xc3\xa4", 3), "\xc3\xa4...");
  // An overlong form and a surrogate are no characters: a terminal may make of them what it likes.
  EXPECT_EQ(debug::clean_text("\xe0\x80\x9b|\xed\xa0\x80"), "???|???");
}

}  // namespace

}  // namespace rubicon::test
