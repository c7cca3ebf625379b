#include "src/studies/answers/study_answers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "src/studies/answers/judgement.hpp"
#include "src/studies/statistics/bootstrap.hpp"
#include "src/studies/statistics/pareto.hpp"
#include "src/studies/statistics/quantile.hpp"
#include "src/studies/statistics/rank.hpp"

namespace rubicon::study {

namespace {

constexpr std::size_t kBins = 30;
constexpr std::size_t kFewestForTenths = 20;
constexpr double kDeviationsOfChance = 3;

std::vector<double> finite_of(const std::vector<double>& values) {
  std::vector<double> result;
  std::copy_if(values.begin(), values.end(), std::back_inserter(result),
               [](double value) { return std::isfinite(value); });
  return result;
}

Answer answer_of(const std::vector<double>& values) {
  Answer answer;
  const bool missing =
      std::any_of(values.begin(), values.end(), [](double value) { return std::isnan(value); });
  answer.there = !values.empty() && !missing;
  if (!answer.there) return answer;
  std::vector<double> sorted = values;
  std::sort(sorted.begin(), sorted.end());
  const std::vector<double> finite = finite_of(values);
  answer.mean = statistics::mean_of(finite);
  if (!finite.empty()) {
    answer.least = sorted.front();
    answer.most = sorted[finite.size() - 1];
  }
  for (const double p : kQuantiles) {
    const double value = statistics::quantile(sorted, p);
    const auto run = std::find(values.begin(), values.end(), value) - values.begin();
    answer.quantiles.push_back({p, value, statistics::quantile_interval(sorted, p), run});
  }
  return answer;
}

/// Of `b` less `a`, over the runs that finished in both.
statistics::Mean mean_difference(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> differences;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    if (std::isfinite(a[i]) && std::isfinite(b[i])) differences.push_back(b[i] - a[i]);
  }
  return statistics::mean_of(differences);
}

/// Compares all variants with the first that runs.
void add_differences(const std::vector<VariantRuns>& runs, std::vector<VariantAnswers>& answers) {
  const auto first = std::find_if(answers.begin(), answers.end(),
                                  [](const VariantAnswers& each) { return each.runs > 0; });
  for (auto other = first; other != answers.end(); ++other) {
    if (other == first || other->runs == 0) continue;
    for (std::size_t q = 0; q < other->answers.size(); ++q) {
      if (!first->answers[q].there || !other->answers[q].there) continue;
      other->answers[q].difference =
          mean_difference(runs[static_cast<std::size_t>(first - answers.begin())].values[q],
                          runs[static_cast<std::size_t>(other - answers.begin())].values[q]);
    }
  }
}

std::vector<TaskShare> critical_tasks(const VariantRuns& runs, std::int64_t finished) {
  std::vector<TaskShare> result;
  for (std::size_t i = 0; i < runs.critical.size(); ++i) {
    if (runs.critical[i] == 0 || finished == 0) continue;
    result.push_back({runs.tasks[i], runs.critical[i],
                      static_cast<double>(runs.critical[i]) / static_cast<double>(finished)});
  }
  std::stable_sort(result.begin(), result.end(),
                   [](const TaskShare& a, const TaskShare& b) { return a.runs > b.runs; });
  return result;
}

/// The mean of `values` over the runs that `draws` puts in its first or last tenth.
double mean_at_end(const std::vector<double>& values, const std::vector<std::size_t>& order,
                   bool last) {
  const std::size_t tenth = order.size() / 10;
  std::vector<double> some;
  for (std::size_t i = 0; i < tenth; ++i) {
    some.push_back(values[order[last ? order.size() - 1 - i : i]]);
  }
  return statistics::mean_of(some).mean;
}

std::vector<Driver> drivers_of(const StudyModel& study, const VariantRuns& runs) {
  if (!study.sampled || runs.values.empty()) return {};
  std::vector<std::uint64_t> numbers;
  std::vector<double> times;
  const std::vector<double>& all = runs.values[kMakespan];
  for (std::size_t i = 0; i < std::min(all.size(), kRunsForDrivers); ++i) {
    if (!std::isfinite(all[i])) continue;
    numbers.push_back(i);
    times.push_back(all[i]);
  }
  if (times.size() < 3) return {};
  std::vector<Driver> result;
  for (const UncertainPlace& each : runs.uncertain) {
    std::vector<double> draws;
    for (const std::uint64_t run : numbers) {
      draws.push_back(sampling::draw(each.law, {study.seed, run, each.place}));
    }
    Driver driver{each.place, statistics::rank_correlation(draws, times), 0, 0};
    if (times.size() >= kFewestForTenths) {
      std::vector<std::size_t> order(draws.size());
      for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
      std::stable_sort(order.begin(), order.end(),
                       [&](std::size_t a, std::size_t b) { return draws[a] < draws[b]; });
      driver.low = mean_at_end(times, order, false);
      driver.high = mean_at_end(times, order, true);
    }
    result.push_back(driver);
  }
  // What chance alone gives: the deviation of the correlation of independent numbers is 1 / root of
  // n.
  const double chance = kDeviationsOfChance / std::sqrt(static_cast<double>(times.size()));
  std::erase_if(result, [&](const Driver& each) { return std::abs(each.correlation) < chance; });
  std::stable_sort(result.begin(), result.end(), [](const Driver& a, const Driver& b) {
    return std::abs(a.correlation) > std::abs(b.correlation);
  });
  return result;
}

std::optional<ProgressBand> progress_of(const VariantRuns& runs) {
  ProgressBand band;
  for (std::size_t point = 0; point < kCurvePoints; ++point) {
    std::vector<double> times;
    for (const auto& curve : runs.curves) {
      if (curve.size() == kCurvePoints) times.push_back(curve[point]);
    }
    if (times.empty()) return std::nullopt;
    std::sort(times.begin(), times.end());
    band.p10.push_back(statistics::quantile(times, 0.1));
    band.p50.push_back(statistics::quantile(times, 0.5));
    band.p90.push_back(statistics::quantile(times, 0.9));
  }
  return band;
}

/// Counts by bins of equal width.
std::vector<std::int64_t> histogram_of(const std::vector<double>& values, const Answer& answer) {
  const double width = answer.most - answer.least;
  if (!answer.there || answer.mean.count == 0 || !(width > 0)) return {};
  std::vector<std::int64_t> counts(kBins, 0);
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    const double place = (value - answer.least) / width * static_cast<double>(kBins);
    ++counts[std::min(static_cast<std::size_t>(place), kBins - 1)];
  }
  return counts;
}

