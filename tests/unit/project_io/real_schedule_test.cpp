#include <gtest/gtest.h>

#include <algorithm>

#include "src/exchange/project_io/write_mspdi.hpp"
#include "tests/unit/project_io/project_support.hpp"
#include "tests/unit/project_io/sample_files_io.hpp"

namespace rubicon::test {
namespace {

using namespace project_io;

TEST(RealSchedule, the_apartment_building_comes_in_and_goes_back_whole) {
  const auto text = shared_data("schependomlaan/planning-2015-02-18.mspdi.xml");
  if (!text) GTEST_SKIP() << "../shared/data/schependomlaan is not there";
  const Reading reading = read_schedule(*text);
  ASSERT_TRUE(reading.project);
  const Project& project = *reading.project;
  EXPECT_EQ(project.tasks.size(), 157u);
  EXPECT_EQ(project.calendars.size(), 4u);
  std::size_t links = 0;
  for (const Task& task : project.tasks) links += task.after.size();
  EXPECT_EQ(links, 48u);
  const auto slabs = std::find_if(project.tasks.begin(), project.tasks.end(), [](const Task& task) {
    return task.name.starts_with("Kanaalplaatvloer leggen");
  });
  ASSERT_NE(slabs, project.tasks.end());
  EXPECT_EQ(slabs->duration.seconds, 8 * 3600);  // the planner's one day
  // Only settings of the program are not taken over: no value of a task is wrong or lost.
  for (const std::string& each : reading.said) EXPECT_EQ(each.substr(0, 3), "I07") << each;

  const Planned plan = plan_of(project);
  EXPECT_EQ(plan.mistakes, "");
  EXPECT_NE(plan.text.find("takes 8 h;"), std::string::npos);
  const Reading back = project_of_plan(plan.text);
  ASSERT_TRUE(back.project);
  EXPECT_TRUE(*back.project == project);
  const Reading again = read_schedule(write_mspdi(*back.project));
  ASSERT_TRUE(again.project);
  EXPECT_TRUE(*again.project == project);
}

}  // namespace
}  // namespace rubicon::test
