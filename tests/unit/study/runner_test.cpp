#include "src/studies/study/runner.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "interpreter/parse/parse.hpp"
#include "src/simulation/taskplan/run_plan.hpp"
#include "src/studies/answers/study_answers.hpp"
#include "src/studies/answers/study_text.hpp"

namespace rubicon::study {
namespace {

/// A plan without other files.
class OnePlan : public interpreter::FileProvider {
 public:
  explicit OnePlan(std::string text) : text_(std::move(text)) {}
  std::variant<std::string, interpreter::FileFailure> read_text(const std::string&) override {
    return text_;
  }
  std::variant<std::shared_ptr<const geometry::TriangleMesh>, interpreter::FileFailure> read_mesh(
      const interpreter::MeshRequest&) override {
    return interpreter::FileFailure{"no meshes"};
  }

 private:
  std::string text_;
};

struct Made {
  StudyModel model;
  std::vector<VariantRuns> variants;
  StudyAnswers answers;
};

Made make(const std::string& plan, const std::string& items, int threads = 2,
          std::vector<LoggedRun> known = {}) {
  interpreter::SourceMap sources;
  interpreter::Diagnostics diagnostics;
  const auto file = sources.add("s.study", "study s { plan \"p.plan\"; " + items + " }");
  const auto model = check_study(parse_study(sources, file, diagnostics), diagnostics);
  EXPECT_TRUE(model) << diagnostics.sorted().front().message;
  const auto variants = variants_of(*model);
  RunnerOptions options;
  options.threads = threads;
  options.known = std::move(known);
  options.read = [&](std::size_t, const interpreter::ParameterTexts& set) {
    LoadedVariant loaded;
    OnePlan files(plan);
    interpreter::Diagnostics found;
    loaded.plan = load_plan("p.plan", loaded.sources, files, found, set);
    if (!loaded.plan) loaded.fault = found.sorted().front().message;
    return loaded;
  };
  Made made{*model, *run_study(*model, variants, options), {}};
  made.answers = answers_of(made.model, made.variants);
  return made;
}

const Answer& answer(const Made& made, std::size_t variant, const std::string& question) {
  for (std::size_t i = 0; i < made.model.questions.size(); ++i) {
    if (made.model.questions[i].text == question) return made.answers.variants[variant].answers[i];
  }
  throw std::logic_error("no such question: " + question);
}

TEST(Runner, GivesTheSameWhateverTheThreadsAndWhatIsKnown) {
  const std::string plan =
      "plan p { parameter n = 1; crew gang { size n; } for i from 1 to 5 { task t[i] { by gang; "
      "needs 1 gang; takes exponential(1 h); } } }";
  const std::string items =
      "vary n 1 to 3; runs at most 400 until width(p80(makespan)) < 1 h; ask makespan, waiting;";
  const Made one = make(plan, items, 1);
  const std::string expected = study_json(one.model, one.variants, one.answers) +
                               runs_csv(one.model, one.variants) +
                               study_table(one.model, one.variants, one.answers);
  EXPECT_GT(one.variants[0].runs(), 50);
  std::vector<LoggedRun> known;
  for (std::size_t v = 0; v < one.variants.size(); ++v) {
    for (std::int64_t run = 0; run < one.variants[v].runs(); run += 3) {
      LoggedRun logged{v, run, {}};
      for (const auto& values : one.variants[v].values) {
        logged.record.values.push_back(values[static_cast<std::size_t>(run)]);
      }
      if (run < kCurves)
        logged.record.curve = one.variants[v].curves[static_cast<std::size_t>(run)];
      known.push_back(logged);
    }
  }
  for (const int threads : {2, 4, 7}) {
    const Made made = make(plan, items, threads);
    EXPECT_EQ(study_json(made.model, made.variants, made.answers) +
                  runs_csv(made.model, made.variants) +
                  study_table(made.model, made.variants, made.answers),
              expected);
    // A third of the runs from the log; which tasks were critical in them is not in these.
    const Made resumed = make(plan, items, threads, known);
    EXPECT_EQ(runs_csv(resumed.model, resumed.variants), runs_csv(one.model, one.variants));
  }
}

TEST(Runner, FindsPertNetworksAnswers) {
  // Two chains side by side, then one task: the mean of the sum is exact, the maximum is not less
  // than that of the means.
  const std::string plan =
      "plan p { start_at \"2026-03-02 08:00\"; task a { takes pert(1 h, 2 h, 9 h); } "
      "task b { takes uniform(1 h, 3 h); after a; } task c { takes triangular(1 h, 2 h, 6 h); "
      "after b; } }";
  const Made made = make(plan, "runs 4000; ask makespan, finish, start(c), duration(b);");
  const statistics::Mean& mean = answer(made, 0, "makespan").mean;
  EXPECT_TRUE(mean.interval->holds(3 * 3600 + 2 * 3600 + 3 * 3600)) << mean.mean;
  // Variance of pert: (mean - low) (high - mean) / 7; uniform: w^2 / 12; triangular.
  const double variance = (2.0 * 6.0) / 7 + 4.0 / 12 + (1 + 4 + 36 - 2 - 6 - 12) / 18.0;
  EXPECT_NEAR(mean.deviation / 3600, std::sqrt(variance), 0.05);
  EXPECT_NEAR(answer(made, 0, "start(c)").mean.mean + answer(made, 0, "duration(b)").mean.mean * 0 +
                  3 * 3600,
              mean.mean, 120);
  EXPECT_EQ(made.answers.variants[0].critical.size(), 3u);
  EXPECT_EQ(made.answers.variants[0].drivers.front().place, "a.takes");
  EXPECT_NE(study_table(made.model, made.variants, made.answers).find("2026-03-02 16:0"),
            std::string::npos)
      << study_table(made.model, made.variants, made.answers);
}

TEST(Runner, FindsTheWaitOfAQueue) {
  // M/M/1 and M/D/c with arrivals each 100 s. From an empty queue, 1,000 customers, 40 runs.
  const auto queue = [](const std::string& service, int clerks = 1) {
    return "plan q { crew clerks { size " + std::to_string(clerks) +
           "; } for i from 1 to 1000 { task come[i] { takes exponential(100 s); "
           "when (i > 1) { after come[i - 1]; } } task serve[i] { by clerks; needs 1 clerks; "
           "takes " +
           service + "; after come[i]; } } }";
  };
  const Made random = make(queue("exponential(60 s)"), "runs 40; ask waiting(resource);");
  const Made constant = make(queue("60 s"), "runs 40; ask waiting(resource);");
  const Made two = make(queue("120 s", 2), "runs 40; ask waiting(resource);");
  const auto interval_of = [](const Made& made) {
    const auto interval = *answer(made, 0, "waiting(resource)").mean.interval;
    return statistics::Interval{interval.low / 1000, interval.high / 1000};
  };
  // Service of 60 s: a customer waits rho / (1 - rho) * service, or half of that.
  EXPECT_TRUE(interval_of(random).holds(90)) << interval_of(random).low;
  EXPECT_TRUE(interval_of(constant).holds(45)) << interval_of(constant).low;
  // With c clerks and a = service / arrivals it is the service times the sum over i of
  // P(N >= i c) - P(N > i c) c / a, with N of Poisson's law with the mean i a (C. D. Crommelin,
  // Post Office Electrical Engineers' Journal 25, 1932): 0.293036 for a = 1.2 and c = 2.
  EXPECT_TRUE(interval_of(two).holds(0.293036 * 120)) << interval_of(two).low;
  EXPECT_LT(interval_of(random).width(), 25);
}

TEST(Runner, AVariantThatFailsCannotLookCheapest) {
  // Two people are asked for; with one the task is rejected before it costs anything.
  const std::string plan =
      "plan p { parameter people = 2; crew gang { size 3; cost 10 per h; } "
      "task work { by gang; takes uniform(1 h, 3 h); } "
      "when (people < 2) { task other { by gang; needs 4 gang; takes 1 h; after work; } } }";
  const Made made = make(plan, "vary people 1, 2, 3, 1.5; runs 60; choose least mean(cost);");
  EXPECT_FALSE(made.variants[0].fault.empty()) << "needs 4 of 3: refused before it runs";
  ASSERT_TRUE(made.answers.choice->chosen);
  EXPECT_EQ(*made.answers.choice->chosen, 1u);
  EXPECT_EQ(made.answers.choice->passed.size(), 2u);
  EXPECT_EQ(made.answers.pareto, (std::vector<std::size_t>{1, 2}));
}

TEST(Runner, ChoosesTheFirstOfThoseThatAreAsGood) {
  const std::string plan =
      "plan p { parameter idle = 1; crew gang { cost 10 per h; } crew spare { size idle; } "
      "task work { by gang; takes uniform(1 h, 3 h); } }";
  const Made made = make(plan, "vary idle 3, 1, 2; runs 60; choose least p80(makespan);");
  EXPECT_EQ(*made.answers.choice->chosen, 0u);
  EXPECT_EQ(made.answers.choice->equal.size(), 3u);
}

TEST(Runner, DrawsApartFromThePlanWhatIsDrawnIntoIt) {
  // Works, works of a choice, a dig by its stages, weather: all that is drawn for a run.
  const std::string plan =
      "plan p { start_at \"2026-03-02 07:00\"; currency \"EUR\"; "
      "calendar days { mon-fri 07:00-15:00; lost 0.3; } "
      "crew far { calendar days; cost 40 per h; } crew near { calendar days; cost 50 per h; } "
      "pool carts { of far, near; choose least_used; } "
      "crew digger { calendar days; cost 90 per h; } crew trucks { size 3; cost 60 per h; } "
      "task dig { by digger; dig 60 m3 { bed 6 m3; bucket 1 m3; pass takes uniform(10 s, 30 s); "
      "load trucks; haul takes triangular(5 min, 6 min, 15 min); tip takes 1 min; "
      "return takes uniform(4 min, 9 min); } } "
      "for i from 1 to 4 { task t[i] { by carts; takes exponential(1 h); takes uniform(1 h, 2 h); "
      "after dig; } } }";
  const Made made = make(plan, "runs 8; seed 3; ask makespan, cost, waiting, production(dig);");
  interpreter::SourceMap sources;
  interpreter::Diagnostics diagnostics;
  OnePlan files(plan);
  const auto model = load_plan("p.plan", sources, files, diagnostics);
  ASSERT_TRUE(model) << diagnostics.sorted().front().message;
  ASSERT_EQ(interpreter::count_uncertain(*model), 11);
  std::set<double> makespans, productions;
  std::set<std::size_t> lost;
  for (std::uint64_t run = 0; run < 8; ++run) {
    draw_durations(*model, {3, run});
    const taskplan::Schedule schedule = taskplan::run_plan(*model, sources, nullptr);
    const RunRecord record = record_of(made.model, *model, schedule, false);
    for (std::size_t i = 0; i < record.values.size(); ++i) {
      EXPECT_EQ(made.variants[0].values[i][run], record.values[i])
          << made.model.questions[i].text << " of run " << run;
    }
    makespans.insert(record.values.front());
    productions.insert(record.values.back());
    lost.insert(schedule.lost_days.front().dates.size());
  }
  EXPECT_EQ(makespans.size(), 8u);
  EXPECT_EQ(productions.size(), 8u);
  EXPECT_GT(lost.size(), 1u);
}

}  // namespace
}  // namespace rubicon::study
