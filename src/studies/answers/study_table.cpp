#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "src/results/report/columns.hpp"
#include "src/studies/answers/study_text.hpp"
#include "src/studies/answers/value_text.hpp"

namespace rubicon::study {

namespace {

constexpr std::size_t kShownDrivers = 5;
constexpr std::size_t kShownTasks = 8;
constexpr std::size_t kShownPassed = 12;
constexpr std::size_t kShownSearched = 20;
constexpr std::size_t kShownFaults = 5;  // of a search

class Table {
 public:
  Table(const StudyModel& study, const std::vector<VariantRuns>& variants,
        const StudyAnswers& answers)
      : study_(study), variants_(variants), answers_(answers), shown_(shown_variants()) {}

  std::string text() {
    head();
    if (study_.sampled) {
      for (const int question : study_.asked) sampled(static_cast<std::size_t>(question));
    } else {
      certain();
    }
    faults();
    rejections();
    drivers();
    pareto();
    choice();
    return std::move(text_);
  }

 private:
  template <typename... Args>
  void line(fmt::format_string<Args...> format, Args&&... args) {
    text_ += fmt::format(format, std::forward<Args>(args)...) + "\n";
  }

  void head() {
    const std::size_t count = variants_.size();
    std::string runs = "durations at their means";
    if (study_.sampled) {
      runs =
          study_.until
              ? fmt::format("at most {} runs each, until {}", study_.most_runs, study_.until->text)
              : fmt::format("{} run{} each", study_.most_runs, study_.most_runs == 1 ? "" : "s");
      runs += fmt::format(", seed {}", study_.seed);
    }
    line("study {}: {} variant{} of {}, {}", study_.name, count, count == 1 ? "" : "s", study_.plan,
         runs);
    if (is_cut()) {
      const std::string which = !has_good() ? "none is good; the first are"
                                : shown_.size() == 1
                                    ? "the best is"
                                    : fmt::format("the {} best are", shown_.size());
      line("{} shown; --format csv tells all", which);
    }
  }

  /// A search tries many variants, of which only the best are of interest.
  bool is_cut() const {
    return study_.design == Design::search && variants_.size() > kShownSearched;
  }

  /// Whether a search found a variant that may be chosen.
  bool has_good() const {
    return answers_.choice ? !answers_.choice->judged.empty() : !by_makespan().empty();
  }

  /// All, in order; of a search the best by its rule, the best first, or the front of time and
  /// cost.
  std::vector<std::size_t> shown_variants() const {
    std::vector<std::size_t> result;
    if (!is_cut()) {
      for (std::size_t v = 0; v < variants_.size(); ++v) result.push_back(v);
    } else if (answers_.choice) {
      auto judged = answers_.choice->judged;
      std::stable_sort(judged.begin(), judged.end(), [&](const auto& a, const auto& b) {
        return study_.choice->least ? a.value < b.value : a.value > b.value;
      });
      for (const auto& each : judged) result.push_back(each.variant);
    } else {
      result = answers_.pareto;
      if (result.empty()) result = by_makespan();
    }
    // Where none is good, the first tell why not.
    for (std::size_t v = 0; is_cut() && !has_good() && v < kShownSearched; ++v) {
      result.push_back(v);
    }
    if (is_cut() && result.size() > kShownSearched) result.resize(kShownSearched);
    return result;
  }

  /// Those in which nothing is rejected.
  std::vector<std::size_t> by_makespan() const {
    std::vector<std::size_t> result;
    const auto mean = [&](std::size_t v) { return answers_.variants[v].answers[0].mean.mean; };
    for (std::size_t v = 0; v < variants_.size(); ++v) {
      if (answers_.variants[v].runs > 0 && answers_.variants[v].unfinished == 0)
        result.push_back(v);
    }
    std::stable_sort(result.begin(), result.end(),
                     [&](std::size_t a, std::size_t b) { return mean(a) < mean(b); });
    return result;
  }

  std::vector<std::string> names() const {
    std::vector<std::string> result{"variant"};
    for (const Variable& each : study_.variables) result.push_back(each.name);
    return result;
  }

  std::vector<std::string> settings(std::size_t v) const {
    std::vector<std::string> result{fmt::format("{}", v + 1)};
    for (const auto& [name, value] : variants_[v].set) result.push_back(value);
    return result;
  }

