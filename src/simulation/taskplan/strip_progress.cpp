#include "src/simulation/taskplan/strip_progress.hpp"

#include <algorithm>
#include <cmath>

namespace rubicon::taskplan {

namespace {

/// m: what is left of a strip at its ends when the tool is at its waypoint, by rounding or
/// `within`.
constexpr double kNearEnd = 1e-3;

}  // namespace

void StripProgress::begin(std::size_t number, const coverage::Place& from,
                          const coverage::Place& to) {
  if (number == number_) return;
  *this = {};
  number_ = number;
  from_ = from;
  length_ = std::sqrt((to.x - from.x) * (to.x - from.x) + (to.y - from.y) * (to.y - from.y));
  if (length_ > 0) direction_ = {(to.x - from.x) / length_, (to.y - from.y) / length_};
}

double StripProgress::along(const coverage::Place& place) const {
  const double gone = (place.x - from_.x) * direction_.x + (place.y - from_.y) * direction_.y;
  if (gone > length_ - kNearEnd) return length_;
  return gone < kNearEnd ? 0 : gone;
}

coverage::Place StripProgress::at(double along) const {
  return {from_.x + along * direction_.x, from_.y + along * direction_.y};
}

void StripProgress::add(const coverage::Place& from, const coverage::Place& to, std::int64_t begin,
                        std::int64_t end, std::vector<coverage::LaidStretch>& laid) {
  const double first = along(from);
  const double last = along(to);
  if (!(last > laid_)) return;
  // What the tool had passed before counts no more.
  double start = static_cast<double>(begin);
  if (laid_ > first) {
    start += static_cast<double>(end - begin) * (laid_ - first) / (last - first);
  }
  const auto start_ticks = static_cast<std::int64_t>(start + 0.5);
  if (least_ <= most_ && laid.back().end == start_ticks) {
    const double gone = last - begin_;
    const auto since = static_cast<double>(end - laid.back().begin);
    if (since / gone >= least_ && since / gone <= most_) {
      laid.back().to = at(last);
      laid.back().end = end;
      least_ = std::max(least_, (since - kEvenTicks) / gone);
      most_ = std::min(most_, (since + kEvenTicks) / gone);
      laid_ = last;
      return;
    }
  }
  laid.push_back({at(laid_), at(last), start_ticks, end});
  begin_ = laid_;
  const auto took = static_cast<double>(end - start_ticks);
  least_ = (took - kEvenTicks) / (last - begin_);
  most_ = (took + kEvenTicks) / (last - begin_);
  laid_ = last;
}

}  // namespace rubicon::taskplan
