#include "interpreter/check/solid_box.hpp"

#include <variant>

namespace rubicon::interpreter {

namespace {

using math::Vec3;

class BoxBuilder {
 public:
  void operator()(const geometry::Box& box) {
    add(box.lower, 0);
    add(box.upper, 0);
  }
  void operator()(const geometry::Cylinder& cylinder) {
    const double r = cylinder.radius;
    add({-r, -r, cylinder.z0}, 0);
    add({r, r, cylinder.z1}, 0);
  }
  void operator()(const geometry::Sphere& sphere) { add(sphere.centre, sphere.radius); }
  void operator()(const geometry::Capsule& capsule) {
    add(capsule.a, capsule.radius);
    add(capsule.b, capsule.radius);
  }
  void operator()(const geometry::Prism& prism) {
    for (const Eigen::Vector2d& corner : prism.polygon) {
      add({corner.x(), corner.y(), prism.z0}, 0);
      add({corner.x(), corner.y(), prism.z1}, 0);
    }
  }
  void operator()(const geometry::Mesh& mesh) {
    for (const Vec3& vertex : mesh.mesh->vertices) add(vertex, 0);
  }

  Eigen::AlignedBox3d around;

 private:
  void add(const Vec3& p, double radius) {
    around.extend(Vec3(p - Vec3::Constant(radius)));
    around.extend(Vec3(p + Vec3::Constant(radius)));
  }
};

}  // namespace

Eigen::AlignedBox3d box_around(const geometry::Solid& solid) {
  BoxBuilder builder;
  std::visit(builder, solid);
  return builder.around;
}

}  // namespace rubicon::interpreter
