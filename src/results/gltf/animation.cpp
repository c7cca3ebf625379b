#include "src/results/gltf/animation.hpp"

#include <cmath>
#include <limits>

#include "src/motion/math/angles.hpp"

namespace rubicon::gltf {

using robot::FrameElement;

Eigen::Vector4d turn_of(FrameElement::Kind kind, double degrees) {
  const auto [sine, cosine] = math::sine_cosine_deg(degrees / 2);
  switch (kind) {
    case FrameElement::Kind::rotx:
      return {sine, 0, 0, cosine};
    case FrameElement::Kind::roty:
      return {0, sine, 0, cosine};
    default:
      return {0, 0, sine, cosine};
  }
}

void Animation::add_key(std::vector<FilmKey>& keys, double time,
                        const Eigen::Vector4d& value) const {
  const auto after = [](float moment) {
    return std::nextafter(moment, std::numeric_limits<float>::infinity());
  };
  const auto moment = static_cast<float>(time / speed_up_);
  if (keys.empty() || moment > keys.back().time) {
    keys.push_back({moment, value});
  } else if (keys.size() > 1 && after(keys[keys.size() - 2].time) == keys.back().time) {
    keys.back().value = value;
  } else {
    keys.push_back({after(keys.back().time), value});
  }
}

void Animation::add_channel(int node, const char* path, const char* interpolation,
                            const std::vector<FilmKey>& keys, int width) {
  Floats times, values;
  for (const FilmKey& key : keys) {
    times.push_back(key.time);
    for (int i = 0; i < width; ++i) values.push_back(static_cast<float>(key.value[i]) + 0.0F);
  }
  const int input = data_.add_times(times);
  const int output = data_.add_values(values, static_cast<std::size_t>(width));
  channels_.push_back(
      {{"sampler", samplers_.size()}, {"target", {{"node", node}, {"path", path}}}});
  samplers_.push_back({{"input", input}, {"interpolation", interpolation}, {"output", output}});
}

void Animation::add_element(int node, const ElementCurve& curve) {
  const bool turns = curve.kind != FrameElement::Kind::trans;
  std::vector<FilmKey> keys;
  for (const Key& key : turns ? with_short_turns(curve.keys, kShortTurn) : curve.keys) {
    const Vec3& value = key.value;
    add_key(keys, key.time,
            turns ? turn_of(curve.kind, value.x())
                  : Eigen::Vector4d(value.x(), value.y(), value.z(), 0));
  }
  add_channel(node, turns ? "rotation" : "translation", "LINEAR", keys, turns ? 4 : 3);
}

void Animation::add_poses(int node, const std::vector<PoseKey>& keys) {
  std::vector<FilmKey> places, turns;
  Eigen::Quaterniond last = Eigen::Quaterniond::Identity();
  for (const PoseKey& key : keys) {
    const Vec3 p = key.X.translation();
    Eigen::Quaterniond turn = Eigen::Quaterniond(math::Mat3(key.X.linear())).normalized();
    if (!turns.empty() && turn.dot(last) < 0) turn.coeffs() = -turn.coeffs();
    last = turn;
    add_key(places, key.time, {p.x(), p.y(), p.z(), 0});
    add_key(turns, key.time, {turn.x(), turn.y(), turn.z(), turn.w()});
  }
  add_channel(node, "translation", "LINEAR", places, 3);
  add_channel(node, "rotation", "LINEAR", turns, 4);
}

void Animation::add_length(int node, const KeyCurve& length) {
  std::vector<FilmKey> keys;
  for (const Key& key : length) add_key(keys, key.time, {1, 1, key.value.x(), 0});
  add_channel(node, "scale", "LINEAR", keys, 3);
}

bool Animation::add_presence(int node, const Presence& presence, double end) {
  const Eigen::Vector4d there = Eigen::Vector4d::Ones();
  const Eigen::Vector4d gone = Eigen::Vector4d::Zero();
  const bool late = presence.from > 0;
  std::vector<FilmKey> keys;
  add_key(keys, 0, late ? gone : there);
  if (late) add_key(keys, presence.from, there);
  if (presence.to < end) add_key(keys, presence.to, gone);
  if (keys.size() > 1) add_channel(node, "scale", "STEP", keys, 3);
  return late;
}

void Animation::finish(Json& document) {
  if (channels_.empty()) return;
  document["animations"] = Json::array({{{"name", "construction"},
                                         {"channels", std::move(channels_)},
                                         {"samplers", std::move(samplers_)},
                                         {"extras", {{"speed_up", speed_up_}}}}});
}

}  // namespace rubicon::gltf
