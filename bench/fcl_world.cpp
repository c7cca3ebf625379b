#include "bench/fcl_world.hpp"

#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/continuous_collision.h>

#include <cmath>
#include <stdexcept>

namespace rubicon::bench {
namespace {

constexpr double kPoseDistance = 0.01;  // m, of the point that goes farthest

fcl::AABBd aabb(const Eigen::AlignedBox3d& box) { return {box.min(), box.max()}; }

std::shared_ptr<fcl::CollisionGeometryd> fcl_geometry(const geometry::Solid& solid) {
  std::shared_ptr<fcl::CollisionGeometryd> made;
  if (const auto* mesh = std::get_if<geometry::Mesh>(&solid)) {
    auto model = std::make_shared<fcl::BVHModel<fcl::OBBRSSd>>();
    std::vector<fcl::Triangle> triangles;
    for (const auto& t : mesh->mesh->triangles) triangles.emplace_back(t[0], t[1], t[2]);
    if (model->beginModel() != fcl::BVH_OK ||
        model->addSubModel(mesh->mesh->vertices, triangles) != fcl::BVH_OK ||
        model->endModel() != fcl::BVH_OK) {
      throw std::runtime_error("FCL refuses a mesh");
    }
    made = model;
  } else {
    made = std::make_shared<fcl::Boxd>(2 * std::get<geometry::Box>(solid).upper);
  }
  made->computeLocalAABB();
  return made;
}

/// An object whose bounds are given rather than computed.
class BoundedObject : public fcl::CollisionObjectd {
 public:
  BoundedObject(const std::shared_ptr<fcl::CollisionGeometryd>& shape, const Pose& X)
      : fcl::CollisionObjectd(shape, X) {}
  void set_bounds(const fcl::AABBd& bounds) { aabb = bounds; }
};

}  // namespace

struct FclWorld::Load {
  std::shared_ptr<fcl::CollisionGeometryd> shape;
  std::vector<Vec3> corners;
};

struct FclWorld::Step {
  LoadPtr load;
  fcl::Transform3d start;
  fcl::Transform3d end;
  bool rotates = false;
  fcl::AABBd swept;
  std::vector<fcl::Transform3d> poses;
  std::vector<fcl::AABBd> pose_bounds;
  mutable BoundedObject asked;  ///< what the tree is asked with; made here, since that takes long

  explicit Step(const LoadPtr& moved) : load(moved), asked(moved->shape, Pose::Identity()) {}
};

struct FclWorld::Impl {
  std::vector<std::shared_ptr<fcl::CollisionGeometryd>> shapes;
  std::vector<std::unique_ptr<BoundedObject>> objects;
  fcl::DynamicAABBTreeCollisionManagerd tree;

  BoundedObject& make(const Standing& standing) {
    objects.push_back(std::make_unique<BoundedObject>(shapes[standing.solid], standing.X_WB));
    return *objects.back();
  }

  void register_all() {
    std::vector<fcl::CollisionObjectd*> pointers;
    for (const auto& object : objects) pointers.push_back(object.get());
    tree.registerObjects(pointers);
    tree.setup();
  }

