#include <gtest/gtest.h>

#include <tao/pegtl/contrib/analyze.hpp>

#include "grammar/plan.hpp"
#include "grammar/robot.hpp"
#include "grammar/study.hpp"

namespace rubicon {
namespace {

TEST(Grammar, HasNoEndlessLoopsAndNoLeftRecursion) {
  EXPECT_EQ(tao::pegtl::analyze<grammar::script>(), 0u);
  EXPECT_EQ(tao::pegtl::analyze<grammar::robot_file>(), 0u);
  EXPECT_EQ(tao::pegtl::analyze<grammar::plan_file>(), 0u);
  EXPECT_EQ(tao::pegtl::analyze<grammar::study_file>(), 0u);
}

}  // namespace
}  // namespace rubicon
