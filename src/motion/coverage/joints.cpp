#include "src/motion/coverage/joints.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "src/motion/math/index.hpp"

namespace rubicon::coverage {
namespace {

using math::at;

/// m, and of directions: nothing.
constexpr double kNoLength = 1e-9;

Place operator+(const Place& a, const Place& b) { return {a.x + b.x, a.y + b.y}; }
Place operator-(const Place& a, const Place& b) { return {a.x - b.x, a.y - b.y}; }
Place operator*(const Place& a, double k) { return {a.x * k, a.y * k}; }
double dot(const Place& a, const Place& b) { return a.x * b.x + a.y * b.y; }
double length(const Place& a) { return std::sqrt(dot(a, a)); }

/// A stretch as a rectangle: its own axis along, u, and across, v.
struct LaidStrip {
  Place from;
  Place u, v;
  double length = 0;
  double begin = 0, end = 0;  ///< ticks

  /// When the tool passed the place of the axis nearest to p.
  double time_at(const Place& p) const {
    const double share = std::clamp(dot(p - from, u) / length, 0.0, 1.0);
    return begin + share * (end - begin);
  }
};

/// A piece of an edge, by shares of it.
struct Share {
  double low = 0;
  double high = 1;
};

/// An edge of a strip with what of it is free.
struct FreeEdge {
  int strip = 0;
  Place from, to;
  Place out;  ///< of length 1, away from the strip
  std::vector<Share> free;
  Place point(double share) const { return from + (to - from) * share; }
};

class JointFinder {
 public:
  JointFinder(const std::vector<LaidStretch>& laid, double width, std::int64_t limit)
      : half_(width / 2), limit_(static_cast<double>(limit)) {
    for (const LaidStretch& each : laid) {
      LaidStrip strip;
      strip.from = each.from;
      strip.length = length(each.to - each.from);
      if (strip.length < kNoLength) continue;
      strip.u = (each.to - each.from) * (1 / strip.length);
      strip.v = {-strip.u.y, strip.u.x};
      strip.begin = static_cast<double>(each.begin);
      strip.end = static_cast<double>(each.end);
      strips_.push_back(strip);
    }
  }

  JointFindings run() {
    if (strips_.empty()) return {};
    make_buckets();
    for (std::size_t i = 0; i < strips_.size(); ++i) {
      join_edges(static_cast<int>(i));
      add_edges(static_cast<int>(i));
    }
    merge_cold();
    return std::move(result_);
  }

 private:
  /// The box around a strip and `more` m about it.
  Box box_of_strip(const LaidStrip& strip, double more) const {
    const Place to = strip.from + strip.u * strip.length;
    const double reach = half_ * 1.5 + more;
    return {snap({std::min(strip.from.x, to.x) - reach, std::min(strip.from.y, to.y) - reach}),
            snap({std::max(strip.from.x, to.x) + reach, std::max(strip.from.y, to.y) + reach})};
  }

  void make_buckets() {
    Box all = box_of_strip(strips_.front(), 0);
    for (const LaidStrip& strip : strips_) {
      const Box box = box_of_strip(strip, kJointGap);
      all.low = {std::min(all.low.x, box.low.x), std::min(all.low.y, box.low.y)};
      all.high = {std::max(all.high.x, box.high.x), std::max(all.high.y, box.high.y)};
    }
    edges_near_.emplace(all, strips_.size() + 1);
    strips_near_.emplace(all, strips_.size() + 1);
    seen_.assign(4 * strips_.size(), -1);
  }

