#include <gtest/gtest.h>

#include <thread>
#include <vector>

#include "tests/unit/collision/answers.hpp"

namespace rubicon::collision::test {
namespace {

// scripts/check_sanitizers runs this under the thread sanitizer.
TEST(Threads, OneWorldGivesAllThreadsTheSameBytes) {
  const Questions questions = random_questions(701, 80, 200);
  const Answers alone = answers_of(questions);
  std::vector<Answers> results(4);
  std::vector<std::thread> threads;
  for (Answers& result : results) threads.emplace_back([&] { result = answers_of(questions); });
  for (std::thread& thread : threads) thread.join();
  for (const Answers& result : results) EXPECT_TRUE(result == alone);
}

TEST(Threads, TheFirstQueriesEverMayRunTogether) {
  // Nothing may be made on first use without a guard: a fresh world and fresh bodies each time.
  for (int round = 0; round < 5; ++round) {
    const Questions questions = random_questions(702 + round, 20, 10);
    std::vector<Answers> results(4);
    std::vector<std::thread> threads;
    for (Answers& result : results) threads.emplace_back([&] { result = answers_of(questions); });
    for (std::thread& thread : threads) thread.join();
    for (const Answers& result : results) EXPECT_TRUE(result == results.front());
  }
}

}  // namespace
}  // namespace rubicon::collision::test
