#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "interpreter/syntax/name_suggestion.hpp"
#include "src/studies/study/study_model.hpp"

namespace rubicon::study {

namespace {

using interpreter::Diagnostic;
using interpreter::Diagnostics;

constexpr std::size_t kMostValues = 10'000;

struct AskedName {
  const char* name;
  Asked asked;
  const char* argument;  ///< what stands in its parentheses; null: nothing
};
constexpr std::array kAskedNames = {
    AskedName{"makespan", Asked::makespan, nullptr},
    AskedName{"cost", Asked::cost, nullptr},
    AskedName{"rejected", Asked::rejected, nullptr},
    AskedName{"finish", Asked::finish, "a task"},
    AskedName{"start", Asked::task_start, "a task"},
    AskedName{"duration", Asked::task_duration, "a task"},
    AskedName{"production", Asked::production, "a task that digs"},
    AskedName{"unit_cost", Asked::unit_cost, "a task that digs"},
    AskedName{"utilisation", Asked::utilisation, "a robot or crew"},
    AskedName{"waiting", Asked::waiting, "machine, resource, shift, repair or predecessor"},
    AskedName{"fuel", Asked::fuel, nullptr},
};
constexpr std::array<const char*, 5> kCauses = {"machine", "resource", "shift", "repair",
                                                "predecessor"};

std::vector<std::string> asked_names() {
  std::vector<std::string> result;
  for (const AskedName& each : kAskedNames) result.emplace_back(each.name);
  return result;
}

class Checker {
 public:
  Checker(const syntax::Study& study, Diagnostics& diagnostics)
      : study_(study), diagnostics_(diagnostics) {}

  StudyModel run() {
    model_.name = study_.name.text;
    check_plan();
    for (const Asked each : {Asked::makespan, Asked::cost, Asked::rejected}) {
      model_.questions.push_back({each, "", name_of(each), {}});
    }
    for (const syntax::VaryItem& each : study_.vary) check_variable(each);
    check_design();
    check_runs();
    check_seed();
    check_asks();
    check_choice();
    return std::move(model_);
  }

 private:
  static const char* name_of(Asked asked) {
    const auto found = std::find_if(kAskedNames.begin(), kAskedNames.end(),
                                    [&](const AskedName& each) { return each.asked == asked; });
    return found->name;
  }

  void error(const char* code, const Span& span, std::string message, std::string hint = {}) {
    Diagnostic diagnostic;
    diagnostic.code = code;
    diagnostic.span = span;
    diagnostic.message = std::move(message);
    diagnostic.hint = std::move(hint);
    diagnostics_.add(std::move(diagnostic));
  }

  /// The only one of some items; a second is an error.
  template <typename Items>
  const typename Items::value_type* only(const Items& items, const char* word) {
    if (items.size() > 1) {
      error("U01", items[1].span, fmt::format("a study says '{}' once", word));
    }
    return items.empty() ? nullptr : &items.front();
  }

  void check_plan() {
    const auto* plan = only(study_.plans, "plan");
    if (plan == nullptr) {
      error("U02", study_.name.span,
            fmt::format("study '{}' does not say which plan it runs", model_.name),
            "plan \"site.plan\";");
      return;
    }
    model_.plan = plan->file.text;
    model_.plan_span = plan->file.span;
  }

  /// column[2] is column_2.
  std::optional<std::string> plain(const syntax::QualifiedName& name) {
    const auto part = [&](const syntax::Name& each) -> std::optional<std::string> {
      std::string text = each.text;
      for (const syntax::ExpressionPtr& index : each.indices) {
        const bool number = index && index->kind == syntax::Expression::Kind::number;
        const double value = number ? index->number.value : -1;
        if (!(value >= 0) || value != std::floor(value) || value > 1e9) {
          error("U03", each.span,
                fmt::format("'{}[...]': expected a whole number in the brackets", each.text));
          return std::nullopt;
        }
        text += fmt::format("_{}", static_cast<std::int64_t>(value));
      }
      return text;
    };
    auto last = part(name.name);
    if (!last || !name.body) return last;
    const auto first = part(*name.body);
    if (!first) return std::nullopt;
    return *first + "." + *last;
  }

