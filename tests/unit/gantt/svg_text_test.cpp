#include "src/results/gantt/svg_text.hpp"

#include <gtest/gtest.h>

namespace rubicon::gantt {
namespace {

TEST(SvgText, EscapesMarkup) {
  EXPECT_EQ(xml_text("<a b=\"c\" d='e'>&amp;"), "&lt;a b=&quot;c&quot; d=&#39;e&#39;&gt;&amp;amp;");
}

TEST(SvgText, ReplacesWhatXmlDoesNotAllow) {
  const std::string control("a\0b\x01\x1b\x7f", 6);
  EXPECT_EQ(xml_text(control), "a\uFFFDb\uFFFD\uFFFD\uFFFD");
  EXPECT_EQ(xml_text("\xEF\xBF\xBF"), "\uFFFD");              // U+FFFF
  EXPECT_EQ(xml_text("\xED\xA0\x80"), "\uFFFD\uFFFD\uFFFD");  // half of a surrogate pair
  EXPECT_EQ(xml_text("\xC0\xAF\xF5\xE2\x82"), "\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD");
  EXPECT_EQ(xml_text("a\u202Eb"), "a\uFFFDb");  // turns the text around
  EXPECT_EQ(xml_text("a\nb\tc\rd"), "a\nb\tc d");
  EXPECT_EQ(xml_text("\u00E9\u4E2D\U0001F3D7"), "\u00E9\u4E2D\U0001F3D7");
}

TEST(SvgText, CutsToAWidth) {
  EXPECT_EQ(clipped("panel", 1000, 10), "panel");
  EXPECT_EQ(clipped("line\nbreak", 1000, 10), "line break");
  const std::string cut = clipped(std::string(10'000, 'x'), 100, 10);
  EXPECT_TRUE(cut.ends_with("\u2026"));
  EXPECT_LE(text_width(cut, 10), 100);
  EXPECT_GT(text_width(cut, 10), 85);
  EXPECT_EQ(clipped("panel", 8, 10), "");
  EXPECT_EQ(clipped("", 8, 10), "");
}

TEST(SvgText, NeverCutsACharacterInTwo) {
  std::string towers;
  for (int i = 0; i < 50; ++i) towers += "\U0001F3D7";
  for (double width = 30; width < 300; width += 1) {
    EXPECT_EQ(clipped(towers, width, 10), xml_text(clipped(towers, width, 10))) << width;
  }
}

TEST(SvgText, BreaksLinesAtBlanks) {
  const auto lines = wrapped("the load meets the wall of the house", 110, 10, 9);
  ASSERT_GE(lines.size(), 2U);
  for (const std::string& line : lines) EXPECT_LE(text_width(line, 10), 110) << line;
  EXPECT_EQ(lines.front().back() == ' ', false);
  EXPECT_EQ(wrapped(std::string(500, 'x'), 110, 10, 3).size(), 3U);
  EXPECT_TRUE(wrapped("", 110, 10, 3).empty());
}

TEST(SvgText, WritesShortLengths) {
  EXPECT_EQ(length_text(1.5), "1.5");
  EXPECT_EQ(length_text(120), "120");
  EXPECT_EQ(length_text(-0.001), "0");
  EXPECT_EQ(length_text(0.256), "0.26");
}

}  // namespace
}  // namespace rubicon::gantt
