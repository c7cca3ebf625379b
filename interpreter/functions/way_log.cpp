#include "interpreter/functions/way_log.hpp"

#include <bit>
#include <cmath>

#include "src/motion/math/angles.hpp"
#include "src/motion/robot/turns.hpp"

namespace rubicon::interpreter {

namespace {

/// m: nearer than this two points are one, and a point is on a line.
constexpr double kSamePoint = 1e-6;

/// Odd, so that no power of it is 0 modulo 2^64.
constexpr std::uint64_t kBase = 0x9e3779b97f4a7c15ull;

double bearing_of(const math::Vec3& from, const math::Vec3& to) {
  return math::atan2_deg(to.y() - from.y(), to.x() - from.x());
}

/// SplitMix64 (Steele, Lea, Flood, OOPSLA 2014) over one word after the other.
std::uint64_t mixed(std::uint64_t hash, double value) {
  std::uint64_t x = (hash + kBase) ^ std::bit_cast<std::uint64_t>(value == 0 ? 0.0 : value);
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
  return x ^ (x >> 31);
}

std::uint64_t power(std::uint64_t base, std::size_t exponent) {
  std::uint64_t result = 1;
  for (; exponent > 0; exponent >>= 1, base *= base) {
    if (exponent & 1) result *= base;
  }
  return result;
}

}  // namespace

void WayLog::clear() {
  steps_.clear();
  q_.clear();
}

/// What the step changed. Not where it led: whole turns made before must not make ways differ.
std::uint64_t WayLog::word_of(int step) const {
  std::uint64_t hash = 0;
  for (std::size_t i = 0; i < parameters_; ++i) {
    hash = mixed(hash, std::round((q(step)[i] - q(step - 1)[i]) / kSamePoint));
  }
  return hash;
}

void WayLog::begin(std::span<const double> q, const math::Vec3& p_WT, const math::Vec3& p_WG) {
  clear();
  parameters_ = q.size();
  q_.assign(q.begin(), q.end());
  steps_.push_back({p_WT.x(), p_WT.y(), bearing_of(p_WT, p_WG), 0});
}

void WayLog::add(std::span<const double> q_from, std::span<const double> q_to,
                 const math::Vec3& p_WT, const math::Vec3& p_WG) {
  const std::size_t last = q_.size() - parameters_;
  for (std::size_t i = 0; i < parameters_; ++i) q_.push_back(q_[last + i] + q_to[i] - q_from[i]);
  Step step{p_WT.x(), p_WT.y(), 0, 0};
  const double before = steps_.back().bearing;
  const bool arrived = (p_WG - p_WT).head<2>().norm() <= kSamePoint;
  const double turned = arrived ? 0 : bearing_of(p_WT, p_WG) - before;
  step.bearing = before + turned - 360 * std::floor(turned / 360 + 0.5);
  step.way = steps_.back().way;
  steps_.push_back(step);
  steps_.back().way = step.way * kBase + word_of(here());
}

bool WayLog::is_same(const robot::RobotModel& model, int a, int b) const {
  for (std::size_t i = 0; i < parameters_; ++i) {
    const robot::Parameter& p = model.parameters[i];
    const double off = robot::way_between(p, q(a)[i], q(b)[i]);
    if (std::fabs(off) > p.quantum / 2) return false;
  }
  return true;
}

bool WayLog::is_at(const robot::RobotModel& model, int place) const {
  if (!is_same(model, here(), place)) return false;
  for (int i = place + 1; i < here(); ++i) {
    if (!is_same(model, i, place)) return true;
  }
  return false;
}

double WayLog::changed(int parameter, int place) const {
  const auto i = static_cast<std::size_t>(parameter);
  return q(here())[i] - q(place)[i];
}

double WayLog::value_at(int parameter, int place) const {
  return q(place)[static_cast<std::size_t>(parameter)];
}

double WayLog::bearing_turned(int place) const { return at(here()).bearing - at(place).bearing; }

/// In the plan view, m.
double WayLog::distance(int a, int b) const {
  return math::Vec3(at(a).x - at(b).x, at(a).y - at(b).y, 0).norm();
}

/// The number of the last step after `place` that moved the tool; `place` if there is none.
int WayLog::last_move(int place) const {
  int step = here();
  while (step > place && distance(step, step - 1) <= kSamePoint) --step;
  return step;
}

bool WayLog::crossed(int place, const math::Vec3& p_WG) const {
  const int last = last_move(place);
  if (last == place) return false;
  const double from_x = at(place).x;
  const double from_y = at(place).y;
  const double length = math::Vec3(p_WG.x() - from_x, p_WG.y() - from_y, 0).norm();
  if (length <= kSamePoint) return false;
  const double along_x = (p_WG.x() - from_x) / length;
  const double along_y = (p_WG.y() - from_y) / length;
  const auto beside = [&](const Step& p) {
    const double off = along_x * (p.y - from_y) - along_y * (p.x - from_x);
    return std::fabs(off) <= kSamePoint ? 0 : off;
  };
  const auto along = [&](const Step& p) {
    return along_x * (p.x - from_x) + along_y * (p.y - from_y);
  };
  const Step& a = at(last - 1);
  const Step& b = at(last);
  const double off_a = beside(a);
  const double off_b = beside(b);
  if (off_b != 0 && !(off_a * off_b < 0)) return false;
  const double where =
      off_b == 0 ? along(b) : along(a) + (along(b) - along(a)) * off_a / (off_a - off_b);
  return where > kSamePoint && where <= length + kSamePoint;
}

int WayLog::circled(int place) const {
  const int last = last_move(place);
  const Step& now = at(last);
  if (last == place) return 0;
  const double near = distance(last, last - 1) / 2;
  // Twice the area of the loop from step k to now, grown backwards.
  double area = 0;
  for (int k = last - 1; k > place; --k) {
    const Step& a = at(k);
    const Step& b = at(k + 1);
    area += (a.x - now.x) * (b.y - now.y) - (a.y - now.y) * (b.x - now.x);
    const double x = a.x - now.x;
    const double y = a.y - now.y;
    if (x * x + y * y > (near + kSamePoint) * (near + kSamePoint)) continue;
    if (std::fabs(area) > 2 * near * near) return area > 0 ? 1 : -1;
  }
  return 0;
}

std::uint64_t WayLog::hash_since(const robot::RobotModel& model, int place) const {
  const auto steps = static_cast<std::size_t>(here() - place);
  const std::uint64_t way = at(here()).way - at(place).way * power(kBase, steps);
  return hash_values(model, place, kSamePoint) * kBase + way;
}

std::uint64_t WayLog::hash_of(const robot::RobotModel& model, int place) const {
  return hash_values(model, place, 0.5);
}

/// In so many steps of each parameter; whole turns do not count.
std::uint64_t WayLog::hash_values(const robot::RobotModel& model, int place, double share) const {
  std::uint64_t hash = 0;
  for (std::size_t i = 0; i < parameters_; ++i) {
    const robot::Parameter& p = model.parameters[i];
    const double unit = share * p.quantum;
    const double value = std::floor(q(place)[i] / unit + 0.5);
    const double turn = std::floor(360 / unit + 0.5);
    hash = mixed(hash, p.cyclic ? value - turn * std::floor(value / turn) : value);
  }
  return hash;
}

}  // namespace rubicon::interpreter