  // What is varied.
  void check_variable(const syntax::VaryItem& item) {
    const auto name = plain(item.name);
    if (!name) return;
    Variable variable;
    variable.name = *name;
    variable.span = item.name.span;
    for (const Variable& other : model_.variables) {
      if (other.name != variable.name) continue;
      error("U04", item.name.span, fmt::format("'{}' is varied twice", variable.name));
      return;
    }
    for (const syntax::VariedValue& each : item.values) {
      if (each.text) {
        variable.values.push_back(each.text->text);
      } else if (!each.last) {
        variable.values.push_back(each.first.text);
      } else if (!add_range(each, item.values.size() == 1, variable)) {
        return;
      }
    }
    if (variable.values.size() > kMostValues) {
      error("U05", item.span, fmt::format("'{}' has more than {} values", *name, kMostValues));
      return;
    }
    for (std::size_t i = 0; i < variable.values.size(); ++i) {
      for (std::size_t k = 0; k < i && variable.values.size() <= 100; ++k) {
        if (variable.values[i] != variable.values[k]) continue;
        error("U05", item.span,
              fmt::format("'{}' is given the value {} twice", *name, variable.values[i]));
        return;
      }
    }
    model_.variables.push_back(std::move(variable));
  }

  bool add_range(const syntax::VariedValue& value, bool alone, Variable& variable) {
    const syntax::Literal& first = value.first;
    const syntax::Literal& last = *value.last;
    const std::string& unit = first.number.unit_text;
    if (last.number.unit_text != unit || (value.step && value.step->number.unit_text != unit)) {
      error("U05", value.span, "the numbers of a range have the same unit",
            fmt::format("such as 30 m to 50 m by 5 m"));
      return false;
    }
    if (!(last.written > first.written)) {
      error("U05", value.span,
            fmt::format("the range {} to {} is empty: its last value is not above its first",
                        first.text, last.text));
      return false;
    }
    const bool whole =
        first.written == std::floor(first.written) && last.written == std::floor(last.written);
    if (!value.step && alone && wants_ranges(whole && unit.empty())) {
      variable.range = Variable::Range{first.written, last.written, unit};
      return true;
    }
    if (!value.step && !(whole && unit.empty())) {
      error("U05", value.span, fmt::format("{} to {}: say in which steps", first.text, last.text),
            fmt::format("{} to {} by 0.5{}; or design latin 20; or design search 200;", first.text,
                        last.text, unit.empty() ? "" : " " + unit));
      return false;
    }
    const double step = value.step ? value.step->written : 1;
    const double count = std::floor((last.written - first.written) / step + 1e-9);
    if (!(step > 0) || !(count < static_cast<double>(kMostValues))) {
      error("U05", value.span,
            step > 0 ? fmt::format("a range of more than {} values", kMostValues)
                     : std::string("the step of a range is above 0"));
      return false;
    }
    for (int i = 0; i <= static_cast<int>(count); ++i) {
      // 0.1, 0.2, 0.3 rather than 0.30000000000000004.
      const std::string text = fmt::format("{:.12g}", first.written + i * step);
      variable.values.push_back(unit.empty() ? text : text + " " + unit);
    }
    return true;
  }

  /// Whether a range without a step is any number in it. A search takes 2 to 5 for 2, 3, 4, 5, as
  /// the other designs do.
  bool wants_ranges(bool whole) const {
    if (study_.designs.empty()) return false;
    const std::string& kind = study_.designs.front().kind.text;
    return kind == "latin" || (kind == "search" && !whole);
  }

  /// The number of variants of a design that needs it.
  std::optional<std::int64_t> count_of(const syntax::DesignItem& design, const char* what,
                                       const char* example) {
    const double count = design.count ? design.count->value : 0;
    if (count >= 2 && count == std::floor(count) && count <= static_cast<double>(kMostVariants) &&
        design.count->unit == syntax::UnitKind::none) {
      return static_cast<std::int64_t>(count);
    }
    error("U06", design.span,
          fmt::format("design {}: expected {}, 2 to {}", design.kind.text, what, kMostVariants),
          example);
    return std::nullopt;
  }

