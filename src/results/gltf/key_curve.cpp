#include "src/results/gltf/key_curve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rubicon::gltf {

namespace {

/// The slopes of lines from an anchor that pass all keys since.
class Door {
 public:
  explicit Door(const Key& anchor) : anchor_(anchor) {}

  bool passes(const Key& key) const {
    const Vec3 slope = (key.value - anchor_.value) / (key.time - anchor_.time);
    return (slope.array() >= lower_.array()).all() && (slope.array() <= upper_.array()).all();
  }

  void close_to(const Key& key, double slack) {
    const double time = key.time - anchor_.time;
    const Vec3 room = Vec3::Constant(slack);
    lower_ = lower_.cwiseMax((key.value - room - anchor_.value) / time);
    upper_ = upper_.cwiseMin((key.value + room - anchor_.value) / time);
  }

 private:
  Key anchor_;
  Vec3 lower_ = Vec3::Constant(-std::numeric_limits<double>::infinity());
  Vec3 upper_ = Vec3::Constant(std::numeric_limits<double>::infinity());
};

/// Into how many pieces a turn is cut so that none is more than `most`.
int pieces_of(double turn, double most) {
  return static_cast<int>(std::ceil(std::fabs(turn) / most));
}

}  // namespace

KeyCurve reduced(const KeyCurve& curve, double slack) {
  if (curve.size() < 3) return curve;
  KeyCurve result = {curve.front()};
  Door door(curve.front());
  for (std::size_t i = 1; i < curve.size(); ++i) {
    const bool jumps = curve[i].time <= result.back().time || curve[i].time <= curve[i - 1].time;
    if (jumps || !door.passes(curve[i])) {
      if (i > 1 && result.back().time < curve[i - 1].time) result.push_back(curve[i - 1]);
      door = Door(result.back());
    }
    if (curve[i].time <= result.back().time) {
      result.push_back(curve[i]);
      door = Door(curve[i]);
    } else {
      door.close_to(curve[i], slack);
    }
  }
  if (result.back().time < curve.back().time) result.push_back(curve.back());
  return result;
}

KeyCurve with_short_turns(const KeyCurve& curve, double most) {
  KeyCurve result;
  for (const Key& key : curve) {
    if (!result.empty()) {
      const Key last = result.back();
      const int pieces = pieces_of(key.value.x() - last.value.x(), most);
      for (int i = 1; i < pieces; ++i) {
        const double share = static_cast<double>(i) / pieces;
        result.push_back({last.time + share * (key.time - last.time),
                          last.value + share * (key.value - last.value)});
      }
    }
    result.push_back(key);
  }
  return result;
}

std::size_t count_with_short_turns(const KeyCurve& curve, double most) {
  std::size_t count = curve.size();
  for (std::size_t i = 1; i < curve.size(); ++i) {
    const int pieces = pieces_of(curve[i].value.x() - curve[i - 1].value.x(), most);
    count += static_cast<std::size_t>(std::max(pieces - 1, 0));
  }
  return count;
}

}  // namespace rubicon::gltf