VariantAnswers answers_of_variant(const StudyModel& study, const VariantRuns& runs) {
  VariantAnswers result;
  if (!runs.fault.empty() || runs.values.empty()) {
    result.answers.resize(study.questions.size());
    return result;
  }
  result.runs = runs.runs();
  for (const double value : runs.values[kMakespan]) {
    if (!std::isfinite(value)) ++result.unfinished;
  }
  for (const auto& values : runs.values) result.answers.push_back(answer_of(values));
  if (!runs.costed) result.answers[kCost].there = false;
  result.critical = critical_tasks(runs, result.runs - result.unfinished);
  result.drivers = drivers_of(study, runs);
  for (const auto& [task, rejection] : runs.rejections) {
    result.rejections.push_back({runs.tasks[static_cast<std::size_t>(task)], rejection.runs,
                                 rejection.first_run, rejection.reason});
  }
  std::stable_sort(result.rejections.begin(), result.rejections.end(),
                   [](const TaskRejection& a, const TaskRejection& b) { return a.runs > b.runs; });
  result.progress = progress_of(runs);
  result.histogram = histogram_of(runs.values[kMakespan], result.answers[kMakespan]);
  return result;
}

std::vector<std::size_t> front_of(const std::vector<VariantAnswers>& variants) {
  std::vector<statistics::Costs> points;
  constexpr double kNever = std::numeric_limits<double>::infinity();
  bool any = false;
  for (const VariantAnswers& each : variants) {
    const bool counts = each.runs > 0 && each.unfinished == 0 && each.answers[kCost].there;
    any = any || counts;
    points.push_back(
        counts ? statistics::Costs{each.answers[kMakespan].mean.mean, each.answers[kCost].mean.mean}
               : statistics::Costs{kNever, kNever});
  }
  return any ? statistics::pareto_front(points) : std::vector<std::size_t>();
}

