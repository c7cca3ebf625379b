// A trace of very many attempts: small in memory, and going back costs no more than in a short one.

#include <gtest/gtest.h>

#include "src/results/debug/recording_reader.hpp"
#include "tests/support/growth.hpp"
#include "tests/support/random_cases.hpp"
#include "tests/unit/debug/hand_trace.hpp"
#include "tests/unit/debug/shipped_traces.hpp"

namespace rubicon::test {

namespace {

/// So many attempts, half of them refused, in loops of ten.
debug::Recording long_recording(int tries) {
  debug::RecordingReader reader;
  reader.line(hand_header());
  reader.line(hand_record("goal", R"("k":1,"n":1)"));
  for (int n = 1; n <= tries; ++n) {
    if (n % 10 == 1) reader.line(hand_loop("enter"));
    reader.line(hand_try(n, "x", 2, n % 2 == 0, n / 2, n / 2, 0));
    if (n % 10 == 0) reader.line(hand_loop("exit", R"(,"reached":true,"successes":5)"));
  }
  return reader.take();
}

TEST(LongTrace, AnEventIsSmall) { EXPECT_LE(sizeof(debug::Event), 40u); }

TEST(LongTrace, GoingBackCostsNoMoreThanInAShortOne) {
  const int tries = cases(200'000);
  debug::Session small({long_recording(tries / 20)}, "", {});
  debug::Session large({long_recording(tries)}, "", {});
  small.execute("continue");
  large.execute("continue");
  const auto walk = [](debug::Session& session) {
    for (int i = 0; i < 500; ++i) session.execute("back");
    for (int i = 0; i < 500; ++i) session.execute("step");
  };
  EXPECT_TRUE(grows_at_most(
      3, [&] { walk(small); }, [&] { walk(large); }));
}

TEST(LongTrace, EveryPlaceIsReached) {
  const int tries = cases(50'000);
  debug::Session session({long_recording(tries)}, "", {});
  for (const int n : {1, tries / 3, tries - 1, tries}) {
    session.execute("run to " + std::to_string(n));
    EXPECT_EQ(session.state().n, n);
    EXPECT_EQ(session.state().tried, n);
    EXPECT_EQ(session.state().made, n / 2);
  }
}

}  // namespace

}  // namespace rubicon::test
