#include <gtest/gtest.h>

#include "tests/support/growth.hpp"
#include "tests/unit/grammar/format_oracle.hpp"
#include "tests/unit/grammar/parse_support.hpp"

/// Texts that nobody means: a bounded number of messages, in time linear in their length.
namespace rubicon {
namespace {

using grammar_test::mistakes;
using interpreter::TextKind;

constexpr TextKind kKinds[] = {TextKind::script, TextKind::robot, TextKind::plan};

std::string repeat(std::string_view text, std::size_t times) {
  std::string result;
  result.reserve(text.size() * times);
  for (std::size_t i = 0; i < times; ++i) result += text;
  return result;
}

TEST(HostileText, NeverMoreThanAHundredMistakesAndANote) {
  std::string garbage;
  std::uint32_t state = 12345;
  for (int i = 0; i < 200000; ++i) {
    state = state * 1664525u + 1013904223u;
    garbage += static_cast<char>(state >> 24);
  }
  const std::string texts[] = {garbage,
                               repeat("@", 100000),
                               repeat("{", 100000),
                               repeat("}", 100000),
                               repeat("(", 100000),
                               repeat("foo bar\n", 20000),
                               repeat("a;", 100000),
                               repeat("\"", 100000),
                               repeat("chain{", 50000),
                               repeat("\xff", 1000),
                               std::string(1000, '\0'),
                               repeat("which{a:", 50000)};
  for (const std::string& text : texts) {
    for (const TextKind kind : kKinds) {
      const std::vector<std::string> found = mistakes(text, kind);
      EXPECT_LE(found.size(), 101u);
      EXPECT_EQ(grammar_test::check_formatting(text, kind), "");
    }
    EXPECT_FALSE(mistakes(text, TextKind::plan).empty());
  }
}

TEST(HostileText, TimeGrowsWithLength) {
  const struct {
    const char* head;
    const char* body;
    TextKind kind;
  } cases[] = {
      {"", "chain {move_to(x, goal(x)), move_dir(z, dir(z, max(z)))};\n", TextKind::script},
      {"chain {", "move_to(x, goal(x)), ", TextKind::script},
      {"chain {", "move_to(x, goal(x)); ", TextKind::script},
      {"var(a) = 1", " + 1", TextKind::script},
      {"var(a) = f(1", ", 1", TextKind::script},
      {"", "# remark\n", TextKind::script},
      {"", "/* a */ ", TextKind::script},
      {"", "words and more words\n", TextKind::script},
      {"", "chain {", TextKind::script},
      {"which {", "a: ", TextKind::script},
      {"", "((((", TextKind::script},
      {"plan p {", "component c { shape box(0, 0, 0, 1, 1, 1); at trans(0, 0, 0); }\n",
       TextKind::plan},
      {"plan p { import \"a\" {", "{", TextKind::plan},
      {"robot r {", "body b { param x step(1); shape sphere(0, 0, 0, 1); }\n", TextKind::robot},
  };
  for (const auto& text : cases) {
    const std::size_t times = 50'000 / std::string_view(text.body).size();
    const std::string small = text.head + repeat(text.body, times);
    const std::string large = text.head + repeat(text.body, 16 * times);
    // 16 is linear, 256 quadratic.
    EXPECT_TRUE(test::grows_at_most(
        64, [&] { mistakes(small, text.kind); }, [&] { mistakes(large, text.kind); }))
        << text.head << text.body;
  }
}

TEST(HostileText, TenMegabytesOfGarbageTakeSeconds) {
  std::string garbage;
  std::uint32_t state = 1;
  while (garbage.size() < 10'000'000) {
    state = state * 1664525u + 1013904223u;
    garbage += " chain{}(),;:=.+-*/<>ax_1\n\"#"[(state >> 16) % 28];
  }
  for (const TextKind kind : kKinds) {
    EXPECT_LT(test::processor_seconds([&] { mistakes(garbage, kind); }), 10);
  }
}

TEST(HostileText, NestingIsBounded) {
  const int limit = interpreter::kMaxNesting;
  const auto nested = [](int depth) {
    return repeat("chain{", depth) + "wait" + repeat("}", depth) + ";";
  };
  EXPECT_TRUE(mistakes(nested(limit), TextKind::script).empty());
  const std::vector<std::string> found = mistakes(nested(limit + 1), TextKind::script);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0], "1:1207: error: nested more than 200 deep");
  EXPECT_TRUE(
      mistakes("var(a) = " + repeat("(", limit) + "1" + repeat(")", limit) + ";", TextKind::script)
          .empty());
  EXPECT_EQ(mistakes("var(a) = " + repeat("(", 100000) + "1", TextKind::script).size(), 1u);
  EXPECT_EQ(mistakes("var(a) = " + repeat("-", 100000) + "1;", TextKind::script).size(), 1u);
  EXPECT_EQ(mistakes("var(a) = " + repeat("not ", 100000) + "1;", TextKind::script).size(), 1u);
  EXPECT_EQ(mistakes("var(a) = " + repeat("f(", 100000) + "1;", TextKind::script).size(), 1u);
}

TEST(HostileText, LongExpressionsAreBounded) {
  EXPECT_TRUE(mistakes("var(a) = 1" + repeat(" + 1", 1000) + ";", TextKind::script).empty());
  EXPECT_EQ(mistakes("var(a) = 1" + repeat(" + 1", 100000) + ";", TextKind::script).size(), 1u);
}

TEST(HostileText, BytesThatAreNotText) {
  EXPECT_EQ(mistakes("wait; # caf\xe9\nwait;", TextKind::script),
            std::vector<std::string>{"1:12: error: not UTF-8: byte 0xe9"});
  EXPECT_EQ(
      mistakes(std::string("wait;\n\0wait;", 12), TextKind::script),
      std::vector<std::string>{"2:1: error: unexpected character U+0000: this is not a text file"});
  EXPECT_EQ(mistakes("wait;\n\x01", TextKind::script),
            std::vector<std::string>{"2:1: error: unexpected character U+0001"});
}

TEST(HostileText, TextsThatNeverEnd) {
  EXPECT_EQ(mistakes("wait; /* remark\nwait;", TextKind::script),
            std::vector<std::string>{"1:7: error: this comment is never closed: '*/' is missing"});
  EXPECT_EQ(mistakes("robot r { behaviour \"a.motion;\n}", TextKind::robot).at(0),
            "1:21: error: this text is never closed: '\"' is missing on its line");
  EXPECT_EQ(mistakes("", TextKind::plan),
            std::vector<std::string>{
                "1:1: error: expected 'plan' at the start of a plan, found the end of the file"});
}

}  // namespace
}  // namespace rubicon
