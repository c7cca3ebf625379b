#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "interpreter/check/plan_model.hpp"
#include "src/motion/robot/kinematics.hpp"
#include "tests/unit/check/check_cases.hpp"
#include "tests/unit/check/memory_files.hpp"

namespace rubicon::test {

namespace {

using interpreter::Diagnostics;
using interpreter::SourceMap;

/// The same numbers on every machine.
class Dice {
 public:
  std::size_t below(std::size_t count) {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return static_cast<std::size_t>(state_ >> 33) % count;
  }

 private:
  std::uint64_t state_ = 1995;
};

/// Words of a text: names, numbers and single other characters.
std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> words;
  for (const char c : text) {
    const bool in_word = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.';
    const bool was_word =
        !words.empty() && (std::isalnum(static_cast<unsigned char>(words.back().back())) != 0 ||
                           words.back().back() == '_' || words.back().back() == '.');
    if (in_word && was_word) {
      words.back() += c;
    } else {
      words.push_back(std::string(1, c));
    }
  }
  return words;
}

/// A text with a few words dropped, doubled, or replaced by words of other cases.
std::string mutated(const std::vector<std::string>& words, const std::vector<std::string>& others,
                    Dice& dice) {
  std::vector<std::string> result = words;
  for (std::size_t n = 1 + dice.below(3); n > 0 && !result.empty(); --n) {
    const std::size_t at = dice.below(result.size());
    const auto place = result.begin() + static_cast<std::ptrdiff_t>(at);
    switch (dice.below(4)) {
      case 0:
        result.erase(place);
        break;
      case 1:
        result.insert(place, result[dice.below(result.size())]);
        break;
      default:
        *place = others[dice.below(others.size())];
        break;
    }
  }
  std::string text;
  for (const std::string& word : result) text += word;
  return text;
}

/// Whatever a robot that passed the checks says can be computed.
void expect_computable(const robot::RobotModel& model, const std::string& text) {
  ASSERT_FALSE(model.bodies.empty()) << text;
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    ASSERT_LT(model.bodies[i].parent, static_cast<int>(i)) << text;
  }
  for (const robot::Parameter& each : model.parameters) {
    EXPECT_GE(each.step, 0) << text;
    EXPECT_EQ(each.step > 0, each.speed > 0) << text;
    EXPECT_GT(each.quantum, 0) << text;
    EXPECT_FALSE(each.display_name.empty()) << text;
  }
  const std::vector<double> q = model.start_values();
  const robot::Mounting mounting{math::Pose::Identity(), q};
  std::vector<math::Pose> poses;
  robot::body_poses(model, mounting, q, poses);
  EXPECT_TRUE(robot::tool_pose(model, mounting, q).matrix().allFinite()) << text;
  std::vector<double> next = q;
  std::vector<double> steps(q.size(), 1.0);
  robot::apply_rules(model, mounting, q, steps, next);
}

struct MutationSource {
  explicit MutationSource(const std::string& file_name) {
    for (const CheckCase& each : read_check_cases(file_name)) {
      texts.push_back(words_of(each.text));
      words.insert(words.end(), texts.back().begin(), texts.back().end());
    }
    for (const char* each : {"0", "-1", "1e300", "1e-300", "deg", "mm", "theta", "\"\"", "{", "}",
                             "(", ")", ";", "*", "-", "/"}) {
      for (int i = 0; i < 100; ++i) words.emplace_back(each);
    }
  }
  std::vector<std::vector<std::string>> texts;
  std::vector<std::string> words;
};

TEST(MutatedTexts, RobotsAreRefusedOrCanBeComputed) {
  const MutationSource source("robot_cases.txt");
  MemoryFiles files = case_files();
  Dice dice;
  int usable = 0;
  for (int round = 0; round < 100000; ++round) {
    const std::string text =
        mutated(source.texts[dice.below(source.texts.size())], source.words, dice);
    files.texts["site/machine.robot"] = text;
    SourceMap sources;
    Diagnostics diagnostics;
    const auto robot =
        interpreter::load_robot("site/machine.robot", sources, files, nullptr, diagnostics);
    ASSERT_NE(robot, nullptr);
    EXPECT_EQ(robot->usable, !diagnostics.has_errors()) << text;
    if (!robot->usable) continue;
    ++usable;
    expect_computable(robot->model, text);
  }
  EXPECT_GT(usable, 500);
}

TEST(MutatedTexts, PlansAreRefusedOrResolved) {
  const MutationSource source("plan_cases.txt");
  MemoryFiles files = case_files();
  Dice dice;
  int loaded = 0;
  for (int round = 0; round < 50000; ++round) {
    const std::string text =
        mutated(source.texts[dice.below(source.texts.size())], source.words, dice);
    files.texts["site/site.plan"] = text;
    SourceMap sources;
    Diagnostics diagnostics;
    const auto plan = interpreter::load_plan("site/site.plan", sources, files, diagnostics);
    EXPECT_EQ(plan == nullptr, diagnostics.has_errors()) << text;
    if (plan == nullptr) continue;
    ++loaded;
    for (const interpreter::RobotSpec& robot : plan->robots) {
      ASSERT_NE(robot.robot, nullptr) << text;
      EXPECT_EQ(robot.start.size(), robot.robot->model.parameters.size()) << text;
    }
    EXPECT_TRUE(!plan->short_form || (plan->robots.size() == 1 && plan->goal)) << text;
    for (const interpreter::TaskSpec& task : plan->tasks) {
      EXPECT_LT(task.robot, static_cast<int>(plan->robots.size())) << text;
      EXPECT_TRUE(task.robot >= 0 || !task.choices.empty() || (!task.move && !task.go)) << text;
      for (const interpreter::LinkSpec& link : task.after) {
        EXPECT_LT(link.task, static_cast<int>(plan->tasks.size())) << text;
      }
    }
  }
  EXPECT_GT(loaded, 500);
}

}  // namespace

}  // namespace rubicon::test
