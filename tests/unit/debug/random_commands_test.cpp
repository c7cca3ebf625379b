// Commands by chance, sensible and not: no crash, no state that a walk would not reach.

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "tests/support/random_cases.hpp"
#include "tests/unit/debug/shipped_traces.hpp"

namespace rubicon::test {

namespace {

const std::vector<std::string> kWords = {"step",
                                         "back",
                                         "next",
                                         "out",
                                         "record",
                                         "continue",
                                         "reverse",
                                         "run",
                                         "until",
                                         "break",
                                         "breaks",
                                         "delete",
                                         "print",
                                         "where",
                                         "config",
                                         "list",
                                         "tasks",
                                         "task",
                                         "info",
                                         "help",
                                         "s",
                                         "k",
                                         "n",
                                         "o",
                                         "r",
                                         "c",
                                         "v",
                                         "g",
                                         "u",
                                         "b",
                                         "d",
                                         "p",
                                         "w",
                                         "x",
                                         "l",
                                         "t",
                                         "i",
                                         "h",
                                         "",
                                         ";",
                                         "\"",
                                         "to",
                                         "pair",
                                         "hit",
                                         "refused",
                                         "low.jib",
                                         "high.hook",
                                         "jib.theta",
                                         "height",
                                         "set_wall_4",
                                         "park high",
                                         "21",
                                         "lift_over_and_wait.motion:21",
                                         ":",
                                         "lift:",
                                         "1",
                                         "2",
                                         "100",
                                         "-1",
                                         "99999999999999999999",
                                         "1e308",
                                         "0:01:00",
                                         "nan",
                                         "var(",
                                         "var(height)",
                                         "\xff\x1b[2J",
                                         "9223372036854775807",
                                         "-9223372036854775808"};

/// Words in any order.
std::string rubbish(std::mt19937& random) {
  std::string line;
  for (std::size_t words = 1 + random() % 4; words > 0; --words) {
    line += kWords[random() % kWords.size()] + " ";
  }
  return line;
}

/// A command that goes somewhere.
std::string going(std::mt19937& random) {
  const std::string number = std::to_string(1 + random() % 300);
  const std::vector<std::string> lines = {"step " + number,
                                          "back " + number,
                                          "record " + number,
                                          "record -" + number,
                                          "run to " + number,
                                          "until " + number,
                                          "task " + std::to_string(random() % 20),
                                          "step",
                                          "back",
                                          "next",
                                          "out",
                                          "continue",
                                          "reverse",
                                          ""};
  return lines[random() % lines.size()];
}

TEST(RandomCommands, DoNoHarm) {
  debug::Session session = session_of(trace_of("taskplans/two_cranes.plan"));
  std::mt19937 random(5);
  std::set<std::pair<std::string, std::size_t>> places;
  for (int i = 0; i < cases(10'000); ++i) {
    const std::string line = random() % 2 == 0 ? going(random) : rubbish(random);
    const std::string said = session.execute(line);
    EXPECT_LT(said.size(), 20'000u) << line;
    const debug::TaskState& state = session.state();
    places.emplace(session.recording().texts[session.run().name()], state.position);
    ASSERT_LE(state.position, session.run().size()) << line;
    ASSERT_EQ(state, session.run().state_at(state.position)) << line;
  }
  EXPECT_GT(places.size(), static_cast<std::size_t>(cases(1000)));
}

TEST(RandomCommands, SmokeOfRandomBytes) {
  debug::Session session = session_of(trace_of("examples/03_round_the_block/site.plan"));
  std::mt19937 random(6);
  for (int i = 0; i < cases(10'000) && !session.ended(); ++i) {
    std::string line;
    for (std::size_t bytes = random() % 30; bytes > 0; --bytes) {
      line += static_cast<char>(random() % 256);
    }
    session.execute(line);
  }
}

}  // namespace

}  // namespace rubicon::test
