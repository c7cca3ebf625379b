#include "tests/unit/urdf/urdfdom_poses.hpp"

#include <urdf_parser/urdf_parser.h>

#include <Eigen/Geometry>
#include <functional>

namespace rubicon::urdf::testing {

namespace {

double value_of(const ::urdf::ModelInterface& model, const ::urdf::Joint& joint,
                const std::map<std::string, double>& values) {
  if (!joint.mimic) return values.count(joint.name) != 0 ? values.at(joint.name) : 0;
  const auto leader = model.getJoint(joint.mimic->joint_name);
  return joint.mimic->multiplier * value_of(model, *leader, values) + joint.mimic->offset;
}

math::Pose pose_of(const ::urdf::Pose& pose) {
  const auto& q = pose.rotation;
  math::Pose result = math::Pose::Identity();
  result.linear() = Eigen::Quaterniond(q.w, q.x, q.y, q.z).toRotationMatrix();
  result.translation() = Eigen::Vector3d(pose.position.x, pose.position.y, pose.position.z);
  return result;
}

}  // namespace

std::map<std::string, math::Pose> urdfdom_poses(const std::string& text,
                                                const std::map<std::string, double>& values) {
  const auto model = ::urdf::parseURDF(text);
  std::map<std::string, math::Pose> result;
  if (!model) return result;
  const std::function<void(const ::urdf::Link&, const math::Pose&)> walk =
      [&](const ::urdf::Link& link, const math::Pose& X_WL) {
        result[link.name] = X_WL;
        for (const auto& joint : link.child_joints) {
          math::Pose X = X_WL * pose_of(joint->parent_to_joint_origin_transform);
          const Eigen::Vector3d axis =
              Eigen::Vector3d(joint->axis.x, joint->axis.y, joint->axis.z).normalized();
          if (joint->type == ::urdf::Joint::PRISMATIC) {
            X.translate(axis * value_of(*model, *joint, values));
          } else if (joint->type != ::urdf::Joint::FIXED) {
            X.rotate(Eigen::AngleAxisd(value_of(*model, *joint, values), axis));
          }
          walk(*model->getLink(joint->child_link_name), X);
        }
      };
  walk(*model->getRoot(), math::Pose::Identity());
  return result;
}

}  // namespace rubicon::urdf::testing
