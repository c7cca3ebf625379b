#include "src/gltf/animation.hpp"

#include <cmath>
#include <limits>

#include "src/math/angles.hpp"

namespace rubicon::gltf {

using verify::FrameElement;

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

Floats Animation::film_times(const std::vector<double>& times) const {
  Floats film;
  for (const double time : times) {
    auto next = static_cast<float>(time / speed_up_);
    if (!film.empty() && next <= film.back()) {
      next = std::nextafter(film.back(), std::numeric_limits<float>::infinity());
    }
    film.push_back(next);
  }
  return film;
}

void Animation::add_channel(int node, const char* path, const char* interpolation,
                            const Floats& times, const Floats& values, std::size_t width) {
  const int input = data_.add_times(times);
  const int output = data_.add_values(values, width);
  channels_.push_back(
      {{"sampler", samplers_.size()}, {"target", {{"node", node}, {"path", path}}}});
  samplers_.push_back({{"input", input}, {"interpolation", interpolation}, {"output", output}});
}

void Animation::add_element(int node, const ElementCurve& curve) {
  const bool turns = curve.kind != FrameElement::Kind::trans;
  // Turns run the shorter way from key to key.
  constexpr double kShortTurn = 90;
  const KeyCurve keys = turns ? with_short_turns(curve.keys, kShortTurn) : curve.keys;
  std::vector<double> times;
  Floats values;
  for (const Key& key : keys) {
    times.push_back(key.time);
    if (turns) {
      const Eigen::Vector4d turn = turn_of(curve.kind, key.value.x());
      for (int i = 0; i < 4; ++i) values.push_back(static_cast<float>(turn[i]) + 0.0F);
    } else {
      for (int i = 0; i < 3; ++i) values.push_back(static_cast<float>(key.value[i]) + 0.0F);
    }
  }
  add_channel(node, turns ? "rotation" : "translation", "LINEAR", film_times(times), values,
              turns ? 4 : 3);
}

bool Animation::add_presence(int node, const Presence& presence, double end) {
  std::vector<double> times = {0};
  Floats sizes = {presence.from > 0 ? 0.0F : 1.0F};
  if (presence.from > 0) {
    times.push_back(presence.from);
    sizes.push_back(1);
  }
  if (presence.to < end) {
    times.push_back(presence.to);
    sizes.push_back(0);
  }
  if (times.size() == 1) return false;
  Floats scales;
  for (const float size : sizes) scales.insert(scales.end(), 3, size);
  add_channel(node, "scale", "STEP", film_times(times), scales, 3);
  return presence.from > 0;
}

void Animation::finish(Json& document) {
  if (channels_.empty()) return;
  document["animations"] = Json::array({{{"name", "construction"},
                                         {"channels", std::move(channels_)},
                                         {"samplers", std::move(samplers_)},
                                         {"extras", {{"speed_up", speed_up_}}}}});
}

}  // namespace rubicon::gltf