  void check_design() {
    const auto* design = only(study_.designs, "design");
    if (design != nullptr) {
      const std::string& kind = design->kind.text;
      if (kind == "latin") {
        const auto count = count_of(*design, "how many variants", "design latin 50;");
        if (!count) return;
        model_.design = Design::latin;
        model_.latin = *count;
      } else if (kind == "search") {
        const auto count = count_of(*design, "how many variants at most", "design search 200;");
        if (!count) return;
        model_.design = Design::search;
        model_.budget = *count;
        if (model_.variables.empty()) {
          error("U06", design->span, "design search: there is nothing to search among",
                "vary cranes 1, 2;");
        }
      } else if (kind == "one_at_a_time") {
        model_.design = Design::one_at_a_time;
      } else if (kind != "full") {
        error("U06", design->kind.span,
              fmt::format("unknown design '{}': full, latin, one_at_a_time or search", kind));
      }
      if (kind != "latin" && kind != "search" && design->count) {
        error("U06", design->span, fmt::format("design {} takes no number", kind));
      }
    }
    const std::size_t count = count_variants(model_);
    if (count > kMostVariants) {
      error("U06", study_.name.span,
            fmt::format("these values make more than {} variants", kMostVariants),
            "design latin 200; tries as many of them as are asked, design search 200; those "
            "that look best");
    }
  }

  // How often.
  void check_runs() {
    const auto* runs = only(study_.runs, "runs");
    if (runs == nullptr) return;
    model_.sampled = true;
    const double count = runs->count.value;
    if (!(count >= 1) || count != std::floor(count) || count > static_cast<double>(kMostRuns) ||
        runs->count.unit != syntax::UnitKind::none) {
      error("U07", runs->count.span,
            fmt::format("expected how many runs of a variant, 1 to {}", kMostRuns));
      return;
    }
    model_.most_runs = static_cast<std::int64_t>(count);
    if (runs->at_most && !runs->until) {
      error("U07", runs->span, "runs at most: say until when",
            "runs at most 500 until width(p80(finish)) < 4 h;");
    }
    if (!runs->until) return;
    if (!runs->at_most) {
      error("U07", runs->span, "a rule that ends the runs needs `at most`",
            fmt::format("runs at most {} until ...", count));
    }
    model_.until = condition(*runs->until);
    if (model_.until && !model_.until->statistic.width) {
      error("U07", runs->until->measure.span,
            fmt::format("runs end when an interval is narrow: width({})",
                        model_.until->statistic.text));
    }
  }

  void check_seed() {
    const auto* seed = only(study_.seeds, "seed");
    if (seed == nullptr) return;
    constexpr double kMost = 9'007'199'254'740'991.0;
    const double value = seed->value.value;
    if (!(value >= 0) || value != std::floor(value) || value > kMost ||
        seed->value.unit != syntax::UnitKind::none) {
      error("U08", seed->span, "expected a whole number as seed, 0 to 9007199254740991");
      return;
    }
    model_.seed = static_cast<std::uint64_t>(value);
  }

  // What is asked.
  void check_asks() {
    if (study_.asks.empty()) {
      model_.asked = {0, 1, 2};
      return;
    }
    for (const syntax::Measure& each : study_.asks) {
      const auto question = question_of(each, 0);
      if (!question) continue;
      const int index = model_.question(*question);
      if (std::find(model_.asked.begin(), model_.asked.end(), index) == model_.asked.end()) {
        model_.asked.push_back(index);
      }
    }
  }