/// Judges the variants by the rule of a study.
class Chooser {
 public:
  Chooser(const StudyModel& study, const std::vector<VariantRuns>& runs)
      : study_(study), rule_(*study.choice), runs_(runs) {}

  ChoiceAnswer choose() {
    for (std::size_t i = 0; i < runs_.size(); ++i) {
      Judgement judged = judge(study_, rule_, runs_[i]);
      if (judged.why_not.empty()) {
        result_.judged.push_back({i, judged.value, {}});
      } else {
        result_.passed.push_back({i, std::move(judged.why_not)});
      }
    }
    if (result_.judged.empty()) return std::move(result_);
    const auto better = [&](const auto& a, const auto& b) {
      return rule_.least ? a.value < b.value : a.value > b.value;
    };
    const auto best = *std::min_element(result_.judged.begin(), result_.judged.end(), better);
    for (ChoiceAnswer::Difference& each : result_.judged) {
      const bool same = each.variant == best.variant || each.value == best.value;
      if (!same) each.interval = difference(best.variant, each.variant);
      if (same || (each.interval && each.interval->holds(0))) {
        result_.equal.push_back(each.variant);
      }
    }
    result_.chosen = result_.equal.front();
    return std::move(result_);
  }

 private:
  /// 95 % interval of the statistic of `other` less that of `best`, run by run.
  std::optional<statistics::Interval> difference(std::size_t best, std::size_t other) const {
    const auto question = static_cast<std::size_t>(rule_.statistic.question);
    const std::vector<double>& a = runs_[best].values[question];
    const std::vector<double>& b = runs_[other].values[question];
    if (rule_.statistic.quantile) {
      return statistics::quantile_difference(a, b, *rule_.statistic.quantile);
    }
    return mean_difference(a, b).interval;
  }

  const StudyModel& study_;
  const Choice& rule_;
  const std::vector<VariantRuns>& runs_;
  ChoiceAnswer result_;
};

}  // namespace

StudyAnswers answers_of(const StudyModel& study, const std::vector<VariantRuns>& variants) {
  StudyAnswers result;
  for (const VariantRuns& each : variants) {
    result.variants.push_back(answers_of_variant(study, each));
  }
  add_differences(variants, result.variants);
  result.pareto = front_of(result.variants);
  if (study.choice) result.choice = Chooser(study, variants).choose();
  return result;
}

std::vector<KeptRun> runs_to_keep(const StudyModel& study, const std::vector<VariantRuns>& variants,
                                  const StudyAnswers& answers) {
  std::vector<KeptRun> kept;
  const auto keep = [&](std::size_t variant, std::int64_t run) {
    const auto same = [&](const KeptRun& each) {
      return each.variant == variant && each.run == run;
    };
    if (std::any_of(kept.begin(), kept.end(), same)) return;
    kept.push_back({variant, run, fmt::format("films/variant_{}_run_{}", variant + 1, run)});
  };
  const auto keep_those_of = [&](std::size_t variant, bool median_only) {
    if (!variants[variant].fault.empty()) return;
    if (!study.sampled) return keep(variant, 0);
    for (const QuantileAnswer& each : answers.variants[variant].answers[kMakespan].quantiles) {
      if (std::isfinite(each.value) && (!median_only || each.p == 0.5)) keep(variant, each.run);
    }
  };
  if (answers.choice && answers.choice->chosen) keep_those_of(*answers.choice->chosen, false);
  for (const std::size_t variant : answers.pareto) keep_those_of(variant, !kept.empty());
  for (std::size_t v = 0; v < variants.size() && kept.empty(); ++v) keep_those_of(v, false);
  return kept;
}

}  // namespace rubicon::study
