#include "src/results/film/column.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace rubicon::film {

namespace {

void append_varint(std::string& out, std::int64_t value) {
  std::uint64_t zigzag =
      (static_cast<std::uint64_t>(value) << 1) ^ static_cast<std::uint64_t>(value >> 63);
  for (; zigzag > 127; zigzag >>= 7) out += static_cast<char>((zigzag & 127) | 128);
  out += static_cast<char>(zigzag);
}

}  // namespace

void Column::add(std::int64_t value) {
  if (count_ == 0) {
    first_ = value;
  } else {
    append_varint(rest_, delta_ ? value - last_ : value);
  }
  last_ = value;
  ++count_;
}

void Column::add(const Column& more) {
  if (more.count_ == 0) return;
  add(more.first_);
  rest_ += more.rest_;
  last_ = more.last_;
  count_ += more.count_ - 1;
}

void Column::append_to(std::string& out) const {
  if (count_ == 0) return;
  append_varint(out, first_);
  out += rest_;
}

std::int64_t millionths(double value, const char* what) {
  // Also false for what is no number.
  if (!(std::abs(value) <= kLargestValue)) {
    throw std::invalid_argument(
        fmt::format("{} is {}: a film holds at most {:g}", what, value, kLargestValue));
  }
  return std::llround(value * 1e6);
}

std::int64_t time_millionths(double t) {
  if (!(t >= 0 && t <= kLatestTime)) {
    throw std::invalid_argument(
        fmt::format("a time is {}: a film goes from 0 to {:g}", t, kLatestTime));
  }
  return std::llround(t * 1e6);
}

}  // namespace rubicon::film
