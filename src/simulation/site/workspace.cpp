#include "src/simulation/site/workspace.hpp"

#include <algorithm>
#include <cmath>

#include "src/motion/geometry/extent.hpp"
#include "src/motion/math/index.hpp"
#include "src/motion/robot/turns.hpp"

namespace rubicon::site {

namespace {

using math::at;

/// Degrees between two places of a turning body, of which the hull is taken.
constexpr double kTurnApart = 5;
constexpr int kMostPlacesOfWay = 64;
/// m: workspaces that only touch do not overlap.
constexpr double kEdge = 1e-6;

double cross(const Eigen::Vector2d& o, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return (a.x() - o.x()) * (b.y() - o.y()) - (a.y() - o.y()) * (b.x() - o.x());
}

/// The convex hull (Andrew's monotone chain).
PlanPolygon hull_of(std::vector<Eigen::Vector2d> points) {
  std::sort(points.begin(), points.end(), [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  });
  PlanPolygon hull(2 * points.size());
  std::size_t size = 0;
  const auto add = [&](const Eigen::Vector2d& point, std::size_t least) {
    while (size >= least && cross(hull[size - 2], hull[size - 1], point) <= 0) --size;
    hull[size++] = point;
  };
  for (const Eigen::Vector2d& point : points) add(point, 2);
  const std::size_t lower = size + 1;
  for (std::size_t i = points.size() - 1; i-- > 0;) add(points[i], lower);
  hull.resize(std::max<std::size_t>(size, 2) - 1);
  return hull;
}

/// Whether a line along an edge of the first has the second on its other side.
bool is_parted_by(const PlanPolygon& a, const PlanPolygon& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Eigen::Vector2d& from = a[i];
    const Eigen::Vector2d edge = a[(i + 1) % a.size()] - from;
    const double length = edge.norm();
    if (!(length > 0)) continue;
    const Eigen::Vector2d outward = Eigen::Vector2d(edge.y(), -edge.x()) / length;
    if (std::all_of(b.begin(), b.end(), [&](const Eigen::Vector2d& point) {
          return outward.dot(point - from) >= -kEdge;
        })) {
      return true;
    }
  }
  return false;
}

std::vector<std::vector<Eigen::Vector2d>> seen_from_above(const SiteRobot& robot,
                                                          const BodyCorners& corners,
                                                          std::span<const double> q) {
  std::vector<math::Pose> X_WB;
  robot::body_poses(*robot.model, robot.mounting, q, X_WB);
  std::vector<std::vector<Eigen::Vector2d>> seen(corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (const math::Vec3& p : corners[i]) seen[i].emplace_back((X_WB[i] * p).head<2>());
  }
  return seen;
}

}  // namespace

int WorkspaceRules::rank_of(int robot) const {
  const auto found = std::find(order.begin(), order.end(), robot);
  return found == order.end() ? -1 : static_cast<int>(found - order.begin());
}

void PlanRegion::add(std::vector<Eigen::Vector2d> points) {
  if (points.empty()) return;
  Eigen::AlignedBox2d& box = boxes.emplace_back();
  for (const Eigen::Vector2d& point : points) box.extend(point);
  bounds.extend(box);
  polygons.push_back(hull_of(std::move(points)));
}

bool PlanRegion::overlaps(const PlanRegion& other) const {
  if (!bounds.intersects(other.bounds)) return false;
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    if (!boxes[i].intersects(other.bounds)) continue;
    for (std::size_t k = 0; k < other.polygons.size(); ++k) {
      if (!boxes[i].intersects(other.boxes[k])) continue;
      const PlanPolygon& a = polygons[i];
      const PlanPolygon& b = other.polygons[k];
      if (!is_parted_by(a, b) && !is_parted_by(b, a)) return true;
    }
  }
  return false;
}

BodyCorners corners_of(const robot::RobotModel& model) {
  BodyCorners corners(model.bodies.size());
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    for (const geometry::Shape& shape : model.bodies[i].shapes) {
      const Eigen::AlignedBox3d box = geometry::extent_of(shape);
      for (int corner = 0; corner < 8; ++corner) {
        corners[i].emplace_back(box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner)));
      }
    }
  }
  return corners;
}

PlanRegion workspace_of(const SiteRobot& robot, const BodyCorners& corners,
                        const WorkspaceStep& step, const WorkspaceRules& rules, int more_steps) {
  const auto& parameters = robot.model->parameters;
  std::vector<double> q_end(step.q_to.begin(), step.q_to.end());
  double length2 = 0;
  for (std::size_t i = 0; i < q_end.size(); ++i) {
    const double gone = step.q_to[i] - step.q_from[i];
    if (!parameters[i].rotation && !parameters[i].derived) length2 += gone * gone;
  }
  // How long it goes on as in the step, by its speed.
  const auto goes_on = [&](double speed, double braking) {
    return rules.reaction + speed / (2 * braking);
  };
  const double by_length =
      step.seconds > 0 ? goes_on(std::sqrt(length2) / step.seconds, rules.braking) : 0;
  for (std::size_t i = 0; i < q_end.size(); ++i) {
    const double gone = step.q_to[i] - step.q_from[i];
    if (gone == 0 || !(step.seconds > 0)) continue;
    const double rate = gone / step.seconds;
    const double time =
        parameters[i].rotation ? goes_on(std::fabs(rate), rules.turn_braking) : by_length;
    double more = gone * more_steps + rate * time;
    if (!step.q_goal.empty()) {
      const double left = robot::way_between(parameters[i], step.q_to[i], step.q_goal[i]);
      if (left * more >= 0 && std::fabs(left) < std::fabs(more)) more = left;
    }
    q_end[i] += more;
  }
  return swept_region(robot, corners, step.q_from, q_end);
}

PlanRegion swept_region(const SiteRobot& robot, const BodyCorners& corners,
                        std::span<const double> q_from, std::span<const double> q_to) {
  const auto& parameters = robot.model->parameters;
  double turned = 0;
  for (std::size_t i = 0; i < q_to.size(); ++i) {
    if (parameters[i].rotation) turned = std::max(turned, std::fabs(q_to[i] - q_from[i]));
  }
  const int parts =
      std::clamp(static_cast<int>(std::ceil(turned / kTurnApart)), 1, kMostPlacesOfWay);
  PlanRegion region;
  std::vector<std::vector<Eigen::Vector2d>> before = seen_from_above(robot, corners, q_from);
  for (int part = 1; part <= parts; ++part) {
    std::vector<double> q(q_to.size());
    for (std::size_t i = 0; i < q.size(); ++i) {
      q[i] = q_from[i] + (q_to[i] - q_from[i]) * part / parts;
    }
    std::vector<std::vector<Eigen::Vector2d>> here = seen_from_above(robot, corners, q);
    for (std::size_t i = 0; i < here.size(); ++i) {
      std::vector<Eigen::Vector2d> points = before[i];
      points.insert(points.end(), here[i].begin(), here[i].end());
      region.add(std::move(points));
    }
    before = std::move(here);
  }
  return region;
}

PlanRegion footprint_of(const SiteRobot& robot, const BodyCorners& corners,
                        std::span<const double> q) {
  PlanRegion region;
  for (std::vector<Eigen::Vector2d>& points : seen_from_above(robot, corners, q)) {
    region.add(std::move(points));
  }
  return region;
}

}  // namespace rubicon::site
