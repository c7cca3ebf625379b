#include "src/studies/search/search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "src/motion/math/random.hpp"

namespace rubicon::study {
namespace {

using interpreter::ParameterTexts;

/// Answers with points by chance, or as a test says.
class FakeOptimiser : public Optimiser {
 public:
  using Next = std::function<std::optional<std::vector<SearchPoint>>()>;
  FakeOptimiser(Next next, std::vector<std::vector<double>>* told)
      : next_(std::move(next)), told_(told) {}
  std::optional<std::vector<SearchPoint>> ask() override { return next_(); }
  bool tell(std::span<const std::vector<double>> worths) override {
    told_->insert(told_->end(), worths.begin(), worths.end());
    return true;
  }
  std::string failure() const override { return "it is gone"; }

 private:
  Next next_;
  std::vector<std::vector<double>>* told_;
};

/// Gangs of 1 to 5, a beginning from 0 to 10.
StudyModel study_of(std::int64_t budget) {
  StudyModel study;
  study.name = "s";
  for (const Asked each : {Asked::makespan, Asked::cost, Asked::rejected}) {
    study.questions.push_back({each, "", each == Asked::makespan ? "makespan" : "cost", {}});
  }
  study.asked = {0, 1, 2};
  Variable gang;
  gang.name = "gang";
  gang.values = {"1", "2", "3", "4", "5"};
  Variable begin;
  begin.name = "begin";
  begin.range = Variable::Range{0, 10, "h"};
  study.variables = {gang, begin};
  study.design = Design::search;
  study.budget = budget;
  return study;
}

struct Searched {
  SearchResult result;
  std::vector<std::vector<double>> told;
  std::vector<SearchPoint> starts;
  std::vector<std::size_t> batches;
};

using MakeRun = std::function<void(const ParameterTexts&, VariantRuns&)>;

Searched search(const StudyModel& study, const MakeRun& run, FakeOptimiser::Next next,
                bool costed = true) {
  Searched made;
  SearchTools tools;
  tools.open = [&](const SearchSpace& space, const SearchPoint& start, std::uint32_t) {
    EXPECT_EQ(space.ranges, 1u);
    EXPECT_EQ(space.values, std::vector<std::size_t>{5});
    made.starts.push_back(start);
    return std::make_unique<FakeOptimiser>(next, &made.told);
  };
  tools.run = [&](const std::vector<ParameterTexts>& variants) {
    made.batches.push_back(variants.size());
    std::vector<VariantRuns> runs;
    for (const ParameterTexts& each : variants) {
      VariantRuns one;
      one.set = each;
      one.costed = costed;
      one.resize(study, 1);
      run(each, one);
      runs.push_back(std::move(one));
    }
    return std::optional(std::move(runs));
  };
  made.result = search_study(study, costed, tools);
  return made;
}

void set_values(VariantRuns& runs, double makespan, double cost) {
  runs.values[0][0] = makespan;
  runs.values[1][0] = cost;
  runs.values[2][0] = std::isfinite(makespan) ? 0 : 1;
}

FakeOptimiser::Next by_chance(std::uint64_t seed) {
  auto random = std::make_shared<math::Random>(seed);
  return [random] {
    std::vector<SearchPoint> points;
    for (int i = 0; i < 12; ++i) {
      points.push_back({random->uniform(), static_cast<double>(random->index(5))});
    }
    return std::optional(points);
  };
}

TEST(Search, TriesNoMoreThanItsBudgetAndNoneTwice) {
  for (const std::int64_t budget : {2, 7, 12, 100}) {
    const StudyModel study = study_of(budget);
    const Searched made = search(
        study, [](const ParameterTexts&, VariantRuns& runs) { set_values(runs, 1, 1); },
        by_chance(3));
    ASSERT_TRUE(made.result.variants);
    std::set<ParameterTexts> tried;
    for (const VariantRuns& each : *made.result.variants) tried.insert(each.set);
    EXPECT_EQ(made.result.variants->size(), static_cast<std::size_t>(budget));
    EXPECT_EQ(tried.size(), static_cast<std::size_t>(budget));
  }
}

TEST(Search, TellsNothingWorseThanWhatFails) {
  StudyModel study = study_of(60);
  study.choice.emplace();
  study.choice->statistic.text = "mean(makespan)";
  Condition limit;
  limit.statistic.question = 1;
  limit.statistic.text = "mean(cost)";
  limit.limit = 100;
  limit.text = "mean(cost) <= 100";
  study.choice->with.push_back(limit);
  // By gang: fine; over the limit; far over it; rejected; cannot run.
  const Searched made = search(
      study,
      [](const ParameterTexts& set, VariantRuns& runs) {
        const char gang = set[0].second[0];
        if (gang == '1') set_values(runs, 5000, 90);
        if (gang == '2') set_values(runs, 1, 101);
        if (gang == '3') set_values(runs, 1, 900);
        if (gang == '4') {
          set_values(runs, std::numeric_limits<double>::infinity(), 1);
          runs.rejections[0] = {1, 0, "in the way"};
        }
        if (gang == '5') runs.fault = "there is no such gang";
      },
      [] {
        std::vector<SearchPoint> points;
        static double place = 0;
        for (int i = 0; i < 5; ++i) points.push_back({place += 0.001, static_cast<double>(i)});
        return std::optional(points);
      });
  ASSERT_GE(made.told.size(), 5u);
  for (std::size_t i = 1; i < 5; ++i) EXPECT_LT(made.told[i - 1][0], made.told[i][0]) << i;
  EXPECT_EQ(made.told[0], std::vector<double>{5000});
}

TEST(Search, AsksForTheMostToo) {
  StudyModel study = study_of(24);
  study.choice.emplace();
  study.choice->least = false;
  const Searched made = search(
      study, [](const ParameterTexts&, VariantRuns& runs) { set_values(runs, 7, 1); },
      by_chance(1));
  EXPECT_EQ(made.told.front(), std::vector<double>{-7});
}

TEST(Search, WithoutARuleTellsTimeAndCost) {
  const StudyModel study = study_of(24);
  const MakeRun run = [](const ParameterTexts&, VariantRuns& runs) { set_values(runs, 7, 3); };
  EXPECT_EQ(search(study, run, by_chance(1)).told.front(), (std::vector<double>{7, 3}));
  EXPECT_EQ(search(study, run, by_chance(1), false).told.front(), std::vector<double>{7});
}

TEST(Search, BeginsAgainRoundTheBestAndEndsWhereNothingNewComes) {
  const StudyModel study = study_of(100);
  const Searched made = search(
      study,
      [](const ParameterTexts& set, VariantRuns& runs) {
        set_values(runs, set[0].second == "4" ? 1 : 9, 1);
      },
      [] {
        return std::optional(std::vector<SearchPoint>{{0.5, 0}, {0.25, 3}, {0.25, 3}});
      });
  ASSERT_TRUE(made.result.variants);
  EXPECT_EQ(made.result.variants->size(), 2u);
  EXPECT_EQ(made.starts.front(), (SearchPoint{0, 0}));
  EXPECT_EQ(made.starts.back(), (SearchPoint{0.25, 3}));
  EXPECT_GT(made.starts.size(), 2u);
  EXPECT_EQ((*made.result.variants)[1].set, (ParameterTexts{{"gang", "4"}, {"begin", "2.5 h"}}));
}

TEST(Search, SaysThatTheOptimiserIsGone) {
  const Searched made = search(
      study_of(50), [](const ParameterTexts&, VariantRuns& runs) { set_values(runs, 1, 1); },
      [] { return std::optional<std::vector<SearchPoint>>(); });
  EXPECT_FALSE(made.result.variants);
  EXPECT_EQ(made.result.failure, "it is gone");
}

TEST(Search, TakesPointsOutOfRangeForTheNearest) {
  const Searched made = search(
      study_of(3), [](const ParameterTexts&, VariantRuns& runs) { set_values(runs, 1, 1); },
      [] {
        return std::optional(std::vector<SearchPoint>{{-1, -3}, {7, 99}, {0.123456789, 1.9}});
      });
  ASSERT_EQ(made.result.variants->size(), 3u);
  EXPECT_EQ((*made.result.variants)[0].set, (ParameterTexts{{"gang", "1"}, {"begin", "0 h"}}));
  EXPECT_EQ((*made.result.variants)[1].set, (ParameterTexts{{"gang", "5"}, {"begin", "10 h"}}));
  EXPECT_EQ((*made.result.variants)[2].set,
            (ParameterTexts{{"gang", "2"}, {"begin", "1.23457 h"}}));
}

}  // namespace
}  // namespace rubicon::study