  /// The question whose word is `at`.
  std::optional<Question> question_of(const syntax::Measure& measure, std::size_t at) {
    if (at >= measure.words.size()) {
      error("U09", measure.span, "expected what is asked in the parentheses",
            "such as p80(finish)");
      return std::nullopt;
    }
    const std::string name = measure.words[at].text();
    const auto known = std::find_if(kAskedNames.begin(), kAskedNames.end(),
                                    [&](const AskedName& each) { return name == each.name; });
    if (known == kAskedNames.end()) {
      const std::string near = interpreter::did_you_mean(name, asked_names());
      if (name == "mean" || name == "width" || percentile(name)) {
        error("U09", measure.words[at].span,
              fmt::format("'{}' does not belong here: every answer has its mean and its quantiles",
                          name),
              "ask makespan, finish;");
        return std::nullopt;
      }
      error("U09", measure.words[at].span,
            fmt::format("unknown '{}'{}", name, near.empty() ? "" : "; did you mean " + near + "?"),
            fmt::format("a study asks for {}", fmt::join(asked_names(), ", ")));
      return std::nullopt;
    }
    Question question{known->asked, "", name, measure.words[at].span};
    if (at + 1 == measure.words.size()) {
      if (known->argument == nullptr || known->asked == Asked::waiting ||
          known->asked == Asked::finish) {
        return question;
      }
      error("U09", measure.words[at].span,
            fmt::format("{}: expected {} in parentheses", name, known->argument));
      return std::nullopt;
    }
    if (known->argument == nullptr || at + 2 != measure.words.size()) {
      const std::size_t wrong = known->argument == nullptr ? at + 1 : at + 2;
      error("U09", measure.words[wrong].span,
            fmt::format("'{}' does not belong here", measure.words[wrong].text()));
      return std::nullopt;
    }
    const auto of = plain(measure.words[at + 1]);
    if (!of) return std::nullopt;
    question.of = *of;
    question.span = measure.words[at + 1].span;
    question.text = fmt::format("{}({})", name, *of);
    if (question.asked == Asked::finish) question.asked = Asked::task_finish;
    if (question.asked == Asked::waiting &&
        std::find(kCauses.begin(), kCauses.end(), question.of) == kCauses.end()) {
      error("U09", question.span,
            fmt::format("waiting({}): expected {}", question.of, known->argument));
      return std::nullopt;
    }
    return question;
  }

  std::optional<Statistic> statistic(const syntax::Measure& measure) {
    Statistic result;
    result.span = measure.span;
    std::size_t at = 0;
    std::string closing;
    if (measure.words[0].text() == "width") {
      result.width = true;
      at = 1;
    }
    bool summed = false;
    if (at < measure.words.size()) {
      const std::string word = measure.words[at].text();
      if (word == "mean") {
        summed = true;
        ++at;
      } else if (const auto share = percentile(word)) {
        if (!(*share > 0 && *share < 1)) {
          error("U09", measure.words[at].span, "expected a quantile from p1 to p99");
          return std::nullopt;
        }
        result.quantile = *share;
        summed = true;
        ++at;
      }
    }
    const auto question = question_of(measure, at);
    if (!question) return std::nullopt;
    if (!summed && question->asked != Asked::rejected) {
      error("U09", measure.span,
            fmt::format("{}: say which number of many runs, such as mean({}) or p80({})",
                        question->text, question->text, question->text));
      return std::nullopt;
    }
    if (question->asked == Asked::rejected && result.quantile) {
      error("U09", measure.span, "rejected is a share of the runs: it has a mean only");
      return std::nullopt;
    }
    result.question = model_.question(*question);
    result.text =
        summed
            ? fmt::format("{}({})",
                          result.quantile ? fmt::format("p{:g}", *result.quantile * 100) : "mean",
                          question->text)
            : question->text;
    if (result.width) result.text = fmt::format("width({})", result.text);
    return result;
  }

  /// 0.8 of "p80".
  static std::optional<double> percentile(const std::string& word) {
    if (word.size() < 2 || word.size() > 3 || word[0] != 'p') return std::nullopt;
    int value = 0;
    for (const char c : word.substr(1)) {
      if (c < '0' || c > '9') return std::nullopt;
      value = 10 * value + (c - '0');
    }
    return value / 100.0;
  }

