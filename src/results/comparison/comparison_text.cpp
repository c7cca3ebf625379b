#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/results/comparison/compare_guides.hpp"
#include "src/simulation/trace/json_builder.hpp"
#include "src/studies/statistics/quantile.hpp"

namespace rubicon::comparison {

namespace {

/// The value below which a share of the sorted values lies (nearest rank); 0 of none.
double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return statistics::quantile(values, share);
}

template <typename Member>
double quantile_of(const GuideTrials& trials, double share, bool found_only, Member member) {
  std::vector<double> values;
  for (const GuideTrial& trial : trials.trials) {
    if (trial.found || !found_only) values.push_back(trial.*member);
  }
  return quantile(std::move(values), share);
}

int solved(const GuideTrials& trials) {
  return static_cast<int>(std::count_if(trials.trials.begin(), trials.trials.end(),
                                        [](const GuideTrial& trial) { return trial.found; }));
}

/// The columns of table and CSV: medians of all tries, of ways only where one was found.
struct Row {
  double nodes, checks, ms, ms_p95, roughness, length, motion_time;
};

Row row_of(const GuideTrials& trials) {
  return {quantile_of(trials, 0.5, false, &GuideTrial::nodes),
          quantile_of(trials, 0.5, false, &GuideTrial::checks),
          quantile_of(trials, 0.5, false, &GuideTrial::milliseconds),
          quantile_of(trials, 0.95, false, &GuideTrial::milliseconds),
          quantile_of(trials, 0.5, true, &GuideTrial::roughness),
          quantile_of(trials, 0.5, true, &GuideTrial::length),
          quantile_of(trials, 0.5, true, &GuideTrial::motion_time)};
}

/// The cause of the first try without a way; "" if all found one.
std::string first_cause(const GuideTrials& trials) {
  for (const GuideTrial& trial : trials.trials) {
    if (!trial.found) return trial.cause;
  }
  return {};
}

}  // namespace

std::string comparison_text(const GuideComparison& comparison) {
  std::string text;
  for (const MotionComparison& motion : comparison.motions) {
    if (!text.empty()) text += '\n';
    text += fmt::format("{}: the {} motion of {}; medians, ms also as 95th percentile\n",
                        comparison.plan, motion.motion, comparison.task);
    // Names of planners may be longer than those of kinds.
    std::size_t width = 16;
    for (const GuideTrials& trials : motion.guides) {
      width = std::max(width, guides::full_name(trials.spec).size() + 1);
    }
    text +=
        fmt::format("{:<{}}{:>9}{:>8}{:>9}{:>10}{:>10}{:>11}{:>10}{:>8}\n", "guide", width,
                    "solved", "nodes", "checks", "ms", "ms p95", "roughness", "length m", "time s");
    std::string causes;
    for (const GuideTrials& trials : motion.guides) {
      const std::string kind = guides::full_name(trials.spec);
      if (trials.trials.empty()) {
        text += fmt::format("{:<{}}{:>9}\n", kind, width, "at goal");
        continue;
      }
      const Row row = row_of(trials);
      const int found = solved(trials);
      text += fmt::format("{:<{}}{:>9}{:>8g}{:>9g}{:>10.3f}{:>10.3f}", kind, width,
                          fmt::format("{}/{}", found, trials.trials.size()), row.nodes, row.checks,
                          row.ms, row.ms_p95);
      text += found > 0 ? fmt::format("{:>11.2f}{:>10.2f}{:>8.2f}\n", row.roughness, row.length,
                                      row.motion_time)
                        : fmt::format("{:>11}{:>10}{:>8}\n", "-", "-", "-");
      const std::string cause = first_cause(trials);
      if (!cause.empty()) causes += fmt::format("  {}: {}\n", kind, cause);
    }
    if (!causes.empty()) text += "not solved, for example:\n" + causes;
  }
  return text;
}

std::string comparison_csv(const GuideComparison& comparison) {
  std::string text =
      "motion,guide,seed,found,nodes,checks,refused,ms,roughness,length,motion_time\n";
  for (const MotionComparison& motion : comparison.motions) {
    for (const GuideTrials& trials : motion.guides) {
      for (const GuideTrial& trial : trials.trials) {
        text += fmt::format("{},{},{:g},{},{:g},{:g},{:g},{:.4f},{},{},{}\n", motion.motion,
                            guides::full_name(trials.spec), trial.seed, trial.found ? 1 : 0,
                            trial.nodes, trial.checks, trial.refused, trial.milliseconds,
                            trial.roughness, trial.length, trial.motion_time);
      }
    }
  }
  return text;
}

std::string comparison_json(const GuideComparison& comparison) {
  std::string text = "{\"plan\":";
  trace::append_string(text, comparison.plan);
  text += ",\"task\":";
  trace::append_string(text, comparison.task);
  text += ",\"motions\":[";
  const char* motion_separator = "";
  for (const MotionComparison& motion : comparison.motions) {
    text += fmt::format("{}{{\"motion\":\"{}\",\"guides\":[", motion_separator, motion.motion);
    motion_separator = ",";
    const char* guide_separator = "";
    for (const GuideTrials& trials : motion.guides) {
      text += fmt::format("{}{{\"kind\":\"{}\",\"trials\":[", guide_separator,
                          guides::full_name(trials.spec));
      guide_separator = ",";
      const char* separator = "";
      for (const GuideTrial& trial : trials.trials) {
        text += fmt::format(
            "{}{{\"seed\":{:g},\"found\":{},\"nodes\":{:g},\"checks\":{:g},\"refused\":{:g},"
            "\"ms\":{:.4f},\"roughness\":{},\"length\":{},\"motion_time\":{},\"cause\":",
            separator, trial.seed, trial.found, trial.nodes, trial.checks, trial.refused,
            trial.milliseconds, trial.roughness, trial.length, trial.motion_time);
        trace::append_string(text, trial.cause);
        text += '}';
        separator = ",";
      }
      text += "]}";
    }
    text += "]}";
  }
  return text + "]}\n";
}

}  // namespace rubicon::comparison