  /// Asks `met(shape, pose)` of each standing object that the tree finds, until one says yes.
  template <typename Met>
  bool any(BoundedObject& asked, const fcl::AABBd& bounds, Met met) const {
    struct Question {
      const fcl::CollisionObjectd* asked;
      Met& met;
      bool hit = false;
    };
    asked.set_bounds(bounds);
    Question question{&asked, met};
    tree.collide(&asked, &question,
                 [](fcl::CollisionObjectd* first, fcl::CollisionObjectd* second, void* data) {
                   auto& in = *static_cast<Question*>(data);
                   const fcl::CollisionObjectd* standing = first == in.asked ? second : first;
                   in.hit = in.met(standing->collisionGeometry().get(), standing->getTransform());
                   return in.hit;
                 });
    return question.hit;
  }
};

namespace {

bool collide(const fcl::CollisionGeometryd* a, const fcl::Transform3d& X_a,
             const fcl::CollisionGeometryd* b, const fcl::Transform3d& X_b) {
  const fcl::CollisionRequestd request;  // libccd, no contacts asked for
  fcl::CollisionResultd result;
  return fcl::collide(a, X_a, b, X_b, request, result) > 0;
}

}  // namespace

FclWorld::FclWorld(const std::vector<geometry::Solid>& solids) : impl_(std::make_unique<Impl>()) {
  for (const geometry::Solid& solid : solids) impl_->shapes.push_back(fcl_geometry(solid));
}

FclWorld::FclWorld(const SweptScene& scene, FclBounds bounds) : FclWorld(scene.solids) {
  for (const Standing& standing : scene.standing) {
    BoundedObject& object = impl_->make(standing);
    if (bounds == FclBounds::kAsItComes) continue;
    geometry::ScrewMotion still;
    still.X0 = standing.X_WB;
    object.set_bounds(aabb(swept_bounds(corners_of(scene.solids[standing.solid]), still)));
  }
  impl_->register_all();
}

void FclWorld::insert_all(const std::vector<Standing>& standing) {
  for (const Standing& one : standing) impl_->make(one);
  impl_->register_all();
}

void FclWorld::insert(const Standing& standing) {
  impl_->tree.registerObject(&impl_->make(standing));
}

void FclWorld::remove(std::size_t index) {
  impl_->tree.unregisterObject(impl_->objects[index].get());
}

FclWorld::~FclWorld() = default;

FclWorld::LoadPtr FclWorld::make_load(const geometry::Solid& solid) {
  return std::make_shared<Load>(Load{fcl_geometry(solid), corners_of(solid)});
}

FclWorld::StepPtr FclWorld::make_step(const LoadPtr& load, const geometry::ScrewMotion& motion,
                                      bool with_poses) {
  auto step = std::make_shared<Step>(load);
  const geometry::Motion way{motion};
  step->start = way.pose(0);
  step->end = way.pose(1);
  step->rotates = motion.angle_deg != 0;
  step->swept = aabb(swept_bounds(load->corners, motion));
  if (!with_poses) return step;
  const int gaps =
      std::max(1, static_cast<int>(std::ceil(longest_way(load->corners, motion) / kPoseDistance)));
  for (int i = 0; i <= gaps; ++i) {
    geometry::ScrewMotion still;
    still.X0 = way.pose(static_cast<double>(i) / gaps);
    step->poses.push_back(still.X0);
    step->pose_bounds.push_back(aabb(swept_bounds(load->corners, still)));
  }
  return step;
}

bool FclWorld::continuous(const Step& step, FclRotation rotation) const {
  const bool screw = step.rotates && rotation == FclRotation::kScrew;
  const fcl::CollisionGeometryd* load = step.load->shape.get();
  return impl_->any(
      step.asked, step.swept, [&](const fcl::CollisionGeometryd* shape, const fcl::Transform3d& X) {
        fcl::ContinuousCollisionRequestd request;
        if (screw) request.ccd_motion_type = fcl::CCDM_SCREW;
        fcl::ContinuousCollisionResultd result;
        fcl::continuousCollide(load, step.start, step.end, shape, X, X, request, result);
        return result.is_collide;
      });
}

bool FclWorld::every_10_mm(const Step& step) const {
  const fcl::CollisionGeometryd* load = step.load->shape.get();
  for (std::size_t i = 0; i < step.poses.size(); ++i) {
    if (impl_->any(step.asked, step.pose_bounds[i],
                   [&](const fcl::CollisionGeometryd* shape, const fcl::Transform3d& X) {
                     return collide(load, step.poses[i], shape, X);
                   })) {
      return true;
    }
  }
  return false;
}

bool FclWorld::every_10_mm_one_tree_query(const Step& step) const {
  const fcl::CollisionGeometryd* load = step.load->shape.get();
  return impl_->any(step.asked, step.swept,
                    [&](const fcl::CollisionGeometryd* shape, const fcl::Transform3d& X) {
                      for (const fcl::Transform3d& X_load : step.poses) {
                        if (collide(load, X_load, shape, X)) return true;
                      }
                      return false;
                    });
}

bool FclWorld::blocked_at(const Load& load, const Pose& X) const {
  geometry::ScrewMotion still;
  still.X0 = X;
  BoundedObject asked(load.shape, Pose::Identity());
  return impl_->any(asked, aabb(swept_bounds(load.corners, still)),
                    [&](const fcl::CollisionGeometryd* shape, const fcl::Transform3d& X_standing) {
                      return collide(load.shape.get(), X, shape, X_standing);
                    });
}

}  // namespace rubicon::bench
