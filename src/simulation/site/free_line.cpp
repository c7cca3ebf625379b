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
  const double share = this->share(q);
  if (!(share >= -kRounding && share <= 1 + kRounding)) return false;
  for (std::size_t i = 0; i < way_.size(); ++i) {
    const bool on_line =
        way_[i] == 0 ? q[i] == q_from_[i] : is_near(q[i], q_from_[i] + share * way_[i]);
    if (!on_line) return false;
  }
  return true;
}

bool FreeLine::covers(std::span<const double> q_from, std::span<const double> q_to,
                      std::uint64_t version) {
  const bool on_line = !way_.empty() && version == version_ && has(q_from) && has(q_to);
  is_used_ = is_used_ || on_line;
  return on_line;
}

/// Whether the step goes on where the last one ended, by the same amount. Steps on a line are not
/// told of: the next one after them goes on, too.
bool FreeLine::goes_on(std::span<const double> q_from, std::span<const double> q_to) const {
  if (last_from_.size() != q_from.size()) return false;
  const bool from_line = !way_.empty() && has(q_from);
  for (std::size_t i = 0; i < q_from.size(); ++i) {
    const double last = last_to_[i] - last_from_[i];
    if (std::fabs(q_to[i] - q_from[i] - last) > kSameStep * std::fabs(last)) return false;
    if (!from_line && !is_near(q_from[i], last_to_[i])) return false;
  }
  return true;
}

std::vector<double> FreeLine::ahead(const robot::RobotModel& model, std::span<const double> q_from,
                                    std::span<const double> q_to) {
  const std::size_t count = q_from.size();
  const bool same_again =
      std::equal(q_from.begin(), q_from.end(), last_from_.begin(), last_from_.end()) &&
      std::equal(q_to.begin(), q_to.end(), last_to_.begin(), last_to_.end());
  if (same_again) return {};
  const bool in_run = goes_on(q_from, q_to);
  if (in_run || is_used_) is_eager_ = true;
  if (!in_run && is_first_ && !is_used_) is_eager_ = false;
  is_first_ = !in_run;
  is_used_ = false;
  last_from_.assign(q_from.begin(), q_from.end());
  last_to_.assign(q_to.begin(), q_to.end());
  if (!in_run) {
    pause_ = 0;
    steps_ = std::max(steps_, kFirstSteps);
    if (!is_eager_) return {};
  }
  if (pause_ > 0) {
    --pause_;
    return {};
  }
  int steps = steps_;
  bool moves = false;
  for (std::size_t i = 0; i < count; ++i) {
    const double step = q_to[i] - q_from[i];
    if (step == 0) continue;
    moves = true;
    const robot::Parameter& parameter = model.parameters[i];
    if (parameter.cyclic) continue;
    const double room = (step > 0 ? parameter.upper : parameter.lower) - q_from[i];
    if (!(room / step > steps)) steps = static_cast<int>(std::max(room / step, 0.0));
  }
  if (!moves || steps < kFewestSteps) return {};
  std::vector<double> q_end(q_from.begin(), q_from.end());
  for (std::size_t i = 0; i < count; ++i) q_end[i] += steps * (q_to[i] - q_from[i]);
  return q_end;
}

void FreeLine::found_free(std::span<const double> q_from, std::vector<double> q_end,
                          std::uint64_t version) {
  q_from_.assign(q_from.begin(), q_from.end());
  way_ = std::move(q_end);
  longest_ = 0;
  for (std::size_t i = 0; i < way_.size(); ++i) {
    way_[i] -= q_from_[i];
    if (std::fabs(way_[i]) > std::fabs(way_[longest_])) longest_ = i;
  }
  version_ = version;
  steps_ = std::min(2 * steps_, kMostSteps);
}

void FreeLine::found_blocked() {
  steps_ /= 2;
  if (steps_ >= kFewestSteps) return;
  steps_ = kFewestSteps;
  pause_ = kPause;
}

}  // namespace rubicon::site