  /// The part of an edge that has a strip on its outer side, within kJointGap; nothing if less than
  /// a point. Ends that lie in one line have none.
  std::optional<Share> covered(const FreeEdge& edge, const LaidStrip& strip) const {
    Share span;
    const Place a = edge.from + edge.out * kJointGap - strip.from;
    const Place d = edge.to - edge.from;
    const auto clip = [&](double at, double along, double low, double high) {
      if (std::abs(along) < kNoLength) return at >= low && at <= high;
      double first = (low - at) / along;
      double second = (high - at) / along;
      if (first > second) std::swap(first, second);
      span.low = std::max(span.low, first);
      span.high = std::min(span.high, second);
      return span.low < span.high;
    };
    const bool meets = clip(dot(a, strip.u), dot(d, strip.u), 0, strip.length) &&
                       clip(dot(a, strip.v), dot(d, strip.v), -half_, half_);
    if (!meets || !(span.low < span.high)) return std::nullopt;
    return span;
  }

  /// The new strip covers free edges of those before: joints.
  void join_edges(int number) {
    const LaidStrip& strip = strips_[at(number)];
    std::vector<int> near;
    edges_near_->any_in(box_of_strip(strip, kJointGap), [&](int item) {
      if (seen_[at(item)] != number) near.push_back(item);
      seen_[at(item)] = number;
      return false;
    });
    std::sort(near.begin(), near.end());
    for (const int item : near) {
      FreeEdge& edge = edges_[at(item)];
      const auto span = covered(edge, strip);
      if (!span) continue;
      std::vector<Share> left;
      for (const Share& free : edge.free) {
        const Share joined{std::max(free.low, span->low), std::min(free.high, span->high)};
        if (!(joined.low < joined.high)) {
          left.push_back(free);
          continue;
        }
        add_joint(edge, joined, strip);
        if (free.low < joined.low) left.push_back({free.low, joined.low});
        if (joined.high < free.high) left.push_back({joined.high, free.high});
      }
      edge.free = std::move(left);
    }
  }

  /// The age grows or falls evenly from one end of the joint to the other, but for places beyond
  /// the ends of a strip, where it stands still: its corners are looked at.
  void add_joint(const FreeEdge& edge, const Share& joined, const LaidStrip& later) {
    const double whole = length(edge.to - edge.from);
    const double size = whole * (joined.high - joined.low);
    if (size < kShortestJoint) return;
    result_.joint_length += size;
    const LaidStrip& earlier = strips_[at(edge.strip)];
    std::vector<double> corners = {joined.low, joined.high};
    for (const LaidStrip* strip : {&earlier, &later}) {
      const double first = dot(edge.from - strip->from, strip->u);
      const double along = dot(edge.to - edge.from, strip->u);
      if (std::abs(along) < kNoLength) continue;
      for (const double end : {0.0, strip->length}) {
        const double share = (end - first) / along;
        if (share > joined.low && share < joined.high) corners.push_back(share);
      }
    }
    std::sort(corners.begin(), corners.end());
    const auto age = [&](double share) {
      const Place p = edge.point(share);
      return later.time_at(p) - earlier.time_at(p);
    };
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
      const double low = corners[i];
      const double high = corners[i + 1];
      take_age(age(low), edge.point(low));
      take_age(age(high), edge.point(high));
      add_cold(edge, {low, high}, age(low), age(high), later);
    }
  }

  void take_age(double age, const Place& p) {
    const auto ticks = static_cast<std::int64_t>(age + 0.5);
    if (ticks <= result_.oldest) return;
    result_.oldest = ticks;
    result_.oldest_at = p;
  }

  /// The part of an even piece that is over the limit.
  void add_cold(const FreeEdge& edge, Share piece, double first, double second,
                const LaidStrip& later) {
    if (first <= limit_ && second <= limit_) return;
    if (first <= limit_ || second <= limit_) {
      const double share =
          piece.low + (piece.high - piece.low) * (limit_ - first) / (second - first);
      (first <= limit_ ? piece.low : piece.high) = share;
    }
    const double size = length(edge.to - edge.from) * (piece.high - piece.low);
    if (!(size > 0)) return;
    result_.cold_length += size;
    const Place oldest = edge.point(first >= second ? piece.low : piece.high);
    const LaidStrip& earlier = strips_[at(edge.strip)];
    ColdJoint cold;
    cold.from = edge.point(piece.low);
    cold.to = edge.point(piece.high);
    cold.laid = static_cast<std::int64_t>(earlier.time_at(oldest) + 0.5);
    cold.joined = static_cast<std::int64_t>(later.time_at(oldest) + 0.5);
    cold.age = cold.joined - cold.laid;
    result_.cold.push_back(cold);
  }

