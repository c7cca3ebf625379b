#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "interpreter/parse/parse.hpp"
#include "src/motion/math/random.hpp"
#include "src/studies/study/study_model.hpp"
#include "tests/support/random_cases.hpp"

namespace rubicon::study {
namespace {

struct Checked {
  std::unique_ptr<StudyModel> model;
  std::vector<interpreter::Diagnostic> found;
};

Checked check(const std::string& items) {
  interpreter::SourceMap sources;
  interpreter::Diagnostics diagnostics;
  const auto file = sources.add("s.study", "study s { " + items + " }");
  Checked result;
  result.model = check_study(parse_study(sources, file, diagnostics), diagnostics);
  result.found = diagnostics.sorted();
  return result;
}

std::vector<std::string> values_of(const std::string& vary) {
  const Checked checked = check("plan \"p.plan\"; vary x " + vary + ";");
  return checked.model ? checked.model->variables.front().values : std::vector<std::string>();
}

TEST(Study, ValuesAndRanges) {
  using Texts = std::vector<std::string>;
  EXPECT_EQ(values_of("4, 6"), (Texts{"4", "6"}));
  EXPECT_EQ(values_of("2 to 5"), (Texts{"2", "3", "4", "5"}));
  EXPECT_EQ(values_of("0.1 to 0.4 by 0.1"), (Texts{"0.1", "0.2", "0.3", "0.4"}));
  EXPECT_EQ(values_of("30 m to 41 m by 5 m, 60 m"), (Texts{"30 m", "35 m", "40 m", "60 m"}));
  EXPECT_EQ(values_of("-2 to 1"), (Texts{"-2", "-1", "0", "1"}));
  EXPECT_EQ(values_of("\"high.robot\", \"low.robot\""), (Texts{"high.robot", "low.robot"}));
}

TEST(Study, EachMistakeHasItsCode) {
  const std::pair<const char*, const char*> cases[] = {
      {"U00", "plan \"p.plan\"; vary x;"},
      {"U00", "plan \"p.plan\"; runs many;"},
      {"U01", "plan \"p.plan\"; plan \"q.plan\";"},
      {"U02", "vary x 1;"},
      {"U03", "plan \"p.plan\"; vary x[1.5] 1;"},
      {"U04", "plan \"p.plan\"; vary x 1; vary x 2;"},
      {"U05", "plan \"p.plan\"; vary x 3 to 2;"},
      {"U05", "plan \"p.plan\"; vary x 1 m to 2 m;"},
      {"U05", "plan \"p.plan\"; vary x 1 m to 2 by 1 m;"},
      {"U05", "plan \"p.plan\"; vary x 1 to 2 by 0;"},
      {"U05", "plan \"p.plan\"; vary x 1 to 2 by 1e-9;"},
      {"U05", "plan \"p.plan\"; vary x 1, 2, 1;"},
      {"U06", "plan \"p.plan\"; design random;"},
      {"U06", "plan \"p.plan\"; design latin;"},
      {"U06", "plan \"p.plan\"; design full 7;"},
      {"U06", "plan \"p.plan\"; vary a 1 to 1000; vary b 1 to 1000; vary c 1 to 1000;"},
      {"U07", "plan \"p.plan\"; runs 0;"},
      {"U07", "plan \"p.plan\"; runs 1.5;"},
      {"U07", "plan \"p.plan\"; runs 100 s;"},
      {"U07", "plan \"p.plan\"; runs at most 100;"},
      {"U07", "plan \"p.plan\"; runs at most 100 until p80(makespan) < 4 h;"},
      {"U07", "plan \"p.plan\"; runs 100 until width(p80(makespan)) < 4 h;"},
      {"U08", "plan \"p.plan\"; seed 1.5;"},
      {"U09", "plan \"p.plan\"; ask speed;"},
      {"U09", "plan \"p.plan\"; ask utilisation;"},
      {"U09", "plan \"p.plan\"; ask cost(crane);"},
      {"U09", "plan \"p.plan\"; ask waiting(nothing);"},
      {"U09", "plan \"p.plan\"; ask p80(makespan);"},
      {"U09", "plan \"p.plan\"; choose least cost;"},
      {"U09", "plan \"p.plan\"; choose best mean(cost);"},
      {"U09", "plan \"p.plan\"; choose least p0(cost);"},
      {"U09", "plan \"p.plan\"; choose least p80(rejected);"},
      {"U10", "plan \"p.plan\"; choose least mean(cost) with p80(finish) <= 4;"},
      {"U10", "plan \"p.plan\"; choose least mean(cost) with mean(cost) <= 4 h;"},
      {"U10", "plan \"p.plan\"; choose least mean(cost) with mean(cost) <= \"2026-01-01\";"},
      {"U10", "plan \"p.plan\"; choose least mean(cost) with p80(finish) <= \"soon\";"},
  };
  for (const auto& [code, text] : cases) {
    const Checked checked = check(text);
    EXPECT_FALSE(checked.model) << text;
    ASSERT_EQ(checked.found.size(), 1u) << text;
    EXPECT_EQ(checked.found.front().code, code) << text << "\n" << checked.found.front().message;
    EXPECT_NE(checked.found.front().span.end, 0u) << text;
  }
}

TEST(Study, AWholeOne) {
  const Checked checked = check(
      "plan \"p.plan\"; vary bays 4, 6; vary crane \"a\", \"b\", \"c\"; seed 9; "
      "runs at most 500 until width(p80(finish)) < 4 h; "
      "ask makespan, cost, finish, utilisation(crane), start(set[3]), waiting(machine); "
      "choose least mean(cost) with p80(finish) <= \"2026-03-27\", rejected <= 0.02;");
  ASSERT_TRUE(checked.model) << checked.found.front().message;
  const StudyModel& model = *checked.model;
  EXPECT_EQ(count_variants(model), 6u);
  EXPECT_TRUE(model.sampled);
  EXPECT_EQ(model.seed, 9u);
  EXPECT_EQ(model.most_runs, 500);
  EXPECT_EQ(model.until->limit, 4 * 3600);
  EXPECT_EQ(model.until->statistic.quantile, 0.8);
  EXPECT_EQ(model.asked.size(), 6u);
  EXPECT_EQ(model.questions[static_cast<std::size_t>(model.asked[4])].of, "set_3");
  EXPECT_EQ(schedule::text_of(*model.choice->with[0].date), "2026-03-28 00:00")
      << "a date alone is the end of that day";
}

TEST(Variants, AreEveryCombinationTheLastFastest) {
  const Checked checked = check("plan \"p.plan\"; vary a 1, 2; vary b 5, 6, 7;");
  const auto variants = variants_of(*checked.model);
  ASSERT_EQ(variants.size(), 6u);
  EXPECT_EQ(variants[1], (interpreter::ParameterTexts{{"a", "1"}, {"b", "6"}}));
  EXPECT_EQ(variants[3], (interpreter::ParameterTexts{{"a", "2"}, {"b", "5"}}));
  EXPECT_EQ(variants_of(*check("plan \"p.plan\";").model).size(), 1u) << "the plan as it is";
}

TEST(Variants, OneAtATimeChangeOneValueOfTheFirst) {
  const Checked checked =
      check("plan \"p.plan\"; vary a 1, 2; vary b 5, 6, 7; design one_at_a_time;");
  const auto variants = variants_of(*checked.model);
  ASSERT_EQ(variants.size(), 4u);
  EXPECT_EQ(variants.size(), count_variants(*checked.model));
  for (const auto& set : variants) {
    EXPECT_LE((set[0].second != "1" ? 1 : 0) + (set[1].second != "5" ? 1 : 0), 1);
  }
}

TEST(Variants, OfALatinHypercubeTakeEachPartOnce) {
  const Checked checked = check(
      "plan \"p.plan\"; vary x 10 m to 20 m; vary kind \"a\", \"b\"; vary y 0 to 1; "
      "design latin 40; seed 3;");
  const auto variants = variants_of(*checked.model);
  ASSERT_EQ(variants.size(), 40u);
  std::set<int> parts;
  int of_a = 0;
  for (const auto& set : variants) {
    const double x = std::stod(set[0].second);
    EXPECT_TRUE(set[0].second.ends_with(" m"));
    parts.insert(static_cast<int>((x - 10) / 10 * 40));
    if (set[1].second == "a") ++of_a;
  }
  EXPECT_EQ(parts.size(), 40u);
  EXPECT_EQ(of_a, 20);
  EXPECT_EQ(variants, variants_of(*checked.model));
}

TEST(Study, MutatedTextsAreRefusedOrHaveVariants) {
  const std::vector<std::string> words = {"plan",
                                          "vary",
                                          "design",
                                          "runs",
                                          "seed",
                                          "ask",
                                          "choose",
                                          "until",
                                          "with",
                                          "by",
                                          "to",
                                          "at",
                                          "most",
                                          "least",
                                          "latin",
                                          "full",
                                          "one_at_a_time",
                                          "width",
                                          "p80",
                                          "mean",
                                          "finish",
                                          "cost",
                                          "rejected",
                                          "\"p.plan\"",
                                          "\"2026-03-01\"",
                                          "x",
                                          "y",
                                          "4",
                                          "-3",
                                          "1e300",
                                          "0.5 m",
                                          "2 h",
                                          "(",
                                          ")",
                                          "[",
                                          "]",
                                          "{",
                                          "}",
                                          ",",
                                          ";",
                                          "<=",
                                          "<",
                                          "7.5 s"};
  const std::vector<std::string> start = {
      "plan", "\"p.plan\"", ";",     "vary",     "x",        "1",      "to",     "5",    ";",
      "vary", "y",          "\"a\"", ",",        "\"b\"",    ";",      "runs",   "at",   "most",
      "500",  "until",      "width", "(",        "p80",      "(",      "finish", ")",    ")",
      "<",    "4 h",        ";",     "ask",      "makespan", ",",      "start",  "(",    "t",
      "[",    "3",          "]",     ")",        ";",        "choose", "least",  "mean", "(",
      "cost", ")",          "with",  "rejected", "<=",       "0.5",    ";"};
  math::Random random(9);
  int usable = 0;
  for (int round = 0; round < test::cases(20000); ++round) {
    std::vector<std::string> text = start;
    const std::size_t changes = random.index(4);  // 0: as it is
    for (std::size_t i = 0; i < changes; ++i) {
      const std::size_t at = random.index(text.size());
      const std::string& word = words[random.index(words.size())];
      switch (random.index(3)) {
        case 0:
          text[at] = word;
          break;
        case 1:
          text.insert(text.begin() + static_cast<std::ptrdiff_t>(at), word);
          break;
        default:
          text.erase(text.begin() + static_cast<std::ptrdiff_t>(at));
      }
    }
    std::string items;
    for (const std::string& each : text) items += each + " ";
    const Checked checked = check(items);
    bool errors = false;
    for (const auto& each : checked.found) {
      errors = errors || each.severity == interpreter::Severity::error;
    }
    ASSERT_EQ(checked.model == nullptr, errors) << items;
    if (!checked.model) continue;
    ++usable;
    const std::size_t count = count_variants(*checked.model);
    ASSERT_GE(count, 1u) << items;
    ASSERT_LE(count, kMostVariants) << items;
    ASSERT_EQ(variants_of(*checked.model).size(), count) << items;
    ASSERT_FALSE(checked.model->asked.empty()) << items;
  }
  EXPECT_GT(usable, test::at_least(3000));
}

}  // namespace
}  // namespace rubicon::study
