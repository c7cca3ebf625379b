#include "src/results/verify/schedule/check_durations.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace rubicon::verify {

namespace {

/// What a law allows, s.
struct LawRange {
  double least = 0;
  double most = std::numeric_limits<double>::infinity();
  double mean = 0;
};

LawRange law_range_of(const SceneWork& work) {
  const std::vector<double>& v = work.values;
  if (work.law == "uniform" && v.size() == 2) return {v[0], v[1], (v[0] + v[1]) / 2};
  if (work.law == "triangular" && v.size() == 3) return {v[0], v[2], (v[0] + v[1] + v[2]) / 3};
  if (work.law == "pert" && v.size() == 3) return {v[0], v[2], (v[0] + 4 * v[1] + v[2]) / 6};
  if (work.law == "normal" && v.size() == 2) return {0, 2 * v[0], v[0]};
  const double infinity = std::numeric_limits<double>::infinity();
  return {0, infinity, v.empty() ? 0 : v[0]};
}

}  // namespace

void check_durations(const Trace& trace, Faults& faults) {
  // Durations are rounded to ns.
  constexpr double kRounding = 1e-9;
  const auto check = [&](const SceneTask& task, const SceneWork& work) {
    if (work.law.empty()) return;
    const LawRange range = law_range_of(work);
    const double time = static_cast<double>(work.time) / static_cast<double>(kSecond);
    const double slack = kRounding * std::fmax(1, time);
    const bool fits = trace.scene.sampled
                          ? time >= range.least - slack && time <= range.most + slack
                          : std::fabs(time - range.mean) <= slack;
    if (fits) return;
    faults.push_back(
        {FaultKind::schedule, ResultFile::trace, 1, task.name, -1,
         trace.scene.sampled
             ? fmt::format("{} takes {:g} s, which {} does not allow", work.what, time, work.law)
             : fmt::format("{} takes {:g} s, and the mean of its {} is {:g} s", work.what, time,
                           work.law, range.mean)});
  };
  for (const SceneTask& task : trace.scene.tasks) {
    for (const auto* work : {&task.hook, &task.adjust, &task.release}) {
      if (*work) check(task, **work);
    }
    for (const SceneWork& work : task.takes) check(task, work);
  }
}

}  // namespace rubicon::verify
