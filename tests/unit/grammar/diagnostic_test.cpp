#include "interpreter/syntax/diagnostic.hpp"

#include <gtest/gtest.h>

namespace rubicon::interpreter {
namespace {

TEST(DidYouMean, FindsTheNearestName) {
  const std::vector<std::string> names{"goal", "move_to", "move_dir", "transport", "x"};
  EXPECT_EQ(did_you_mean("gaol", names), "goal");
  EXPECT_EQ(did_you_mean("moveto", names), "move_to");
  EXPECT_EQ(did_you_mean("tranport", names), "transport");
  EXPECT_EQ(did_you_mean("MOVE_TO", names), "move_to");
}

TEST(DidYouMean, IsSilentWhereNothingIsNear) {
  EXPECT_EQ(did_you_mean("lift", {"goal", "move_to"}), "");
  EXPECT_EQ(did_you_mean("y", {"x", "z"}), "");
  EXPECT_EQ(did_you_mean("goal", {"goal"}), "");
  EXPECT_EQ(did_you_mean(std::string(1000000, 'a'), {"goal"}), "");
}

TEST(DidYouMean, FirstOfEqual) { EXPECT_EQ(did_you_mean("mast", {"last", "most"}), "last"); }

TEST(Diagnostics, SortsByPlaceAndDropsDuplicates) {
  Diagnostics diagnostics;
  diagnostics.error("S04", {0, 9, 10}, "late");
  diagnostics.warning("W01", {0, 3, 4}, "first here");
  diagnostics.error("S05", {0, 3, 4}, "second here");
  diagnostics.error("S04", {0, 9, 12}, "late");
  diagnostics.note("N01", {1, 0, 1}, "other file");
  const std::vector<Diagnostic> sorted = diagnostics.sorted();
  ASSERT_EQ(sorted.size(), 4u);
  EXPECT_EQ(sorted[0].message, "first here");
  EXPECT_EQ(sorted[1].message, "second here");
  EXPECT_EQ(sorted[2].message, "late");
  EXPECT_EQ(sorted[3].message, "other file");
  EXPECT_TRUE(diagnostics.has_errors());
  EXPECT_EQ(diagnostics.errors(), 3);
}

}  // namespace
}  // namespace rubicon::interpreter
