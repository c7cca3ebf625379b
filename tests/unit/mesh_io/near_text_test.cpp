#include "src/exchange/mesh_io/near_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/mesh_io/mesh_files_io.hpp"

namespace rubicon::mesh_io::testing {
namespace {

using geometry::Vec3;
using ::testing::HasSubstr;

TEST(NearText, CornersFarOutAreMovedAndTheRestStays) {
  const auto moved = move_near(
      "# remark\no a\nv 155000.125 463000.5 2 0.1 0.2 0.3\r\n  v +155001.125 463001 3\nvn 0 0 1\n"
      "f 1 2 1\n",
      "v");
  ASSERT_TRUE(moved);
  EXPECT_EQ(moved->origin, Vec3(155001, 463001, 3));
  EXPECT_EQ(moved->text,
            "# remark\no a\nv -0.875 -0.5 -1 0.1 0.2 0.3\r\n  v 0.125 0 0\nvn 0 0 1\nf 1 2 1\n");
}

TEST(NearText, WhatIsNearOrOfAnotherFormStaysAsItIs) {
  EXPECT_FALSE(move_near("v 0 0 0\nv 1 1 1\n", "v"));
  EXPECT_FALSE(move_near("v 99 0 0\nv 100 1 1\n", "v"));
  EXPECT_FALSE(move_near("", "v"));
  EXPECT_FALSE(move_near("v 155000 463000 0\n", "v"));  // one point has no extent
  EXPECT_FALSE(move_near("v 155000 463000 0\nv 155001 x 0\n", "v"));
  EXPECT_FALSE(move_near("v 155000 463000 0\nv 155001 463001\n", "v"));
  EXPECT_FALSE(move_near("v 155000 463000 0\nv 155001 463001 nan\n", "v"));
  EXPECT_FALSE(move_near("v 155000 463000 0\nv 155001 463001 1\\\n", "v"));
}

/// A box of 4 m x 0.2 m x 2.5 m in a national grid.
Soup far_box() {
  return box_soup({155000.1234, 463000.5678, 12.3}, {155004.1234, 463000.7678, 14.8});
}

void expect_far_box(const std::string& name, const std::string& text) {
  TemporaryFolder folder;
  const auto result = read_in_own_folder(folder.write(name, text));
  ASSERT_TRUE(std::holds_alternative<ReadMesh>(result)) << std::get<MeshFailure>(result).message;
  const geometry::Box box = extent(*std::get<ReadMesh>(result).mesh);
  EXPECT_LT((box.lower - Vec3(155000.1234, 463000.5678, 12.3)).norm(), 1e-6);
  EXPECT_LT((box.upper - Vec3(155004.1234, 463000.7678, 14.8)).norm(), 1e-6);
}

TEST(NearText, ObjAndStlTextsKeepTheirDigits) {
  expect_far_box("a.obj", as_obj(far_box()));
  expect_far_box("a.stl", as_stl_text(far_box()));
}

}  // namespace
}  // namespace rubicon::mesh_io::testing
