#include <gtest/gtest.h>

#include "tests/unit/collision/answers.hpp"

namespace rubicon::collision::test {
namespace {

/// Puts back what was in use.
class SimdTest : public testing::Test {
 protected:
  ~SimdTest() override { use_simd(before_); }

 private:
  Simd before_ = simd_in_use();
};

TEST_F(SimdTest, AllInstructionsGiveTheSameBytes) {
  if (simd_in_use() != Simd::kAvx2) GTEST_SKIP() << "this processor has the baseline only";
  for (const int obstacles : {1, 7, 60, 600}) {
    const Questions questions = random_questions(801 + obstacles, obstacles, 400);
    use_simd(Simd::kBaseline);
    ASSERT_EQ(simd_in_use(), Simd::kBaseline);
    const Answers baseline = answers_of(questions);
    use_simd(Simd::kAvx2);
    ASSERT_EQ(simd_in_use(), Simd::kAvx2);
    EXPECT_TRUE(answers_of(questions) == baseline) << obstacles;
  }
}

TEST_F(SimdTest, PreparingABodyGivesTheSameWhateverIsInUse) {
  use_simd(Simd::kBaseline);
  const Questions first = random_questions(901, 40, 200);
  use_simd(Simd::kAvx2);
  const Questions second = random_questions(901, 40, 200);
  const Answers answers = answers_of(first);
  EXPECT_TRUE(answers_of(second) == answers);
}

}  // namespace
}  // namespace rubicon::collision::test
