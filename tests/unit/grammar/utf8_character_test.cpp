#include "interpreter/syntax/utf8_character.hpp"

#include <gtest/gtest.h>

#include <string>

namespace rubicon::test {

using interpreter::utf8_character;

namespace {

std::string encoded(char32_t code) {
  const auto byte = [](char32_t bits) {
    return static_cast<char>(static_cast<unsigned char>(bits));
  };
  const auto rest = [&](int shift) { return byte(0x80 | ((code >> shift) & 0x3F)); };
  if (code < 0x80) return {byte(code)};
  if (code < 0x800) return {byte(0xC0 | code >> 6), rest(0)};
  if (code < 0x10000) return {byte(0xE0 | code >> 12), rest(6), rest(0)};
  return {byte(0xF0 | code >> 18), rest(12), rest(6), rest(0)};
}

}  // namespace

TEST(Utf8Character, ReadsEveryCodePointAndNothingThatIsCutOff) {
  for (char32_t code = 0; code <= 0x10FFFF; ++code) {
    if (code == 0xD800) code = 0xE000;
    const std::string bytes = encoded(code);
    const auto character = utf8_character(bytes + "x");
    ASSERT_EQ(character.code, code);
    ASSERT_EQ(character.length, bytes.size());
    if (bytes.size() > 1) {
      ASSERT_EQ(utf8_character(bytes.substr(0, bytes.size() - 1)).length, 0u);
      ASSERT_EQ(utf8_character(bytes.substr(0, bytes.size() - 1) + "x").length, 0u);
    }
  }
  EXPECT_EQ(utf8_character("").length, 0u);
}

TEST(Utf8Character, ReadsNothingElse) {
  // A text begins with a code point or not, whatever follows: counted over all three bytes.
  int well_formed = 0;
  for (unsigned bits = 0; bits < 1u << 24; bits += 1) {
    const char bytes[] = {static_cast<char>(bits >> 16), static_cast<char>(bits >> 8 & 0xFF),
                          static_cast<char>(bits & 0xFF)};
    well_formed += utf8_character({bytes, 3}).length == 3 ? 1 : 0;
  }
  EXPECT_EQ(well_formed, 0x10000 - 0x800 - 0x800);  // U+0800 to U+FFFF but for surrogates
  for (const char* bytes :
       {"\xf0\x8f\xbf\xbf", "\xf4\x90\x80\x80", "\xf8\x88\x80\x80\x80", "\xff"}) {
    EXPECT_EQ(utf8_character(bytes).length, 0u);
  }
}

}  // namespace rubicon::test