  void add(const std::vector<report::TableRow>& rows, std::size_t first_number) {
    std::vector<std::size_t> right{0};
    for (std::size_t i = first_number; i < rows.front().size(); ++i) right.push_back(i);
    text_ += "\n" + report::columns(rows, right);
  }

  std::string shown(std::size_t question, double value, std::size_t v) const {
    return value_text(unit_of(study_.questions[question].asked), value, variants_[v]);
  }

  /// One run of each variant: a column a question.
  void certain() {
    std::vector<report::TableRow> rows{names()};
    const std::size_t first_number = rows.front().size();
    for (const int question : study_.asked) {
      rows.front().push_back(study_.questions[static_cast<std::size_t>(question)].text);
    }
    for (const std::size_t v : shown_) {
      if (!variants_[v].fault.empty()) continue;
      rows.push_back(settings(v));
      for (const int asked : study_.asked) {
        const auto question = static_cast<std::size_t>(asked);
        const bool there = answers_.variants[v].answers[question].there;
        rows.back().push_back(there ? shown(question, variants_[v].values[question][0], v) : "-");
      }
    }
    if (rows.size() > 1) add(rows, first_number);
  }

  /// Many runs: a table a question.
  void sampled(std::size_t question) {
    const Question& asked = study_.questions[question];
    if (asked.asked == Asked::rejected) return;  // a column of every table
    if (asked.asked == Asked::cost && study_.asked.size() == 3 && !any_cost()) return;
    text_ += "\n" + asked.text;
    const bool moment = unit_of(asked.asked) == Unit::moment;
    std::vector<report::TableRow> rows{names()};
    const std::size_t first_number = rows.front().size();
    for (const char* each : {"runs", "rejected", "mean", "+-"}) rows.front().emplace_back(each);
    for (const double p : kQuantiles) rows.front().push_back(fmt::format("P{:g}", 100 * p));
    for (const std::size_t v : shown_) {
      if (!variants_[v].fault.empty()) continue;
      const VariantAnswers& variant = answers_.variants[v];
      const Answer& answer = variant.answers[question];
      rows.push_back(settings(v));
      rows.back().push_back(fmt::format("{}", variant.runs));
      rows.back().push_back(fmt::format("{:.1f} %", 100 * variant.rejected_share()));
      const bool known = answer.there && answer.mean.count > 0;
      rows.back().push_back(known ? shown(question, answer.mean.mean, v) : "-");
      const double half = answer.mean.interval ? answer.mean.interval->width() / 2 : std::nan("");
      rows.back().push_back(
          value_text(moment ? Unit::seconds : unit_of(asked.asked), half, variants_[v]));
      for (std::size_t i = 0; i < std::size(kQuantiles); ++i) {
        rows.back().push_back(answer.there ? shown(question, answer.quantiles[i].value, v) : "-");
      }
    }
    add(rows, first_number);
  }

  bool any_cost() const {
    return std::any_of(variants_.begin(), variants_.end(),
                       [](const VariantRuns& each) { return each.costed; });
  }

  void faults() {
    std::size_t told = 0;
    for (std::size_t v = 0; v < variants_.size(); ++v) {
      if (variants_[v].fault.empty()) continue;
      if (told++ == 0) text_ += "\n";
      if (is_cut() && told > kShownFaults) continue;
      line("variant {} ({}) cannot run: {}", v + 1, settings_text(variants_[v].set),
           variants_[v].fault);
    }
    if (is_cut() && told > kShownFaults) line("and {} more cannot run", told - kShownFaults);
  }

  void rejections() {
    bool first = true;
    for (const std::size_t v : shown_) {
      std::size_t others = 0;
      for (const TaskRejection& each : answers_.variants[v].rejections) {
        if (each.reason.empty()) {
          ++others;  // after another in the same run
          continue;
        }
        if (first) text_ += "\nrejected\n";
        first = false;
        if (study_.sampled) {
          line("  variant {}: {} in {} of {} runs; in run {}: {}", v + 1, each.task, each.runs,
               answers_.variants[v].runs, each.first_run, each.reason);
        } else {
          line("  variant {}: {}: {}", v + 1, each.task, each.reason);
        }
      }
      if (others > 0)
        line("  variant {}: and {} more task{}", v + 1, others, others == 1 ? "" : "s");
    }
  }

