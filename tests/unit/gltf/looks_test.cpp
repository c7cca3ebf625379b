#include "src/results/gltf/looks.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "src/results/palette/colour.hpp"
#include "src/results/palette/palette.hpp"
#include "tests/support/places.hpp"

namespace rubicon::gltf {
namespace {

using palette::kDrawing;

/// What the page reads, and what C++ was built with, are one table.
TEST(Palette, IsThatOfThePage) {
  std::ifstream file(test::source_dir() + "/src/results/palette/palette.json");
  const auto table = nlohmann::json::parse(file);
  const auto& page = table.at("light").at("page");
  const auto& site = table.at("light").at("site");
  EXPECT_EQ(kDrawing.text, page.at("text").get<std::string>());
  EXPECT_EQ(kDrawing.muted, page.at("muted").get<std::string>());
  EXPECT_EQ(kDrawing.line, page.at("line").get<std::string>());
  EXPECT_EQ(kDrawing.panel, page.at("panel").get<std::string>());
  EXPECT_EQ(kDrawing.machine, page.at("machine").get<std::string>());
  EXPECT_EQ(kDrawing.crew, page.at("crew").get<std::string>());
  EXPECT_EQ(kDrawing.wait, page.at("wait").get<std::string>());
  EXPECT_EQ(kDrawing.critical, page.at("critical").get<std::string>());
  EXPECT_EQ(kDrawing.off, page.at("off").get<std::string>());
  EXPECT_EQ(kDrawing.bad, page.at("bad").get<std::string>());
  EXPECT_EQ(kDrawing.waiting, site.at("waiting").get<std::string>());
  EXPECT_EQ(kDrawing.carried, site.at("carried").get<std::string>());
  EXPECT_EQ(kDrawing.zone, site.at("zone").get<std::string>());
  EXPECT_EQ(kDrawing.rope, site.at("rope").get<std::string>());
  EXPECT_EQ(kDrawing.ground, site.at("ground").get<std::string>());
  EXPECT_EQ(kDrawing.fixture, site.at("fixture").get<std::string>());
  ASSERT_EQ(kDrawing.machines.size(), site.at("machines").size());
  ASSERT_EQ(kDrawing.components.size(), site.at("components").size());
  for (std::size_t i = 0; i < kDrawing.machines.size(); ++i) {
    EXPECT_EQ(kDrawing.machines[i], site.at("machines").at(i).get<std::string>());
  }
  for (std::size_t i = 0; i < kDrawing.components.size(); ++i) {
    EXPECT_EQ(kDrawing.components[i], site.at("components").at(i).get<std::string>());
  }
}

TEST(Palette, MakesColoursLinear) {  // IEC 61966-2-1
  const auto grey = palette::linear_rgb("#000a80");
  EXPECT_EQ(grey[0], 0);
  EXPECT_NEAR(grey[1], 10.0 / 255 / 12.92, 1e-12);
  EXPECT_NEAR(grey[2], 0.21586050011389926, 1e-9);
  EXPECT_NEAR(palette::linear_rgb("#ffffff")[0], 1, 1e-12);
  EXPECT_NEAR(palette::linear_rgb("#000000", 1)[1], 1, 1e-12);
  EXPECT_EQ(palette::linear_rgb("#ffffff", -1)[1], 0);
  for (const char* bad : {"", "#12345", "112233", "#11223g"}) {
    EXPECT_THROW(palette::linear_rgb(bad), std::invalid_argument) << bad;
  }
}

TEST(Looks, TellKindsByTheirNames) {
  EXPECT_EQ(kind_of("u_1_2.wall_3"), "wall");
  EXPECT_EQ(kind_of("slab"), "slab");
  EXPECT_EQ(kind_of("12"), "12");
  EXPECT_EQ(kind_of("stock.7_1"), "stock.7_1");
}

}  // namespace
}  // namespace rubicon::gltf
