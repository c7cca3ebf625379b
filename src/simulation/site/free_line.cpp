#include "src/simulation/site/free_line.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rubicon::site {

namespace {

constexpr int kFirstSteps = 4;
constexpr int kMostSteps = 32;
/// Fewer steps cost more to look at than they save.
constexpr int kFewestSteps = 2;
/// Where even these were in the way of something, steps are tested alone for so long.
constexpr int kPause = 6;
/// m, degrees: rounding of a value reached in several steps. Far below what any tolerance allows.
constexpr double kRounding = 1e-11;
/// Steps whose changes differ by this share count as equal.
constexpr double kSameStep = 1e-9;

bool is_near(double a, double b) {
  return std::fabs(a - b) <= kRounding * std::max(1.0, std::fabs(b));
}

}  // namespace

bool FreeLine::has(std::span<const double> q) const {
  const double share = (q[longest_] - q_from_[longest_]) / way_[longest_];
  if (!(share >= -kRounding && share <= 1 + kRounding)) return false;
  for (std::size_t i = 0; i < way_.size(); ++i) {
    const bool on_line = way_[i] == 0 ? q[i] == q_from_[i]
                                      : is_near(q[i], q_from_[i] + share * way_[i]);
    if (!on_line) return false;
  }
  return true;
}

bool FreeLine::covers(std::span<const double> q_from, std::span<const double> q_to,
                      std::uint64_t version) const {
  return !way_.empty() && version == version_ && has(q_from) && has(q_to);
}

std::vector<double> FreeLine::ahead(const robot::RobotModel& model, std::span<const double> q_from,
                                    std::span<const double> q_to) {
  const std::size_t count = q_from.size();
  // A line that went as planned lets its steps pass unseen; the next one goes on from its end.
  bool goes_on = last_to_.size() == count && last_step_.size() == count;
  for (std::size_t i = 0; goes_on && i < count; ++i) {
    const double step = q_to[i] - q_from[i];
    goes_on = std::fabs(step - last_step_[i]) <= kSameStep * std::fabs(last_step_[i]) &&
              (is_near(q_from[i], last_to_[i]) || (!way_.empty() && has(q_from)));
  }
  last_to_.assign(q_to.begin(), q_to.end());
  last_step_.resize(count);
  for (std::size_t i = 0; i < count; ++i) last_step_[i] = q_to[i] - q_from[i];
  if (!goes_on) {
    pause_ = 0;
    steps_ = std::max(steps_, kFirstSteps);
    return {};
  }
  if (pause_ > 0) {
    --pause_;
    return {};
  }
  int steps = steps_;
  bool moves = false;
  for (std::size_t i = 0; i < count; ++i) {
    const double step = last_step_[i];
    if (step == 0) continue;
    moves = true;
    const robot::Parameter& parameter = model.parameters[i];
    if (parameter.cyclic) continue;
    const double room = (step > 0 ? parameter.upper : parameter.lower) - q_from[i];
    if (!(room / step > steps)) steps = static_cast<int>(std::max(room / step, 0.0));
  }
  if (!moves || steps < kFewestSteps) return {};
  std::vector<double> q_end(q_from.begin(), q_from.end());
  for (std::size_t i = 0; i < count; ++i) q_end[i] += steps * last_step_[i];
  return q_end;
}

void FreeLine::found_free(std::span<const double> q_from, std::vector<double> q_end,
                          std::uint64_t version, const collision::Bounds& bounds) {
  q_from_.assign(q_from.begin(), q_from.end());
  way_ = std::move(q_end);
  longest_ = 0;
  for (std::size_t i = 0; i < way_.size(); ++i) {
    way_[i] -= q_from_[i];
    if (std::fabs(way_[i]) > std::fabs(way_[longest_])) longest_ = i;
  }
  version_ = version;
  bounds_ = bounds;
  steps_ = std::min(2 * steps_, kMostSteps);
}

void FreeLine::found_blocked() {
  steps_ /= 2;
  if (steps_ >= kFewestSteps) return;
  steps_ = kFewestSteps;
  pause_ = kPause;
}

}  // namespace rubicon::site
