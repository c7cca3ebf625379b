#include "src/studies/study/run_record.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace rubicon::study {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

LoggedRun run_of(std::int64_t number) {
  LoggedRun run{3, number, {}};
  run.record.values = {1.0 / 3, 1e300, 0, kNever};
  run.record.critical = {0, 4, 17};
  run.record.curve = {0, 2.5, 1e-9};
  run.record.rejected = {2};
  run.record.reason = "blocked by 'wall 3', 1 mm deep";
  return run;
}

TEST(RunLog, ReadsWhatItWrote) {
  const LoggedRun run = run_of(12);
  const auto read = read_line(write_line(run), 4);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->variant, 3u);
  EXPECT_EQ(read->run, 12);
  EXPECT_EQ(read->record, run.record);
  const LoggedRun plain{0, 0, {{1, 2}, {}, {}, {}, ""}};
  EXPECT_EQ(read_line(write_line(plain), 2)->record, plain.record);
}

TEST(RunLog, TakesNoLineThatIsCutOffOrDamaged) {
  const std::string line = write_line(run_of(12));
  for (std::size_t length = 0; length < line.size(); ++length) {
    EXPECT_FALSE(read_line(line.substr(0, length), 4)) << length;
  }
  EXPECT_FALSE(read_line(line, 3)) << "of a study that asked for less";
  for (const char* other : {"", "run", "run\t1\t2\t.", "run\t1\t-2\t1 2 3 4\t\t\t\t\t.",
                            "run\tx\t2\t1 2 3 4\t\t\t\t\t.", "run\t1\t2\t1 2 x 4\t\t\t\t\t."}) {
    EXPECT_FALSE(read_line(other, 4)) << other;
  }
}

TEST(VariantRuns, AreTheSameInWhateverOrderRunsCome) {
  StudyModel study;
  study.questions.resize(4);
  VariantRuns forwards;
  VariantRuns backwards;
  for (VariantRuns* each : {&forwards, &backwards}) {
    each->tasks.resize(20, "t");
    each->resize(study, 10);
  }
  for (int i = 0; i < 10; ++i) {
    LoggedRun run = run_of(i);
    run.record.reason += std::to_string(i);
    forwards.take(i, run.record);
    run = run_of(9 - i);
    run.record.reason += std::to_string(9 - i);
    backwards.take(9 - i, run.record);
  }
  EXPECT_EQ(forwards.values, backwards.values);
  EXPECT_EQ(forwards.critical, backwards.critical);
  EXPECT_EQ(forwards.curves, backwards.curves);
  EXPECT_EQ(forwards.rejections.at(2).reason, "blocked by 'wall 3', 1 mm deep0");
  EXPECT_EQ(backwards.rejections.at(2).reason, forwards.rejections.at(2).reason);
  EXPECT_EQ(backwards.rejections.at(2).runs, 10);
}

}  // namespace
}  // namespace rubicon::study
