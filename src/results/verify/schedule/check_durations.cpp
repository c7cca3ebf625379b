#include "src/results/verify/schedule/check_durations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "src/results/verify/input/read_times.hpp"

namespace rubicon::verify {

namespace {

/// What a law allows, s.
struct LawRange {
  double least = 0;
  double most = std::numeric_limits<double>::infinity();
  double mean = 0;
};

LawRange law_range_of(const Scene& scene, const SceneLaw& law) {
  if (law.times >= 0) {
    const SceneTimes& times = scene.times[static_cast<std::size_t>(law.times)];
    return {times.times.front(), times.times.back(), times.mean};
  }
  const std::vector<double>& v = law.values;
  if (law.law == "uniform" && v.size() == 2) return {v[0], v[1], (v[0] + v[1]) / 2};
  if (law.law == "triangular" && v.size() == 3) return {v[0], v[2], (v[0] + v[1] + v[2]) / 3};
  if (law.law == "pert" && v.size() == 3) return {v[0], v[2], (v[0] + 4 * v[1] + v[2]) / 6};
  if (law.law == "normal" && v.size() == 2) return {0, 2 * v[0], v[0]};
  const double infinity = std::numeric_limits<double>::infinity();
  return {0, infinity, v.empty() ? 0 : v[0]};
}

/// Durations are rounded to ns.
double slack_of(double time) { return 1e-9 * std::fmax(1, time); }

}  // namespace

bool allows(const Scene& scene, const SceneLaw& law, Ticks duration) {
  const double time = static_cast<double>(duration) / static_cast<double>(kSecond);
  const double slack = slack_of(time);
  if (law.law == "sequence") {
    return std::any_of(law.values.begin(), law.values.end(),
                       [&](double value) { return std::fabs(value - time) <= slack; });
  }
  if (law.times >= 0) return was_measured(scene.times[static_cast<std::size_t>(law.times)], time);
  const LawRange range = law_range_of(scene, law);
  return time >= range.least - slack && time <= range.most + slack;
}

void check_durations(const Trace& trace, Faults& faults) {
  const auto check = [&](const SceneTask& task, const SceneWork& work) {
    if (work.law.empty()) return;
    const SceneLaw law{work.law, work.values, work.times};
    const LawRange range = law_range_of(trace.scene, law);
    const double time = static_cast<double>(work.time) / static_cast<double>(kSecond);
    const bool fits = trace.scene.sampled ? allows(trace.scene, law, work.time)
                                          : std::fabs(time - range.mean) <= slack_of(time);
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
