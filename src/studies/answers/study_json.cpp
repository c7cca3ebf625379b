#include <cmath>

#include "src/simulation/trace/json_builder.hpp"
#include "src/studies/answers/study_text.hpp"
#include "src/studies/answers/value_text.hpp"

namespace rubicon::study {

namespace {

const char* name_of(Unit unit) {
  switch (unit) {
    case Unit::moment:
      return "moment";
    case Unit::money:
      return "money";
    case Unit::number:
      return "number";
    case Unit::share:
      return "share";
    case Unit::seconds:
      break;
  }
  return "s";
}

const char* name_of(Design design) {
  switch (design) {
    case Design::latin:
      return "latin";
    case Design::search:
      return "search";
    case Design::one_at_a_time:
      return "one_at_a_time";
    case Design::full:
      break;
  }
  return "full";
}

class Json {
 public:
  Json(const StudyModel& study, const std::vector<VariantRuns>& variants,
       const StudyAnswers& answers)
      : study_(study), variants_(variants), answers_(answers) {}

  std::string text() {
    json_.begin_object().field("study", study_.name).field("plan", study_.plan);
    json_.field("design", name_of(study_.design)).field("sampled", study_.sampled);
    json_.field("runs", study_.most_runs);
    if (study_.until) json_.field("until", study_.until->text);
    if (study_.sampled) json_.field("seed", static_cast<std::int64_t>(study_.seed));
    json_.key("questions").begin_array();
    for (const Question& each : study_.questions) {
      json_.begin_object().field("text", each.text);
      json_.field("unit", name_of(unit_of(each.asked))).end_object();
    }
    json_.end_array().key("asked").begin_array();
    for (const int each : study_.asked) json_.value(each);
    json_.end_array().key("parameters").begin_array();
    for (const Variable& each : study_.variables) json_.value(each.name);
    json_.end_array().key("variants").begin_array();
    for (std::size_t v = 0; v < variants_.size(); ++v) variant(v);
    json_.end_array().key("pareto").begin_array();
    for (const std::size_t v : answers_.pareto) json_.value(static_cast<std::int64_t>(v + 1));
    json_.end_array();
    if (answers_.choice) choice(*answers_.choice);
    if (!answers_.kept.empty()) kept();
    return json_.end_object().take() + "\n";
  }

 private:
  void interval(const char* name, const statistics::Interval& interval) {
    json_.key(name).begin_array().value(interval.low).value(interval.high).end_array();
  }

  /// What is not finite is null: never in `value`, not known in intervals.
  void answer(const Answer& answer) {
    json_.begin_object();
    if (answer.there) {
      json_.field("finished", static_cast<std::int64_t>(answer.mean.count));
      if (answer.mean.count > 0) {
        json_.field("mean", answer.mean.mean);
        if (answer.mean.interval) {
          interval("mean_interval", *answer.mean.interval);
          json_.field("deviation", answer.mean.deviation);
        }
        json_.field("least", answer.least).field("most", answer.most);
      }
      json_.key("quantiles").begin_array();
      for (const QuantileAnswer& each : answer.quantiles) {
        json_.begin_object().field("p", each.p).field("value", each.value);
        interval("interval", each.interval);
        json_.field("run", each.run).end_object();
      }
      json_.end_array();
      if (answer.difference.count > 0) {
        json_.key("difference").begin_object().field("mean", answer.difference.mean);
        if (answer.difference.interval) interval("interval", *answer.difference.interval);
        json_.field("runs", static_cast<std::int64_t>(answer.difference.count)).end_object();
      }
    }
    json_.end_object();
  }

  void variant(std::size_t v) {
    const VariantRuns& runs = variants_[v];
    const VariantAnswers& each = answers_.variants[v];
    json_.begin_object().field("variant", static_cast<std::int64_t>(v + 1));
    json_.key("set").begin_object();
    for (const auto& [name, value] : runs.set) json_.field(name, value);
    json_.end_object();
    if (!runs.fault.empty()) {
      json_.field("fault", runs.fault).end_object();
      return;
    }
    json_.field("again", run_command(study_, runs, 0));
    if (runs.start_at) json_.field("start_at", schedule::text_of(*runs.start_at));
    if (!runs.currency.empty()) json_.field("currency", runs.currency);
    json_.field("runs", each.runs).field("unfinished", each.unfinished);
    json_.key("answers").begin_array();
    for (const Answer& one : each.answers) answer(one);
    json_.end_array().key("critical").begin_array();
    for (const TaskShare& one : each.critical) {
      json_.begin_object().field("task", one.task).field("runs", one.runs).end_object();
    }
    json_.end_array().key("drivers").begin_array();
    for (const Driver& one : each.drivers) {
      json_.begin_object().field("duration", one.place).field("correlation", one.correlation);
      if (one.low > 0) json_.field("low", one.low).field("high", one.high);
      json_.end_object();
    }
    json_.end_array().key("rejected").begin_array();
    for (const TaskRejection& one : each.rejections) {
      json_.begin_object().field("task", one.task).field("runs", one.runs);
      json_.field("first_run", one.first_run);
      if (!one.reason.empty()) json_.field("reason", one.reason);
      json_.end_object();
    }
    json_.end_array();
    if (each.progress) progress(*each.progress);
    json_.key("histogram").begin_array();
    for (const std::int64_t count : each.histogram) json_.value(count);
    json_.end_array().end_object();
  }

  void progress(const ProgressBand& band) {
    json_.key("progress").begin_object();
    const auto list = [&](const char* name, const std::vector<double>& times) {
      json_.key(name).begin_array();
      for (const double time : times) json_.value(time);
      json_.end_array();
    };
    list("p10", band.p10);
    list("p50", band.p50);
    list("p90", band.p90);
    json_.end_object();
  }

  void choice(const ChoiceAnswer& choice) {
    json_.key("choice").begin_object();
    json_.field("direction", study_.choice->least ? "least" : "most");
    json_.field("statistic", study_.choice->statistic.text).key("with").begin_array();
    for (const Condition& each : study_.choice->with) json_.value(each.text);
    json_.end_array();
    if (choice.chosen) json_.field("chosen", static_cast<std::int64_t>(*choice.chosen + 1));
    json_.key("equal").begin_array();
    for (const std::size_t v : choice.equal) json_.value(static_cast<std::int64_t>(v + 1));
    json_.end_array().key("judged").begin_array();
    for (const auto& each : choice.judged) {
      json_.begin_object().field("variant", static_cast<std::int64_t>(each.variant + 1));
      json_.field("value", each.value);
      if (each.interval) interval("difference_interval", *each.interval);
      json_.end_object();
    }
    json_.end_array().key("passed_over").begin_array();
    for (const auto& each : choice.passed) {
      json_.begin_object().field("variant", static_cast<std::int64_t>(each.variant + 1));
      json_.field("why", each.why).end_object();
    }
    json_.end_array().end_object();
  }

  void kept() {
    json_.key("films").begin_array();
    for (const KeptRun& each : answers_.kept) {
      json_.begin_object().field("variant", static_cast<std::int64_t>(each.variant + 1));
      json_.field("run", each.run).field("folder", each.folder).end_object();
    }
    json_.end_array();
  }

  const StudyModel& study_;
  const std::vector<VariantRuns>& variants_;
  const StudyAnswers& answers_;
  trace::JsonBuilder json_;
};

}  // namespace

std::string study_json(const StudyModel& study, const std::vector<VariantRuns>& variants,
                       const StudyAnswers& answers) {
  return Json(study, variants, answers).text();
}

}  // namespace rubicon::study
