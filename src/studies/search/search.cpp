#include "src/studies/search/search.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "src/motion/math/random.hpp"
#include "src/studies/answers/judgement.hpp"

namespace rubicon::study {

namespace {

/// Generations that bring nothing new before the optimiser begins again from other points.
constexpr int kStaleGenerations = 5;
/// Beginnings that bring nothing new before the search ends.
constexpr int kStaleBeginnings = 20;
/// No time (s) and no cost is worse: beyond it is what may not be chosen, the nearer to it first.
constexpr double kWorst = 1e15;

std::vector<Choice> objectives_of(const StudyModel& study, bool costed) {
  if (study.choice) return {*study.choice};
  std::vector<Choice> result(costed ? 2 : 1);  // makespan and cost are the first questions
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i].statistic.question = static_cast<int>(i);
    result[i].statistic.text = "mean(" + study.questions[i].text + ")";
  }
  return result;
}

double worth_of(const StudyModel& study, const Choice& rule, const VariantRuns& variant) {
  const Judgement judged = judge(study, rule, variant);
  if (!judged.why_not.empty()) return kWorst * (2 + judged.shortfall);
  return std::clamp(rule.least ? judged.value : -judged.value, -kWorst, kWorst);
}

/// The points of a search as settings, and which variable stands where in them.
class Points {
 public:
  explicit Points(const StudyModel& study) : study_(study) {
    for (std::size_t i = 0; i < study.variables.size(); ++i) {
      if (study.variables[i].range) ranges_.push_back(i);
      if (study.variables[i].values.size() > 1) lists_.push_back(i);
    }
  }

  SearchSpace space() const {
    SearchSpace result;
    result.ranges = ranges_.size();
    for (const std::size_t i : lists_) result.values.push_back(study_.variables[i].values.size());
    // Small generations: what is asked of a search is a good variant after few runs.
    result.generation = study_.budget < 150 ? 12 : study_.budget < 1000 ? 16 : 32;
    return result;
  }

  interpreter::ParameterTexts settings(const SearchPoint& point) const {
    interpreter::ParameterTexts result = variants_of(study_).front();
    for (std::size_t k = 0; k < ranges_.size(); ++k) {
      const Variable& variable = study_.variables[ranges_[k]];
      result[ranges_[k]].second = value_at(*variable.range, std::clamp(point[k], 0.0, 1.0));
    }
    for (std::size_t k = 0; k < lists_.size(); ++k) {
      const std::vector<std::string>& values = study_.variables[lists_[k]].values;
      const double index =
          std::clamp(point[ranges_.size() + k], 0.0, static_cast<double>(values.size() - 1));
      result[lists_[k]].second = values[static_cast<std::size_t>(index)];
    }
    return result;
  }

 private:
  const StudyModel& study_;
  std::vector<std::size_t> ranges_;
  std::vector<std::size_t> lists_;
};

class Search {
 public:
  Search(const StudyModel& study, bool costed, const SearchTools& tools)
      : study_(study), tools_(tools), objectives_(objectives_of(study, costed)), points_(study) {
    space_ = points_.space();
    space_.objectives = objectives_.size();
    best_.assign(space_.ranges + space_.values.size(), 0);
  }

  SearchResult run() {
    math::Random seeds(study_.seed);
    for (int stale = 0; stale < kStaleBeginnings && left() > 0;) {
      const std::size_t before = variants_.size();
      const auto optimiser =
          tools_.open(space_, best_, static_cast<std::uint32_t>(seeds.bits() >> 32));
      int old_generations = 0;
      while (left() > 0 && old_generations < kStaleGenerations) {
        const auto generation = optimiser->ask();
        if (!generation) return {std::nullopt, optimiser->failure()};
        const std::size_t tried = variants_.size();
        if (!evaluate(*generation)) return {};
        old_generations = variants_.size() > tried ? 0 : old_generations + 1;
        std::vector<std::vector<double>> worths;
        for (const SearchPoint& each : *generation) worths.push_back(worth(each));
        if (left() > 0 && !optimiser->tell(worths)) return {std::nullopt, optimiser->failure()};
      }
      stale = variants_.size() > before ? 0 : stale + 1;
    }
    return {std::move(variants_), ""};
  }

 private:
  std::size_t left() const { return static_cast<std::size_t>(study_.budget) - variants_.size(); }

  /// Tries what is new of a generation, as much as the budget allows.
  bool evaluate(const std::vector<SearchPoint>& generation) {
    std::vector<interpreter::ParameterTexts> fresh;
    std::vector<SearchPoint> where;
    for (const SearchPoint& each : generation) {
      interpreter::ParameterTexts settings = points_.settings(each);
      if (fresh.size() == left()) break;
      if (!worths_.try_emplace(settings).second) continue;
      fresh.push_back(std::move(settings));
      where.push_back(each);
    }
    if (fresh.empty()) return true;
    auto runs = tools_.run(fresh);
    if (!runs) return false;
    for (std::size_t i = 0; i < fresh.size(); ++i) {
      std::vector<double>& worth = worths_[fresh[i]];
      for (const Choice& each : objectives_) worth.push_back(worth_of(study_, each, (*runs)[i]));
      if (best_worth_.empty() || worth < best_worth_) {
        best_worth_ = worth;
        best_ = where[i];
      }
      variants_.push_back(std::move((*runs)[i]));
    }
    return true;
  }

  std::vector<double> worth(const SearchPoint& point) const {
    const auto found = worths_.find(points_.settings(point));
    if (found != worths_.end() && !found->second.empty()) return found->second;
    return std::vector<double>(objectives_.size(), 6 * kWorst);  // beyond the budget
  }

  const StudyModel& study_;
  const SearchTools& tools_;
  std::vector<Choice> objectives_;
  Points points_;
  SearchSpace space_;
  std::map<interpreter::ParameterTexts, std::vector<double>> worths_;
  std::vector<VariantRuns> variants_;
  SearchPoint best_;  ///< at first the first values of all
  std::vector<double> best_worth_;
};

}  // namespace

SearchResult search_study(const StudyModel& study, bool costed, const SearchTools& tools) {
  if (!must_search(study)) return {tools.run(variants_of(study)), ""};
  return Search(study, costed, tools).run();
}

}  // namespace rubicon::study
