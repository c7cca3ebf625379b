#include "src/exchange/ifc/work_budget.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <variant>

#include "src/exchange/ifc/element_bodies.hpp"
#include "tests/support/ifc_sample.hpp"
#include "tests/support/places.hpp"

// Work is counted, so that a file is read or refused whatever else the machine does.

namespace rubicon::ifc {
namespace {

struct Spent {
  std::size_t elements = 0;
  std::size_t bodies = 0;
  bool is_spent = false;
  std::uint64_t used = 0;
  std::uint64_t steps = 0;
};

Spent spend(const std::string& text, std::uint64_t steps) {
  const auto file = StepFile::read(text);
  const auto& step = std::get<StepFile>(file);
  const auto model = read_model(step);
  const auto& building = std::get<IfcModel>(model);
  WorkBudget budget = steps == 0 ? shape_budget(step) : WorkBudget(steps);
  Spent spent;
  spent.elements = building.elements.size();
  spent.bodies = element_bodies(step, building, budget).size();
  spent.is_spent = budget.is_spent();
  spent.used = budget.used();
  spent.steps = budget.steps();
  return spent;
}

TEST(WorkBudget, EndsAtTheElementThatCannotBePaidFor) {
  ::rubicon::testing::IfcSample sample;
  sample.blocks.assign(10, {});
  const std::string text = ::rubicon::testing::ifc_text(sample);
  const Spent whole = spend(text, 0);
  EXPECT_FALSE(whole.is_spent);
  EXPECT_EQ(whole.bodies, 10U);
  EXPECT_GT(whole.used, 10 * 200 * 12U);  // the least that ten boxes cost
  const Spent exact = spend(text, whole.used);
  EXPECT_FALSE(exact.is_spent);
  const Spent half = spend(text, whole.used / 2);
  EXPECT_TRUE(half.is_spent);
  EXPECT_EQ(half.bodies, 6U);
}

TEST(WorkBudget, RealModelsTakeASmallPartOfIt) {
  const auto folder =
      std::filesystem::path(rubicon::test::source_dir()) / "../shared/data/schependomlaan";
  if (!std::filesystem::is_directory(folder)) GTEST_SKIP() << "the shared data folder is not here";
  int models = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".ifc") continue;
    std::ifstream stream(entry.path(), std::ios::binary);
    const Spent spent = spend(std::string(std::istreambuf_iterator<char>(stream), {}), 0);
    EXPECT_EQ(spent.bodies, spent.elements) << entry.path();
    EXPECT_LT(spent.used * 50, spent.steps) << entry.path();
    RecordProperty(entry.path().filename().string(), std::to_string(spent.used));
    std::printf("%s: %llu of %llu steps\n", entry.path().filename().c_str(),
                static_cast<unsigned long long>(spent.used),
                static_cast<unsigned long long>(spent.steps));
    ++models;
  }
  EXPECT_EQ(models, 4);
}

}  // namespace
}  // namespace rubicon::ifc
