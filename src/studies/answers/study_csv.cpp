#include <fmt/format.h>

#include <cmath>

#include "src/results/report/columns.hpp"
#include "src/studies/answers/study_text.hpp"

namespace rubicon::study {

namespace {

using report::csv_field;

std::string number(double value) {
  if (std::isnan(value)) return {};
  if (std::isinf(value)) return value > 0 ? "never" : "";
  return fmt::format("{}", value == 0 ? 0.0 : value);
}

std::string settings_header(const std::vector<VariantRuns>& variants) {
  std::string text;
  if (variants.empty()) return text;
  for (const auto& [name, value] : variants.front().set) text += "," + csv_field(name);
  return text;
}

std::string settings(const VariantRuns& variant) {
  std::string text;
  for (const auto& [name, value] : variant.set) text += "," + csv_field(value);
  return text;
}

}  // namespace

std::string variants_csv(const StudyModel& study, const std::vector<VariantRuns>& variants,
                         const StudyAnswers& answers) {
  std::string text = "variant" + settings_header(variants) + ",runs,unfinished,fault";
  for (const Question& question : study.questions) {
    if (question.asked == Asked::rejected) continue;
    for (const char* what : {"mean", "mean_low", "mean_high", "deviation", "least", "most"}) {
      text += "," + csv_field(fmt::format("{} {}", question.text, what));
    }
    for (const double p : kQuantiles) {
      const std::string name = fmt::format("{} p{:g}", question.text, 100 * p);
      text +=
          "," + csv_field(name) + "," + csv_field(name + "_low") + "," + csv_field(name + "_high");
    }
    for (const char* what : {"difference", "difference_low", "difference_high"}) {
      text += "," + csv_field(fmt::format("{} {}", question.text, what));
    }
  }
  text += "\n";
  for (std::size_t v = 0; v < variants.size(); ++v) {
    const VariantAnswers& each = answers.variants[v];
    text += fmt::format("{}{},{},{},{}", v + 1, settings(variants[v]), each.runs, each.unfinished,
                        csv_field(variants[v].fault));
    for (std::size_t q = 0; q < study.questions.size(); ++q) {
      if (study.questions[q].asked == Asked::rejected) continue;
      const Answer& answer = each.answers[q];
      const bool known = answer.there && answer.mean.count > 0;
      const auto mean = [&](double value) { return known ? number(value) : std::string(); };
      const auto interval = answer.mean.interval;
      text += "," + mean(answer.mean.mean) + "," + (interval ? mean(interval->low) : "") + "," +
              (interval ? mean(interval->high) : "") + "," +
              (interval ? mean(answer.mean.deviation) : "") + "," + mean(answer.least) + "," +
              mean(answer.most);
      for (std::size_t i = 0; i < std::size(kQuantiles); ++i) {
        if (!answer.there) {
          text += ",,,";
          continue;
        }
        const QuantileAnswer& quantile = answer.quantiles[i];
        text += "," + number(quantile.value) + "," + number(quantile.interval.low) + "," +
                (std::isinf(quantile.interval.high) ? "" : number(quantile.interval.high));
      }
      const statistics::Mean& difference = answer.difference;
      text += "," + (difference.count > 0 ? number(difference.mean) : "") + "," +
              (difference.interval ? number(difference.interval->low) : "") + "," +
              (difference.interval ? number(difference.interval->high) : "");
    }
    text += "\n";
  }
  return text;
}

std::string drivers_csv(const std::vector<VariantRuns>& variants, const StudyAnswers& answers) {
  std::string text = "variant" + settings_header(variants) + ",duration,correlation,low,high\n";
  for (std::size_t v = 0; v < variants.size(); ++v) {
    for (const Driver& each : answers.variants[v].drivers) {
      text += fmt::format("{}{},{},{},", v + 1, settings(variants[v]), csv_field(each.place),
                          number(each.correlation));
      text += each.low > 0 ? number(each.low) + "," + number(each.high) + "\n" : ",\n";
    }
  }
  return text;
}

std::string progress_csv(const std::vector<VariantRuns>& variants, const StudyAnswers& answers) {
  std::string text = "variant" + settings_header(variants) + ",share,p10,p50,p90\n";
  for (std::size_t v = 0; v < variants.size(); ++v) {
    const auto& band = answers.variants[v].progress;
    for (std::size_t i = 0; band && i < band->p50.size(); ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(kCurvePoints - 1);
      text += fmt::format("{}{},{},{},{},{}\n", v + 1, settings(variants[v]), number(share),
                          number(band->p10[i]), number(band->p50[i]), number(band->p90[i]));
    }
  }
  return text;
}

std::string runs_csv(const StudyModel& study, const std::vector<VariantRuns>& variants) {
  std::string text = "variant" + settings_header(variants) + ",seed,run";
  for (const Question& question : study.questions) text += "," + csv_field(question.text);
  text += "\n";
  for (std::size_t v = 0; v < variants.size(); ++v) {
    const VariantRuns& variant = variants[v];
    const std::string head = fmt::format("{}{},{}", v + 1, settings(variant),
                                         study.sampled ? fmt::format("{}", study.seed) : "");
    for (std::int64_t run = 0; run < variant.runs() && variant.fault.empty(); ++run) {
      text += head + (study.sampled ? fmt::format(",{}", run) : std::string(","));
      for (std::size_t q = 0; q < study.questions.size(); ++q) {
        const bool cost = study.questions[q].asked == Asked::cost;
        const double value = variant.values[q][static_cast<std::size_t>(run)];
        text += "," + (cost && !variant.costed ? std::string() : number(value));
      }
      text += "\n";
    }
  }
  return text;
}

}  // namespace rubicon::study
