#include "src/results/film/key_filter.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace rubicon::film {

KeyColumns::KeyColumns(std::size_t parameters)
    : t_(kMillionth, true), q_(parameters, Column(kMillionth, true)) {}

void KeyColumns::add(const Key& key) {
  t_.add(key.t);
  for (std::size_t i = 0; i < q_.size(); ++i) q_[i].add(key.q[i]);
}

void KeyColumns::add(const KeyColumns& more) {
  t_.add(more.t_);
  for (std::size_t i = 0; i < q_.size(); ++i) q_[i].add(more.q_[i]);
}

KeyFilter::KeyFilter(Key first)
    : first_(std::move(first)),
      anchor_(first_),
      last_(first_),
      slopes_(first_.q.size()),
      kept_(first_.q.size()) {
  open_slopes();
}

void KeyFilter::add(const Key& key) {
  if (key == last_) return;
  if (key.t == last_.t) {
    // Of a chain of jumps at one moment only its two ends are seen.
    if (!last_is_jump_) keep_last();
    last_is_jump_ = true;
    last_ = key;
    last_is_kept_ = false;
    anchor_ = key;
    open_slopes();
    return;
  }
  if (last_is_jump_ || !on_the_line(key)) {
    keep_last();
    anchor_ = last_;
    open_slopes();
  }
  narrow(key);
  last_ = key;
  last_is_kept_ = last_is_jump_ = false;
}

void KeyFilter::finish() { keep_last(); }

void KeyFilter::keep_last() {
  if (!last_is_kept_) kept_.add(last_);
  last_is_kept_ = true;
}

void KeyFilter::open_slopes() {
  constexpr double kAny = std::numeric_limits<double>::infinity();
  std::fill(slopes_.begin(), slopes_.end(), Slopes{-kAny, kAny});
}

bool KeyFilter::on_the_line(const Key& key) const {
  const double time = static_cast<double>(key.t - anchor_.t);
  for (std::size_t i = 0; i < slopes_.size(); ++i) {
    const double slope = static_cast<double>(key.q[i] - anchor_.q[i]) / time;
    if (slope < slopes_[i].lower || slope > slopes_[i].upper) return false;
  }
  return true;
}

void KeyFilter::narrow(const Key& key) {
  const double time = static_cast<double>(key.t - anchor_.t);
  for (std::size_t i = 0; i < slopes_.size(); ++i) {
    const double way = static_cast<double>(key.q[i] - anchor_.q[i]);
    slopes_[i].lower = std::max(slopes_[i].lower, (way - kOffTheLine) / time);
    slopes_[i].upper = std::min(slopes_[i].upper, (way + kOffTheLine) / time);
  }
}

}  // namespace rubicon::film