  /// What drives the time of the variant that was chosen, or of the first that runs.
  void drivers() {
    std::size_t shown = variants_.size();
    if (answers_.choice && answers_.choice->chosen) shown = *answers_.choice->chosen;
    for (const std::size_t v : shown_) {
      if (shown == variants_.size() && answers_.variants[v].runs > answers_.variants[v].unfinished)
        shown = v;
    }
    if (!study_.sampled || shown == variants_.size()) return;
    const VariantAnswers& variant = answers_.variants[shown];
    if (!variant.critical.empty()) {
      text_ += fmt::format("\ncritical in most runs of variant {}\n", shown + 1);
      std::vector<report::TableRow> rows{{"task", "share of runs"}};
      for (std::size_t i = 0; i < std::min(kShownTasks, variant.critical.size()); ++i) {
        rows.push_back(
            {variant.critical[i].task, fmt::format("{:.1f} %", 100 * variant.critical[i].share)});
      }
      text_ += report::columns(rows, {1});
    }
    if (variant.drivers.empty()) return;
    text_ += fmt::format(
        "\nwhat drives the makespan of variant {}: mean where the duration was in its lowest "
        "and highest tenth\n",
        shown + 1);
    std::vector<report::TableRow> rows{{"duration", "correlation", "lowest", "highest"}};
    for (std::size_t i = 0; i < std::min(kShownDrivers, variant.drivers.size()); ++i) {
      const Driver& each = variant.drivers[i];
      const bool tenths = each.low > 0;
      rows.push_back({each.place, fmt::format("{:.2f}", each.correlation),
                      tenths ? value_text(Unit::seconds, each.low, variants_[shown]) : "-",
                      tenths ? value_text(Unit::seconds, each.high, variants_[shown]) : "-"});
    }
    text_ += report::columns(rows, {1, 2, 3});
  }

  void pareto() {
    if (answers_.pareto.empty() || variants_.size() < 2) return;
    std::vector<std::size_t> front;
    for (const std::size_t v : answers_.pareto) front.push_back(v + 1);
    line("\nno other is both faster and cheaper on average than variant{} {}",
         front.size() == 1 ? "" : "s", fmt::join(front, ", "));
  }

  void choice() {
    if (!answers_.choice) return;
    const ChoiceAnswer& choice = *answers_.choice;
    const Choice& rule = *study_.choice;
    std::string asked = fmt::format("{} {}", rule.least ? "least" : "most", rule.statistic.text);
    for (std::size_t i = 0; i < rule.with.size(); ++i) {
      asked += (i == 0 ? " with " : ", ") + rule.with[i].text;
    }
    if (!choice.chosen) {
      line("\nchosen: none ({})", asked);
    } else {
      const auto found =
          std::find_if(choice.judged.begin(), choice.judged.end(),
                       [&](const auto& each) { return each.variant == *choice.chosen; });
      line("\nchosen: variant {} ({}): {} {}; {}", *choice.chosen + 1,
           settings_text(variants_[*choice.chosen].set), rule.statistic.text,
           value_text(study_, rule.statistic, found->value, variants_[*choice.chosen]), asked);
      if (choice.equal.size() > 1) {
        std::vector<std::size_t> equal;
        for (const std::size_t v : choice.equal) {
          if (v != *choice.chosen) equal.push_back(v + 1);
        }
        line("as good, as far as these runs can tell: variant{} {}", equal.size() == 1 ? "" : "s",
             fmt::join(equal, ", "));
      }
    }
    for (std::size_t i = 0; i < std::min(kShownPassed, choice.passed.size()); ++i) {
      line("passed over: variant {}: {}", choice.passed[i].variant + 1, choice.passed[i].why);
    }
    if (choice.passed.size() > kShownPassed) {
      line("passed over: {} more", choice.passed.size() - kShownPassed);
    }
  }

  const StudyModel& study_;
  const std::vector<VariantRuns>& variants_;
  const StudyAnswers& answers_;
  std::vector<std::size_t> shown_;  ///< variants, in the order of the table
  std::string text_;
};

}  // namespace

std::string study_table(const StudyModel& study, const std::vector<VariantRuns>& variants,
                        const StudyAnswers& answers) {
  return Table(study, variants, answers).text();
}

}  // namespace rubicon::study
