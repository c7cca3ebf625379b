#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>

#include "src/exchange/project_io/write_mspdi.hpp"
#include "tests/support/growth.hpp"
#include "tests/unit/project_io/project_support.hpp"
#include "tests/unit/project_io/sample_files_io.hpp"

namespace rubicon::test {
namespace {

using namespace project_io;

/// Whatever is read must be well: its plan passes the check, both ways back give it again.
void expect_no_harm(const std::string& bytes) {
  const Reading reading = read_schedule(bytes);
  if (!reading.project) {
    EXPECT_FALSE(reading.said.empty());
    return;
  }
  const Planned planned = plan_of(*reading.project);
  ASSERT_EQ(planned.mistakes, "") << planned.text;
  const Reading back = project_of_plan(planned.text);
  ASSERT_TRUE(back.project);
  EXPECT_TRUE(*back.project == *reading.project) << planned.text;
  const Reading again = read_schedule(write_mspdi(*reading.project));
  ASSERT_TRUE(again.project);
  EXPECT_TRUE(*again.project == *reading.project);
}

TEST(HostileSchedule, cut_off_anywhere) {
  for (const char* name : {"house.xml", "hall.xer"}) {
    const std::string text = sample(name);
    for (std::size_t end = 0; end < text.size(); end += 97) {
      SCOPED_TRACE(fmt::format("{} cut at {}", name, end));
      expect_no_harm(text.substr(0, end));
      if (testing::Test::HasFailure()) return;
    }
  }
}

TEST(HostileSchedule, garbled_anywhere) {
  std::mt19937 random(7);
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random()) % n; };
  for (const char* name : {"house.xml", "hall.xer"}) {
    const std::string text = sample(name);
    for (int round = 0; round < 300; ++round) {
      std::string bytes = text;
      for (std::size_t change = 1 + below(8); change > 0; --change) {
        const std::size_t at = below(bytes.size());
        switch (below(4)) {
          case 0:
            bytes[at] = static_cast<char>(below(256));
            break;
          case 1:
            bytes[at] = static_cast<char>('0' + below(10));
            break;
          case 2:
            bytes.erase(at, below(40));
            break;
          default:
            bytes.insert(at, bytes.substr(below(bytes.size()), below(200)));
        }
      }
      SCOPED_TRACE(fmt::format("{} round {}", name, round));
      expect_no_harm(bytes);
      if (testing::Test::HasFailure()) return;
    }
  }
}