  std::optional<Condition> condition(const syntax::Limit& limit) {
    auto measured = statistic(limit.measure);
    if (!measured) return std::nullopt;
    Condition result;
    result.statistic = *measured;
    using Comparison = Condition::Comparison;
    const std::string& sign = limit.comparison.text;
    result.comparison = sign.starts_with("<=")   ? Comparison::less_equal
                        : sign.starts_with(">=") ? Comparison::greater_equal
                        : sign.starts_with("<")  ? Comparison::less
                                                 : Comparison::greater;
    const Unit unit = unit_of(model_.questions[static_cast<std::size_t>(measured->question)].asked);
    if (limit.text) {
      if (unit != Unit::moment || measured->width) {
        error("U10", limit.text->span,
              fmt::format("{} is no moment: expected a number", measured->text));
        return std::nullopt;
      }
      result.date = moment(limit.text->text);
      if (!result.date) {
        error("U10", limit.text->span,
              fmt::format("expected a date and time, found \"{}\"", limit.text->text),
              "\"2026-03-27 16:00\", or \"2026-03-27\" for the end of that day");
        return std::nullopt;
      }
    } else {
      result.limit = limit.number.number.value;
      const bool time = limit.number.number.unit == syntax::UnitKind::time;
      const bool bare = limit.number.number.unit == syntax::UnitKind::none;
      const bool wants_time = unit == Unit::seconds || unit == Unit::moment;
      if (wants_time ? !time : !bare) {
        error("U10", limit.number.number.span,
              wants_time ? fmt::format("{}: expected a time, such as 4 h", measured->text)
                         : fmt::format("{}: expected a number without a unit", measured->text));
        return std::nullopt;
      }
    }
    result.text = fmt::format("{} {} {}", measured->text, trimmed(sign),
                              limit.text ? limit.text->text : limit.number.text);
    return result;
  }

  static std::string trimmed(std::string text) {
    while (!text.empty() && text.back() == ' ') text.pop_back();
    return text;
  }

  /// A date alone is the end of that day.
  static std::optional<schedule::CivilTime> moment(const std::string& text) {
    if (const auto time = schedule::parse_civil_time(text)) return time;
    const auto date = schedule::parse_date(text);
    if (!date) return std::nullopt;
    return schedule::CivilTime{schedule::date_from_days(schedule::days_from_date(*date) + 1), 0};
  }

  void check_choice() {
    const auto* choose = only(study_.chooses, "choose");
    if (choose == nullptr) return;
    Choice choice;
    if (choose->direction.text != "least" && choose->direction.text != "most") {
      error("U09", choose->direction.span,
            fmt::format("expected least or most, found '{}'", choose->direction.text));
      return;
    }
    choice.least = choose->direction.text == "least";
    const auto measured = statistic(choose->measure);
    if (!measured) return;
    choice.statistic = *measured;
    for (const syntax::Limit& each : choose->with) {
      auto limit = condition(each);
      if (limit) choice.with.push_back(std::move(*limit));
    }
    model_.choice = std::move(choice);
  }

  const syntax::Study& study_;
  Diagnostics& diagnostics_;
  StudyModel model_;
};

}  // namespace

Unit unit_of(Asked asked) {
  switch (asked) {
    case Asked::cost:
      return Unit::money;
    case Asked::rejected:
    case Asked::utilisation:
      return Unit::share;
    case Asked::finish:
    case Asked::task_start:
    case Asked::task_finish:
      return Unit::moment;
    case Asked::production:
    case Asked::unit_cost:
    case Asked::fuel:
      return Unit::number;
    case Asked::makespan:
    case Asked::waiting:
    case Asked::task_duration:
      break;
  }
  return Unit::seconds;
}

bool Condition::holds(double value, double against) const {
  switch (comparison) {
    case Comparison::less:
      return value < against;
    case Comparison::less_equal:
      return value <= against;
    case Comparison::greater:
      return value > against;
    case Comparison::greater_equal:
      break;
  }
  return value >= against;
}

int StudyModel::question(const Question& wanted) {
  const auto known = std::find(questions.begin(), questions.end(), wanted);
  if (known != questions.end()) return static_cast<int>(known - questions.begin());
  questions.push_back(wanted);
  return static_cast<int>(questions.size()) - 1;
}

std::unique_ptr<StudyModel> check_study(const syntax::Study& study, Diagnostics& diagnostics) {
  if (study.broken) return nullptr;
  const int before = diagnostics.errors();
  auto model = std::make_unique<StudyModel>(Checker(study, diagnostics).run());
  return diagnostics.errors() == before ? std::move(model) : nullptr;
}

}  // namespace rubicon::study
