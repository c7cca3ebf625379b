#pragma once

#include "src/results/gltf/binary_data.hpp"
#include "src/results/gltf/motion_curves.hpp"

namespace rubicon::gltf {

/// From when to when something is there, in seconds of the plan.
struct Presence {
  double from = 0;
  double to = 0;
};

/// The one animation of a document. Times of the plan are divided by `speed_up`; of keys that fall
/// together as floats the first and the last stay, drawn apart by the least that there is.
class Animation {
 public:
  Animation(double speed_up, BinaryData& data) : speed_up_(speed_up), data_(data) {}

  /// A node's translation or rotation along a curve that has keys.
  void add_element(int node, const ElementCurve& curve);

  /// A node that goes from pose to pose: straight, and turning the short way.
  struct PoseKey {
    double time = 0;  ///< s of the plan
    math::Pose X = math::Pose::Identity();
  };
  void add_poses(int node, const std::vector<PoseKey>& keys);

  /// A node that is as long along z as a curve says (its first component).
  void add_length(int node, const KeyCurve& length);

  /// A node that has its size only while it is there; `end` is when the plan is over. True if it is
  /// not there at the beginning.
  bool add_presence(int node, const Presence& presence, double end);

  /// Writes `animations`, if there is anything to it.
  void finish(Json& document);

 private:
  /// A key of the film: its time and its value.
  struct FilmKey {
    float time = 0;
    Eigen::Vector4d value = Eigen::Vector4d::Zero();
  };
  void add_key(std::vector<FilmKey>& keys, double time, const Eigen::Vector4d& value) const;
  void add_channel(int node, const char* path, const char* interpolation,
                   const std::vector<FilmKey>& keys, int width);

  double speed_up_;
  BinaryData& data_;
  Json channels_ = Json::array();
  Json samplers_ = Json::array();
};

/// A turn by `degrees` about the axis of an element, as x, y, z, w.
Eigen::Vector4d turn_of(robot::FrameElement::Kind kind, double degrees);

}  // namespace rubicon::gltf
