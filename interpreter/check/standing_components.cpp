#include "interpreter/check/standing_components.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "src/motion/geometry/extent.hpp"
#include "src/motion/math/angles.hpp"
#include "src/motion/math/index.hpp"

namespace rubicon::interpreter {

namespace {

/// m
constexpr double kOverSurface = 1e-3;
/// Corners of what stands for a circle, outside of it.
constexpr int kCircleCorners = 48;

/// The shadow of one shape, as rings whose union it is.
class Shadow {
 public:
  explicit Shadow(const geometry::Shape& shape) : X_WS_(shape.X_BS) {
    std::visit([this](const auto& solid) { add(solid); }, shape.solid);
  }
  std::vector<coverage::Ring> rings;

 private:
  coverage::Point flat(const math::Vec3& p_S) const {
    const math::Vec3 p = X_WS_ * p_S;
    return coverage::snap({p.x(), p.y()});
  }
  void add_ring(coverage::Ring ring) {
    const std::int64_t area = coverage::twice_area(ring);
    if (area == 0) return;
    if (area < 0) std::reverse(ring.begin(), ring.end());
    rings.push_back(std::move(ring));
  }
  /// Both ends of a straight body, and its sides.
  void add_straight(const std::vector<Eigen::Vector2d>& section, double low, double high) {
    coverage::Ring bottom, top;
    for (const Eigen::Vector2d& p : section) {
      bottom.push_back(flat({p.x(), p.y(), low}));
      top.push_back(flat({p.x(), p.y(), high}));
    }
    for (std::size_t i = 0; i < section.size(); ++i) {
      const std::size_t k = i + 1 < section.size() ? i + 1 : 0;
      add_ring({bottom[i], bottom[k], top[k], top[i]});
    }
    add_ring(std::move(bottom));
    add_ring(std::move(top));
  }
  static std::vector<Eigen::Vector2d> circle(double x, double y, double radius) {
    const double out = radius / math::cos_deg(180.0 / kCircleCorners);
    std::vector<Eigen::Vector2d> points;
    for (int i = 0; i < kCircleCorners; ++i) {
      const double angle = 360.0 * i / kCircleCorners;
      points.emplace_back(x + out * math::cos_deg(angle), y + out * math::sin_deg(angle));
    }
    return points;
  }
  void add(const geometry::Box& box) {
    const math::Vec3& a = box.lower;
    const math::Vec3& b = box.upper;
    add_straight({{a.x(), a.y()}, {b.x(), a.y()}, {b.x(), b.y()}, {a.x(), b.y()}}, a.z(), b.z());
  }
  void add(const geometry::Prism& prism) { add_straight(prism.polygon, prism.z0, prism.z1); }
  void add(const geometry::Cylinder& cylinder) {
    add_straight(circle(0, 0, cylinder.radius), cylinder.z0, cylinder.z1);
  }
  void add_circle(const math::Vec3& middle_S, double radius) {
    const math::Vec3 middle = X_WS_ * middle_S;
    coverage::Ring ring;
    for (const Eigen::Vector2d& p : circle(middle.x(), middle.y(), radius)) {
      ring.push_back(coverage::snap({p.x(), p.y()}));
    }
    add_ring(std::move(ring));
  }
  void add(const geometry::Sphere& sphere) { add_circle(sphere.centre, sphere.radius); }
  void add(const geometry::Capsule& capsule) {
    add_circle(capsule.a, capsule.radius);
    add_circle(capsule.b, capsule.radius);
    const Eigen::Vector2d a = (X_WS_ * capsule.a).head<2>();
    const Eigen::Vector2d b = (X_WS_ * capsule.b).head<2>();
    const double length = (b - a).norm();
    if (length < 1e-9) return;
    const Eigen::Vector2d side =
        Eigen::Vector2d(a.y() - b.y(), b.x() - a.x()) / length * capsule.radius;
    coverage::Ring ring;
    for (const Eigen::Vector2d& p :
         std::vector<Eigen::Vector2d>{a - side, b - side, b + side, a + side}) {
      ring.push_back(coverage::snap({p.x(), p.y()}));
    }
    add_ring(std::move(ring));
  }
  void add(const geometry::Mesh& mesh) {
    for (const auto& triangle : mesh.mesh->triangles) {
      coverage::Ring ring;
      for (const int vertex : triangle) ring.push_back(flat(mesh.mesh->vertices[math::at(vertex)]));
      add_ring(std::move(ring));
    }
  }

