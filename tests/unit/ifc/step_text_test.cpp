#include <gtest/gtest.h>

#include "src/exchange/ifc/step_values.hpp"

namespace rubicon::ifc {
namespace {

TEST(StepText, EscapesBecomeUtf8) {
  EXPECT_EQ(decode_step_text("it''s"), "it's");
  EXPECT_EQ(decode_step_text("a\\\\b"), "a\\b");
  EXPECT_EQ(decode_step_text("caf\\X\\E9"), "caf\xC3\xA9");
  EXPECT_EQ(decode_step_text("\\X2\\00E900DF\\X0\\ x"), "\xC3\xA9\xC3\x9F x");
  EXPECT_EQ(decode_step_text("\\X2\\D83DDE00\\X0\\"), "\xF0\x9F\x98\x80");
  EXPECT_EQ(decode_step_text("\\X4\\0001F600\\X0\\"), "\xF0\x9F\x98\x80");
  EXPECT_EQ(decode_step_text("H\\S\\vhe"), "H\xC3\xB6he");
  EXPECT_EQ(decode_step_text("\\PA\\x"), "x");
}

TEST(StepText, ALineBreakInsideIsNoPartOfTheText) { EXPECT_EQ(decode_step_text("a\r\nb"), "ab"); }

TEST(StepText, AnEscapeThatBreaksItsRulesStays) {
  for (const char* text :
       {"\\", "\\X", "\\X\\", "\\X\\0", "\\X\\GG", "\\X2\\00E9", "\\X2\\0E\\X0\\",
        "\\X2\\WXYZ\\X0\\", "\\X4\\0000\\X0\\", "\\S\\", "\\Q\\"}) {
    EXPECT_EQ(decode_step_text(text), text);
  }
}

TEST(StepText, HalfAPairAndWhatIsBeyondUnicodeIsReplaced) {
  EXPECT_EQ(decode_step_text("\\X2\\DE00\\X0\\"), "\xEF\xBF\xBD");
  EXPECT_EQ(decode_step_text("\\X4\\00110000\\X0\\"), "\xEF\xBF\xBD");
}

}  // namespace
}  // namespace rubicon::ifc
