#include "src/exchange/building_io/glob.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <string>

namespace rubicon::building_io {
namespace {

TEST(Glob, StarsAndQuestionMarksStandForOthers) {
  EXPECT_TRUE(matches_glob("floor", "Floor"));
  EXPECT_TRUE(matches_glob("", ""));
  EXPECT_TRUE(matches_glob("*", ""));
  EXPECT_TRUE(matches_glob("*floor*", "ground floor 2"));
  EXPECT_TRUE(matches_glob("IfcWall*", "IfcWallStandardCase"));
  EXPECT_TRUE(matches_glob("K?0/*/4", "K80/80/4"));
  EXPECT_TRUE(matches_glob("*a*b*c", "xaxbxbxc"));
  EXPECT_TRUE(matches_glob("H?he", "H\xC3\xB6he"));
  EXPECT_FALSE(matches_glob("floor", "floors"));
  EXPECT_FALSE(matches_glob("floor?", "floor"));
  EXPECT_FALSE(matches_glob("*a*b", "ba"));
  EXPECT_FALSE(matches_glob("", "x"));
}

TEST(Glob, APatternMadeToTakeLongDoesNot) {
  std::string pattern;
  for (int i = 0; i < 200; ++i) pattern += "*a";
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_FALSE(matches_glob(pattern + "b", std::string(20000, 'a')));
  EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(), 60);
}

TEST(Glob, BrokenTextDoesNoHarm) {
  EXPECT_TRUE(matches_glob("a?*", std::string("a\xC3")));
  EXPECT_FALSE(matches_glob("??", std::string("\xC3\xB6")));
}

}  // namespace
}  // namespace rubicon::building_io