  /// The four edges of a strip, less what lies in strips before it: that is no free edge.
  void add_edges(int number) {
    const LaidStrip& strip = strips_[at(number)];
    const Place to = strip.from + strip.u * strip.length;
    const Place side = strip.v * half_;
    const FreeEdge sides[] = {
        {number, strip.from - side, to - side, strip.v * -1.0, {{0, 1}}},
        {number, strip.from + side, to + side, strip.v, {{0, 1}}},
        {number, to - side, to + side, strip.u, {{0, 1}}},
        {number, strip.from - side, strip.from + side, strip.u * -1.0, {{0, 1}}}};
    std::vector<int> near;
    strips_near_->any_in(box_of_strip(strip, kJointGap), [&](int item) {
      near.push_back(item);
      return false;
    });
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
    for (const FreeEdge& each : sides) {
      FreeEdge edge = each;
      for (const int item : near) {
        const auto span = covered(edge, strips_[at(item)]);
        if (!span) continue;
        std::vector<Share> left;
        for (const Share& free : edge.free) {
          if (span->high <= free.low || span->low >= free.high) {
            left.push_back(free);
            continue;
          }
          if (free.low < span->low) left.push_back({free.low, span->low});
          if (span->high < free.high) left.push_back({span->high, free.high});
        }
        edge.free = std::move(left);
        if (edge.free.empty()) break;
      }
      if (edge.free.empty()) continue;
      edges_near_->add(static_cast<int>(edges_.size()), snap(edge.from), snap(edge.to));
      edges_.push_back(std::move(edge));
    }
    strips_near_->add(number, box_of_strip(strip, 0));
  }

  /// Pieces that go on one behind the other along a line are one joint.
  void merge_cold() {
    std::vector<ColdJoint> merged;
    for (const ColdJoint& each : result_.cold) {
      if (!merged.empty() && continues(merged.back(), each)) continue;
      merged.push_back(each);
    }
    result_.cold = std::move(merged);
  }
  static bool continues(ColdJoint& before, const ColdJoint& next) {
    const Place way = before.to - before.from;
    const double along = length(way);
    if (along < kNoLength) return false;
    const Place v = {-way.y / along, way.x / along};
    const auto beside = [&](const Place& p) { return std::abs(dot(p - before.from, v)); };
    if (beside(next.from) > kJointGap || beside(next.to) > kJointGap) return false;
    for (const bool at_end : {true, false}) {
      Place& end = at_end ? before.to : before.from;
      for (const bool first : {true, false}) {
        const Place& touching = first ? next.from : next.to;
        const Place& other = first ? next.to : next.from;
        const double onwards = dot(other - end, way) * (at_end ? 1 : -1);
        if (length(touching - end) > kShortestJoint || onwards < 0) continue;
        end = other;
        if (next.age > before.age) {
          before.age = next.age;
          before.laid = next.laid;
          before.joined = next.joined;
        }
        return true;
      }
    }
    return false;
  }

  const double half_;
  const double limit_;
  std::vector<LaidStrip> strips_;
  std::vector<FreeEdge> edges_;
  std::optional<Buckets> edges_near_, strips_near_;
  std::vector<int> seen_;  ///< by edge: the last strip that looked at it
  JointFindings result_;
};

}  // namespace

JointFindings find_joints(const std::vector<LaidStretch>& laid, double width, std::int64_t limit) {
  return JointFinder(laid, width, limit).run();
}

}  // namespace rubicon::coverage
