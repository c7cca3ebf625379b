#include "interpreter/syntax/source.hpp"

#include <gtest/gtest.h>

namespace rubicon::interpreter {
namespace {

TEST(SourceMap, ColumnsCountCodePoints) {
  SourceMap sources;
  const FileId file = sources.add("a.motion",
                                  "\xef\xbb\xbf"
                                  "a\tθ x\r\nsecond\n");
  EXPECT_EQ(sources.file(file).text.substr(0, 2), "a\t");
  EXPECT_EQ(sources.position(file, 0).column, 1);
  EXPECT_EQ(sources.position(file, 2).column, 3);
  EXPECT_EQ(sources.position(file, 5).column, 5);  // behind θ (two bytes) and a blank
  const auto second = static_cast<std::uint32_t>(sources.file(file).text.find("second"));
  EXPECT_EQ(sources.position(file, second).line, 2);
  EXPECT_EQ(sources.position(file, second).column, 1);
}

TEST(SourceMap, LinesWithoutTheirEnds) {
  SourceMap sources;
  const FileId file = sources.add("a", "one\r\ntwo\n\nfour");
  EXPECT_EQ(sources.line(file, 1), "one");
  EXPECT_EQ(sources.line(file, 2), "two");
  EXPECT_EQ(sources.line(file, 3), "");
  EXPECT_EQ(sources.line(file, 4), "four");
  EXPECT_EQ(sources.line(file, 5), "");
  EXPECT_EQ(sources.line(file, 0), "");
}

TEST(SourceMap, ColumnsInALongLineAgreeWithCounting) {
  SourceMap sources;
  std::string text;
  for (int i = 0; i < 3000; ++i) text += i % 3 == 0 ? "θ" : "x";
  const FileId file = sources.add("long", text);
  int column = 1;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if ((static_cast<unsigned char>(text[at]) & 0xc0u) == 0x80u) continue;
    ASSERT_EQ(sources.position(file, static_cast<std::uint32_t>(at)).column, column);
    ++column;
  }
}

TEST(SourceMap, PlacesBehindTheEndAndUnknownFiles) {
  SourceMap sources;
  const FileId file = sources.add("a", "xy");
  EXPECT_EQ(sources.position(file, 99).column, 3);
  EXPECT_EQ(sources.position(kNoFile, 3).line, 1);
  EXPECT_EQ(sources.text({file, 1, 99}), "y");
  EXPECT_EQ(sources.text({kNoFile, 0, 1}), "");
}

}  // namespace
}  // namespace rubicon::interpreter