TEST(HostileSchedule, numbers_out_of_place) {
  // Each number of the file replaced by ones that break arithmetic.
  const std::string text = sample("house.xml");
  int round = 0;
  for (std::size_t at = text.find('>'); at != std::string::npos; at = text.find('>', at + 1)) {
    std::size_t end = at + 1;
    if (end < text.size() && text[end] == '-') ++end;
    while (end < text.size() && text[end] >= '0' && text[end] <= '9') ++end;
    if (end == at + 1 || text[end] != '<') continue;
    const std::string number =
        std::vector<std::string>{"-1",
                                 "9223372036854775807",
                                 "4503599627370496",
                                 "1e308",
                                 "-0",
                                 "999999999"}[static_cast<std::size_t>(round++ % 6)];
    SCOPED_TRACE(text.substr(at > 30 ? at - 30 : 0, 60) + " " + number);
    expect_no_harm(text.substr(0, at + 1) + number + text.substr(end));
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(round, 100);
}

TEST(HostileSchedule, deep_and_expanding_xml) {
  std::string deep;
  for (int i = 0; i < 300000; ++i) deep += "<a>";
  expect_no_harm("<Project>" + deep);
  for (int i = 0; i < 300000; ++i) deep += "</a>";
  expect_no_harm("<Project>" + deep + "</Project>");
  std::string laughs = "<!DOCTYPE Project [<!ENTITY a \"ha\">";
  for (char c = 'b'; c < 'p'; ++c) {
    const char before = static_cast<char>(c - 1);
    laughs += fmt::format("<!ENTITY {} \"&{};&{};&{};&{};\">", c, before, before, before, before);
  }
  const Reading reading = read_schedule(laughs + "]><Project><Name>&o;</Name></Project>");
  ASSERT_TRUE(reading.project);
  EXPECT_EQ(reading.project->name, "&o;");
}

TEST(HostileSchedule, outlines_and_names_without_bounds) {
  std::string tasks;
  for (int i = 1; i < 3000; ++i) {
    tasks += mspdi_task(i, i % 2 == 0 ? "same" : std::string(500, 'x'),
                        fmt::format("<OutlineLevel>{}</OutlineLevel>", i));
  }
  expect_no_harm(mspdi("<Tasks>" + tasks + "</Tasks>"));
}

TEST(HostileSchedule, more_kinds_of_nonsense_than_anybody_reads) {
  std::string elements;
  for (int i = 0; i < 100000; ++i) elements += fmt::format("<E{}>1</E{}>", i, i);
  const Reading reading = read_schedule(mspdi(elements));
  ASSERT_TRUE(reading.project);
  EXPECT_EQ(reading.said.size(), 301u);
  EXPECT_TRUE(reading.says("I07", "99700 more things were not understood"));
}

TEST(HostileSchedule, calendars_without_bounds) {
  std::string calendars;
  for (int i = 1; i <= 12000; ++i) {
    calendars += fmt::format(
        "<Calendar><UID>{}</UID><BaseCalendarUID>{}</BaseCalendarUID></Calendar>", i, i - 1);
  }
  std::string days;
  for (int i = 0; i < 20000; ++i) {
    days += fmt::format(
        "<Exception><TimePeriod><FromDate>0001-01-01</FromDate><ToDate>{:04}-12-31</ToDate>"
        "</TimePeriod><DayWorking>0</DayWorking></Exception>",
        1 + i % 9998);
  }
  const std::string text = mspdi("<Calendars>" + calendars + "<Calendar><UID>0</UID><Exceptions>" +
                                 days + "</Exceptions></Calendar></Calendars>");
  const Reading reading = read_schedule(text);
  ASSERT_TRUE(reading.project);
  EXPECT_TRUE(reading.says("I07", "12001 calendars are too many"));
  expect_no_harm(text);
}

/// A chain of tasks with a heading every hundred.
std::string large(int count) {
  std::string tasks;
  for (int i = 1; i <= count; ++i) {
    std::string elements = i % 100 == 1
                               ? "<OutlineLevel>1</OutlineLevel>"
                               : "<OutlineLevel>2</OutlineLevel><Duration>PT8H0M0S</Duration>";
    if (i % 100 > 2) {
      elements += fmt::format(
          "<PredecessorLink><PredecessorUID>{}</PredecessorUID><Type>1</Type></PredecessorLink>",
          i - 1);
    }
    if (i % 100 == 1 && i > 1) {
      elements += fmt::format(
          "<PredecessorLink><PredecessorUID>{}</PredecessorUID><Type>1</Type></PredecessorLink>",
          i - 100);
    }
    tasks += mspdi_task(i, "Task", elements);
  }
  return mspdi("<Tasks>" + tasks + "</Tasks>");
}

TEST(HostileSchedule, a_hundred_thousand_tasks_take_seconds_and_grow_in_line) {
  const std::string small = large(6250), big = large(100000);
  const auto work = [](const std::string& text) {
    const Reading reading = read_schedule(text);
    ASSERT_TRUE(reading.project);
    const Planned planned = plan_of(*reading.project);
    EXPECT_EQ(planned.mistakes, "");
  };
  // 16 is linear, 256 quadratic.
  EXPECT_TRUE(grows_at_most(
      64, [&] { work(small); }, [&] { work(big); }));
}

}  // namespace
}  // namespace rubicon::test
