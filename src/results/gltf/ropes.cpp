#include "src/results/gltf/ropes.hpp"

#include <algorithm>
#include <cmath>

#include "src/results/gltf/triangles.hpp"

namespace rubicon::gltf {

namespace {

using robot::FrameElement;

/// m: a shorter rope is not drawn.
constexpr double kShortest = 1;
/// m, or as a share of 1: what counts as plumb.
constexpr double kPlumb = 1e-3;
/// m: corners of a load that are not so far below the tool take no sling.
constexpr double kLeastSling = 0.1;

/// Whether a value of an element is always nearly 0.
bool always_zero(const ElementCurve& curve, Eigen::Index component) {
  if (std::fabs(curve.start[component]) > kPlumb) return false;
  return std::all_of(curve.keys.begin(), curve.keys.end(),
                     [&](const Key& key) { return std::fabs(key.value[component]) <= kPlumb; });
}

/// Whether z of a frame is z of the frame that it stands in.
bool upright(const FrameCurves& frame) {
  return std::all_of(frame.begin(), frame.end(), [](const ElementCurve& element) {
    const bool tilts =
        element.kind == FrameElement::Kind::rotx || element.kind == FrameElement::Kind::roty;
    return !tilts || always_zero(element, 0);
  });
}

/// Whether the origin of a frame is plumb above or below that of the frame that it stands in.
bool plumb(const FrameCurves& frame) {
  return std::all_of(frame.begin(), frame.end(), [](const ElementCurve& element) {
    return element.kind != FrameElement::Kind::trans ||
           (always_zero(element, 0) && always_zero(element, 1));
  });
}

double drop(const Vec3& value) { return std::max(-value.z(), 0.0); }

/// The element of a frame that says how long the rope is: the only one that goes up or down.
const ElementCurve* hoist_of(const FrameCurves& frame) {
  const ElementCurve* hoist = nullptr;
  for (const ElementCurve& element : frame) {
    if (element.kind != FrameElement::Kind::trans || always_zero(element, 2)) continue;
    if (hoist) return nullptr;
    hoist = &element;
  }
  return hoist;
}

/// A bar of the thickness of a rope from one point to another.
geometry::Shape strut(const Vec3& from, const Vec3& to) {
  const Vec3 z = (to - from).normalized();
  const Vec3 x = z.unitOrthogonal();
  geometry::Shape bar{
      geometry::Box{{-kRopeHalf, -kRopeHalf, 0}, {kRopeHalf, kRopeHalf, (to - from).norm()}}};
  bar.X_BS.linear().col(0) = x;
  bar.X_BS.linear().col(1) = z.cross(x);
  bar.X_BS.linear().col(2) = z;
  bar.X_BS.translation() = from;
  return bar;
}

}  // namespace

std::optional<Rope> rope_of(const replay::Machine& machine,
                            const std::vector<FrameCurves>& frames) {
  const robot::RobotModel& model = machine.model;
  const auto hook = static_cast<std::size_t>(model.tool_body);
  const int above = model.bodies[hook].parent;
  if (above < 0 || machine.mounting.X_WM.linear()(2, 2) < 1 - kPlumb) return std::nullopt;
  for (int body = model.tool_body; body >= 0;
       body = model.bodies[static_cast<std::size_t>(body)].parent) {
    if (!upright(frames[static_cast<std::size_t>(body)])) return std::nullopt;
  }
  if (!plumb(frames[hook])) return std::nullopt;
  const ElementCurve* hoist = hoist_of(frames[hook]);
  if (!hoist) return std::nullopt;
  Rope rope{above, drop(hoist->start), {}};
  double longest = rope.start;
  for (const Key& key : hoist->keys) {
    rope.length.push_back({key.time, {drop(key.value), 0, 0}});
    longest = std::max(longest, drop(key.value));
  }
  return longest < kShortest ? std::nullopt : std::optional(std::move(rope));
}

geometry::Shape rope_shape() {
  return {geometry::Box{{-kRopeHalf, -kRopeHalf, -1}, {kRopeHalf, kRopeHalf, 0}}};
}

std::vector<geometry::Shape> slings(const std::vector<geometry::Shape>& load, const Pose& X_TO) {
  Eigen::AlignedBox3d box;
  for (const Triangle& triangle : triangles_of(load)) {
    for (const Vec3& corner : triangle) box.extend(corner);
  }
  std::vector<geometry::Shape> bars;
  if (box.isEmpty()) return bars;
  const Vec3 tool = X_TO.inverse().translation();
  for (int i = 0; i < 4; ++i) {
    const Vec3 corner(i & 1 ? box.max().x() : box.min().x(), i & 2 ? box.max().y() : box.min().y(),
                      box.max().z());
    if ((X_TO * corner).z() < -kLeastSling) bars.push_back(strut(tool, corner));
  }
  return bars;
}

}  // namespace rubicon::gltf