  const math::Pose X_WS_;
};

/// Whether all of a box lies where floors can be.
bool is_where_floors_are(const Eigen::AlignedBox3d& box) {
  const auto near = [](double value) { return std::abs(value) < coverage::kReach; };
  return near(box.min().x()) && near(box.min().y()) && near(box.max().x()) && near(box.max().y());
}

}  // namespace

std::vector<coverage::Standing> standing_in(const ComponentSpec& component, const math::Pose& X_WO,
                                            const FloorLayer& layer) {
  std::vector<coverage::Standing> things;
  std::vector<coverage::Ring> rings;
  for (const geometry::Shape& shape : component.shapes) {
    geometry::Shape placed = shape;
    placed.X_BS = X_WO * shape.X_BS;
    const Eigen::AlignedBox3d box = geometry::extent_of(placed);
    if (!(box.max().z() > layer.surface + kOverSurface && box.min().z() <= layer.tool)) continue;
    if (!is_where_floors_are(box)) continue;
    const auto* cylinder = std::get_if<geometry::Cylinder>(&placed.solid);
    if (cylinder != nullptr && std::abs(placed.X_BS.linear()(2, 2)) > 1 - 1e-9) {
      coverage::Standing thing;
      thing.name = component.name;
      thing.round = true;
      thing.centre = {placed.X_BS.translation().x(), placed.X_BS.translation().y()};
      thing.diameter = 2 * cylinder->radius;
      things.push_back(std::move(thing));
      continue;
    }
    Shadow shadow(placed);
    for (coverage::Ring& ring : shadow.rings) rings.push_back(std::move(ring));
  }
  if (rings.empty()) return things;
  // What is enclosed, as in the middle of a pipe, is not floor.
  for (coverage::Region& region : coverage::united(rings)) {
    things.push_back(coverage::standing_of(component.name, std::move(region.outline)));
  }
  return things;
}

ComponentPlaces::ComponentPlaces(const PlanModel& plan)
    : plan_(plan),
      later_(2 * plan.tasks.size()),
      earlier_(2 * plan.tasks.size()),
      users_(plan.components.size()) {
  const auto join = [this](std::size_t before, std::size_t after) {
    later_[before].push_back(static_cast<int>(after));
    earlier_[after].push_back(static_cast<int>(before));
  };
  for (std::size_t t = 0; t < plan.tasks.size(); ++t) {
    join(2 * t, 2 * t + 1);
    const TaskSpec& task = plan.tasks[t];
    for (const LinkSpec& link : task.after) {
      if (link.task < 0 || link.lag < 0) continue;
      const bool from_finish = schedule::end_before(link.type) == schedule::TaskEnd::finish;
      const bool to_start = schedule::end_after(link.type) == schedule::TaskEnd::start;
      join(2 * math::at(link.task) + (from_finish ? 1 : 0), 2 * t + (to_start ? 0 : 1));
    }
    const TaskSpec& way = task.choices.empty() ? task : task.choices.front();
    std::vector<int> used = way.remove;
    if (way.move) used.push_back(*way.move);
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    for (const int component : used) users_[math::at(component)].push_back(static_cast<int>(t));
  }
}

std::vector<bool> ComponentPlaces::reached(std::size_t event,
                                           const std::vector<std::vector<int>>& next) const {
  std::vector<bool> seen(next.size(), false);
  std::vector<std::size_t> open{event};
  seen[event] = true;
  while (!open.empty()) {
    const std::size_t here = open.back();
    open.pop_back();
    for (const int each : next[here]) {
      if (seen[math::at(each)]) continue;
      seen[math::at(each)] = true;
      open.push_back(math::at(each));
    }
  }
  return seen;
}

bool ComponentPlaces::is_before(int first, int second) const {
  return reached(2 * math::at(first) + 1, later_)[2 * math::at(second)];
}

ComponentPlaces::Place ComponentPlaces::place_after(int task, int component) const {
  const TaskSpec& spec = plan_.tasks[math::at(task)];
  const TaskSpec& way = spec.choices.empty() ? spec : spec.choices.front();
  const bool removed =
      std::find(way.remove.begin(), way.remove.end(), component) != way.remove.end();
  return {!removed, way.X_WO_goal};
}

std::vector<ComponentPlaces::Answer> ComponentPlaces::during(int task) const {
  const std::vector<bool> before = reached(2 * math::at(task), earlier_);
  const std::vector<bool> after = reached(2 * math::at(task) + 1, later_);
  std::vector<Answer> answers(users_.size());
  for (std::size_t c = 0; c < users_.size(); ++c) {
    Answer& answer = answers[c];
    const int component = static_cast<int>(c);
    std::vector<int> done;
    for (const int user : users_[c]) {
      if (user == task) continue;
      if (before[2 * math::at(user) + 1]) {
        done.push_back(user);
      } else if (!after[2 * math::at(user)]) {
        answer.undecided = user;
        answer.places.push_back(place_after(user, component));
      }
    }
    if (done.empty()) {
      answer.places.push_back({true, plan_.components[c].X_WO});
      continue;
    }
    // The one that comes after all others of them, if there is one.
    const auto last = std::find_if(done.begin(), done.end(), [&](int each) {
      return std::all_of(done.begin(), done.end(),
                         [&](int other) { return other == each || is_before(other, each); });
    });
    if (last != done.end()) {
      answer.places.push_back(place_after(*last, component));
      continue;
    }
    answer.undecided = done.back();
    for (const int each : done) answer.places.push_back(place_after(each, component));
  }
  return answers;
}

}  // namespace rubicon::interpreter
