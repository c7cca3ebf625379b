// Steps of bodies over soil that is dug and heaped between them, asked of the site as a machine
// asks it.
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "src/earth/soil/blocks.hpp"
#include "src/simulation/site/robot_view.hpp"
#include "tests/proof/generators.hpp"
#include "tests/proof/mesh_models.hpp"
#include "tests/proof/soil_field.hpp"
#include "tests/proof/solid.hpp"
#include "tests/unit/collision/meshes.hpp"
#include "tests/unit/robot/robots.hpp"

namespace rubicon::collision::proof {
namespace {

using Q = std::vector<double>;

constexpr int kStages = 4;
constexpr int kStepsAStage = 50;
/// Steps that are moved up or down until they only just meet the soil: one in so many.
constexpr int kSoilGrazeEvery = 2;
/// Looks at poses, after which a case is too near to call.
constexpr int kMostLooks = 3000;

/// A body as the engine and FCL see it.
struct SoilMover {
  struct Part {
    FclGeometry fcl;
    Pose X_BS = Pose::Identity();
    Vec3 inner = Vec3::Zero();  ///< in the frame of the part: a point of it
  };
  std::string text;
  std::vector<geometry::Shape> shapes;
  std::vector<Part> parts;
  double reach = 0;
  Vec3 half = Vec3::Zero();  ///< of the plain box that it is; else zero
};

void add_solid(SoilMover& mover, const Solid& solid, const Pose& X_BS) {
  geometry::Shape shape = solid.shape();
  shape.X_BS = X_BS;
  mover.shapes.push_back(shape);
  mover.parts.push_back({solid.fcl(), X_BS, Vec3::Zero()});
  mover.reach = std::max(mover.reach, X_BS.translation().norm() + solid.reach());
  mover.text += text_of(solid) + " at " + text_of(X_BS) + "; ";
}

SoilMover random_mover(Random& random) {
  SoilMover mover;
  const int kind = random.below(8);
  if (kind < 3) {
    mover.half.x() = random.between(0.05, 0.6);
    mover.half.y() = random.between(0.05, 0.6);
    mover.half.z() = random.between(0.05, 0.6);
    add_solid(mover, box_solid(mover.half), Pose::Identity());
  } else if (kind == 3) {
    // A bucket: a floor, a back and two sides.
    const double width = random.between(0.25, 0.6);
    const double length = random.between(0.4, 0.9);
    add_solid(mover, box_solid(Vec3(length / 2, width, 0.04)), at(0, 0, -0.3));
    add_solid(mover, box_solid(Vec3(0.04, width, 0.3)), at(-length / 2, 0, 0));
    for (const double side : {-1.0, 1.0}) {
      add_solid(mover, box_solid(Vec3(length / 2, 0.04, 0.3)), at(0, side * width, 0));
    }
  } else if (kind < 6) {
    // Not thinner than 100 mm, so that the tolerance is the one that is asked for.
    add_solid(mover, random_solid(random, 0.1, 0.4), Pose::Identity());
  } else {
    const MeshModel& model = coarse_models()[kind == 6 ? 0 : 1];
    mover.text = model.name;
    mover.shapes.push_back(
        {geometry::Mesh{"", std::make_shared<geometry::TriangleMesh>(model.mesh)}, {}});
    mover.shapes.back().X_BS.setIdentity();
    mover.parts.push_back({model.fcl, Pose::Identity(), model.mesh.vertices.front()});
    mover.reach = model.pieces.reach;
  }
  return mover;
}

/// Soil with slopes, cuts, heaps, steps, holes and thin leftovers.
Columns random_columns(Random& random) {
  Columns soil;
  soil.columns = 7 + random.below(6);
  soil.rows = 6 + random.below(5);
  soil.cell = random.below(3) ? 250 : 400;
  const auto cells = soil.index(0, soil.rows);
  const std::int64_t floor = -1500 - random.below(500);
  soil.bottom.assign(cells, floor);
  soil.top.assign(cells, 0);
  const int slope_x = random.below(401) - 200;
  const int slope_y = random.below(401) - 200;
  const int rough = random.below(2) ? 0 : 1 + random.below(120);
  const int steps = random.below(3) ? 0 : 1 + random.below(4);
  for (int row = 0; row < soil.rows; ++row) {
    for (int column = 0; column < soil.columns; ++column) {
      const std::size_t cell = soil.index(column, row);
      std::int64_t height = random.below(rough + 1);
      if (steps > 0) {
        height += 300 * (column * steps / soil.columns);
      } else if (rough % 2 == 1) {
        height += slope_x * column / 2 + slope_y * row / 2;
      }
      soil.top[cell] = height;
      // Soil of a task lies on what is left under its slopes.
      if (rough % 3 == 1) soil.bottom[cell] = floor + 60 * std::min(column, row);
      if (soil.is_empty(cell)) soil.top[cell] = soil.bottom[cell];
    }
  }
  return soil;
}

/// Digs a cut, empties cells, leaves a film, tips a heap, or makes it all rough again.
std::map<int, soil::Millimetres> random_change(Random& random, const Columns& soil, bool is_mesh) {
  std::map<int, soil::Millimetres> heights;
  const int c0 = random.below(soil.columns);
  const int r0 = random.below(soil.rows);
  const int c1 = std::min(soil.columns, c0 + 1 + random.below(5));
  const int r1 = std::min(soil.rows, r0 + 1 + random.below(4));
  // No islands that a mesh could have inside it, of which FCL would know nothing.
  const int kind = is_mesh ? 2 * random.below(2) : random.below(5);
  const std::int64_t depth = 50 + random.below(900);
  for (int row = 0; row < soil.rows; ++row) {
    for (int column = 0; column < soil.columns; ++column) {
      const std::size_t cell = soil.index(column, row);
      const bool in_cut = column >= c0 && column < c1 && row >= r0 && row < r1;
      const std::int64_t bottom = soil.bottom[cell];
      const std::int64_t least = is_mesh ? bottom + 700 : bottom;
      std::int64_t height = soil.top[cell];
      if (kind == 0 && in_cut) height = std::max(least, height - depth);
      if (kind == 1 && in_cut) height = bottom;
      if (kind == 2) {
        const double away = std::hypot(column - c0, row - r0) * static_cast<double>(soil.cell);
        height = std::max(height, static_cast<std::int64_t>(1000 - 0.7 * away));
      }
      if (kind == 3 && in_cut) height = bottom + 1 + random.below(60);
      if (kind == 4) height += random.below(9);
      if (height != soil.top[cell]) heights[static_cast<int>(cell)] = height;
    }
  }
  return heights;
}

soil::Terrain terrain_of_side(const Columns& soil, const std::vector<std::int64_t>& heights) {
  return {soil.columns, soil.rows, soil.cell, soil::Heights(heights)};
}

/// A body that goes anywhere.
robot::RobotModel free_flyer(const SoilMover& mover) {
  using Kind = robot::FrameElement::Kind;
  robot::RobotModel model;
  model.name = "flyer";
  robot::add_body(model, "body", -1);
  for (const char* name : {"x", "y", "z"}) robot::add_parameter(model, name, -1e6, 1e6, 0.1);
  for (const char* name : {"theta", "phi", "psi"}) {
    robot::add_parameter(model, name, -1e6, 1e6, 1);
  }
  for (robot::Parameter& parameter : model.parameters) {
    parameter.speed = parameter.loaded_speed = 1;
  }
  robot::Body& body = model.bodies.back();
  body.frame.push_back({Kind::trans, robot::of(0), robot::of(1), robot::of(2)});
  body.frame.push_back(robot::rotz(robot::of(3)));
  body.frame.push_back(robot::roty(robot::of(4)));
  body.frame.push_back(robot::rotx(robot::of(5)));
  body.shapes = mover.shapes;
  return model;
}

/// Where it is, by formulas that are not the engine's.
Pose pose_of(const Q& q) {
  const auto turned = [](double angle_deg, const Vec3& axis) {
    return Eigen::AngleAxisd(angle_deg * std::numbers::pi / 180, axis);
  };
  Pose X = Pose::Identity();
  X.linear() =
      (turned(q[3], Vec3::UnitZ()) * turned(q[4], Vec3::UnitY()) * turned(q[5], Vec3::UnitX()))
          .toRotationMatrix();
  X.translation() = Vec3(q[0], q[1], q[2]);
  return X;
}

struct SoilStep {
  Q from, to;

  Q at(double s) const {
    Q q = from;
    for (std::size_t i = 0; i < q.size(); ++i) q[i] += s * (to[i] - from[i]);
    return q;
  }
  /// m: no point of the body goes farther.
  double way(double reach) const {
    const double turn =
        std::fabs(to[3] - from[3]) + std::fabs(to[4] - from[4]) + std::fabs(to[5] - from[5]);
    return std::hypot(to[0] - from[0], to[1] - from[1], to[2] - from[2]) +
           turn * std::numbers::pi / 180 * reach;
  }
  MotionKind kind() const {
    const bool slides = from[0] != to[0] || from[1] != to[1] || from[2] != to[2];
    const bool turns = from[3] != to[3] || from[4] != to[4] || from[5] != to[5];
    if (!slides && !turns) return MotionKind::kStill;
    if (!turns) return MotionKind::kTranslation;
    return slides ? MotionKind::kGeneral : MotionKind::kRotation;
  }
};

bool meets(const SoilMover& mover, const Pose& X_EB, const OffsetSoil& soil) {
  if (!soil.surface()) return false;
  return std::any_of(mover.parts.begin(), mover.parts.end(), [&](const SoilMover::Part& part) {
    const Pose X_ES = X_EB * part.X_BS;
    return soil.has(X_ES * part.inner) ||
           fcl_collide(part.fcl, X_ES, soil.surface(), Pose::Identity());
  });
}

/// A hit if at some pose a cube of a few times the tolerance around a point of the body lies in the
/// soil. Free if at no pose there is such a cube as small as is deep enough for the least depth by
/// which any column may be entered: between two poses the body does not go farther than the soil
/// is grown for the pose in the middle.
Truth soil_truth(const SoilMover& mover, const SoilStep& step, const Pose& X_EW,
                 SoilOffsets& offsets, double tolerance) {
  const double deep = 2.5 * tolerance;
  const double thin = std::max(0.25 * offsets.soil().thinnest(), 1e-5);
  const double shallow = (std::min(tolerance, thin) - kBand * 0.05) / std::sqrt(3.0);
  const auto is_in = [&](double s, double by) {
    return meets(mover, X_EW * pose_of(step.at(s)), offsets.by(by));
  };
  if (is_in(0, -deep) || is_in(1, -deep)) return Truth::kHit;
  const double whole = step.way(mover.reach);
  if (whole == 0) return is_in(0, -shallow) ? Truth::kNearBoundary : Truth::kFree;
  struct Interval {
    double s0, s1;
  };
  std::vector<Interval> open = {{0, 1}};
  bool near = false;
  int looks = 0;
  while (!open.empty()) {
    const auto [s0, s1] = open.back();
    open.pop_back();
    const double middle = 0.5 * (s0 + s1);
    const double travel = 0.5 * whole * (s1 - s0);
    // The next larger of a few sizes, so that few surfaces are made.
    double grown = 0.8;
    while (grown > 2 * travel && grown > 0.2 * shallow) grown *= 0.5;
    if (travel <= grown && !is_in(middle, grown - shallow)) continue;
    if (is_in(middle, -deep)) return Truth::kHit;
    if (travel < 0.1 * shallow || ++looks > kMostLooks) {
      near = true;
      // A hit may still be found elsewhere; that nothing is free is known.
      if (looks > kMostLooks) break;
      continue;
    }
    open.push_back({s0, middle});
    open.push_back({middle, s1});
  }
  return near ? Truth::kNearBoundary : Truth::kFree;
}

/// Soil on a site with one machine, and the same soil as the oracle has it.
class SoilSite {
 public:
  SoilSite(Random& random, SoilMover mover)
      : mover_(std::move(mover)),
        tolerance_(random.below(4) ? 1e-3 : 5e-3),
        offsets_(random_columns(random)),
        site_(tolerance_) {
    const Columns& soil = offsets_.soil();
    // Turned by anything, or not at all.
    const double heading = random.below(2) ? 0 : random.between(-180, 180);
    X_WE_.translation() = random.below(8) ? random.vector(5) : random.vector(2e3);
    const math::Pose turn = math::rotation_z_deg(heading);
    X_WE_.linear() = turn.linear();
    X_EW_.linear() =
        Eigen::AngleAxisd(-heading * std::numbers::pi / 180, Vec3::UnitZ()).toRotationMatrix();
    X_EW_.translation() = -(X_EW_.linear() * X_WE_.translation());
    const soil::Terrain top = terrain_of_side(soil, soil.top);
    bottom_ = std::make_shared<const soil::Terrain>(terrain_of_side(soil, soil.bottom));
    std::vector<geometry::Shape> shapes;
    for (const soil::Block& block : soil::blocks_between(*bottom_, top)) {
      const double cell = static_cast<double>(soil.cell) * 1e-3;
      shapes.push_back(test::box_shape(
          {block.first_column * cell, block.first_row * cell,
           static_cast<double>(block.bottom) * 1e-3},
          {block.end_column * cell, block.end_row * cell, static_cast<double>(block.top) * 1e-3}));
    }
    component_ = site_.add_component("soil", prepare(shapes), X_WE_, 1);
    auto model = std::make_shared<const robot::RobotModel>(free_flyer(mover_));
    const robot::Mounting mounting = robot::mounting_of(*model);
    const Vec3 away = X_WE_ * Vec3(0, 0, 50);
    robot_ = site_.add_robot(site::make_site_robot("flyer", model, mounting),
                             {away.x(), away.y(), away.z(), 0, 0, 0});
    view_.emplace(site_, robot_);
  }

  /// From the second stage on cell by cell.
  void open() {
    site_.open_soil(component_, terrain_of_side(offsets_.soil(), offsets_.soil().top), bottom_);
  }

  void change(Random& random) {
    Columns soil = offsets_.soil();
    const bool is_mesh = std::holds_alternative<geometry::Mesh>(mover_.shapes.front().solid);
    const auto heights = random_change(random, soil, is_mesh);
    for (const auto& [cell, height] : heights) soil.top[static_cast<std::size_t>(cell)] = height;
    site_.set_surface(component_, heights);
    offsets_ = SoilOffsets(std::move(soil));
  }

  void ask(Random& random, CaseRecord& record) {
    SoilStep step = random_step(random);
    const bool grazes = random.below(kSoilGrazeEvery) == 0 && graze(random, step);
    Outcome outcome;
    outcome.motion = step.kind();
    outcome.grazes = grazes;
    outcome.truth = soil_truth(mover_, step, X_EW_, offsets_, tolerance_);
    set_place(step.from);
    // A step that moves nothing is no step: what stands is asked for otherwise.
    const auto hit = outcome.motion == MotionKind::kStill
                         ? view_->blocked_at(step.from)
                         : view_->propose({step.from, step.to, site_.now(), 0});
    outcome.engine_hit = hit.has_value();
    record.outcomes.push_back(outcome);
    record.note([&] {
      std::string text =
          fmt::format("{}tolerance {}, truth {}, engine {}: from", mover_.text, tolerance_,
                      static_cast<int>(outcome.truth), outcome.engine_hit);
      for (const double value : step.from) text += fmt::format(" {}", value);
      text += " to";
      for (const double value : step.to) text += fmt::format(" {}", value);
      return text;
    });
    last_ = hit ? step.from : step.to;
  }

 private:
  void set_place(const Q& q) {
    if (site_.configuration(robot_) == q) return;
    site::MachineState state = site_.machine_state(robot_);
    state.q = q;
    state.step.reset();
    site_.set_machine_state(robot_, state);
  }

  bool is_refused(const SoilStep& step) {
    set_place(step.from);
    return view_->refusal({step.from, step.to, site_.now(), 0}).has_value();
  }

  SoilStep random_step(Random& random) {
    const Columns& soil = offsets_.soil();
    const double cell = static_cast<double>(soil.cell) * 1e-3;
    SoilStep step;
    const int kind = random.below(6);
    if (!last_.empty() && random.below(3) == 0) {
      // On from where it is.
      step.from = last_;
    } else {
      const int column = random.below(soil.columns);
      const int row = random.below(soil.rows);
      const double top = static_cast<double>(soil.top[soil.index(column, row)]) * 1e-3;
      Vec3 p_E((column + random.unit()) * cell, (row + random.unit()) * cell, top);
      step.from.assign(6, 0);
      const bool rests = mover_.half.z() > 0 && random.below(4) == 0;
      if (rests) {
        // Flat on the ground, or pressed into it, or just above it.
        const double turn = math::atan2_deg(X_WE_.linear()(1, 0), X_WE_.linear()(0, 0));
        step.from[3] = turn + 90 * random.below(4);
        constexpr double kPressed[] = {0, 0.5, -0.1, 4, -3};
        p_E.z() += mover_.half.z() - kPressed[random.below(5)] * tolerance_;
      } else {
        for (std::size_t i = 3; i < 6; ++i) step.from[i] = random.between(-180, 180);
        p_E.z() += random.between(-0.4, 0.9) * std::min(mover_.reach, 0.8);
      }
      const Vec3 p_W = X_WE_ * p_E;
      for (int i = 0; i < 3; ++i) step.from[static_cast<std::size_t>(i)] = p_W[i];
    }
    step.to = step.from;
    const double share = random.below(4) ? 1 : 1e-2;
    if (kind == 0) {
      step.to[2] += random.between(-0.8, 0.8) * share;  // straight down or up
    } else if (kind == 1) {
      const double angle = random.between(0, 360);
      const double way = random.between(0.05, 1.2) * share;
      step.to[0] += way * math::cos_deg(angle);
      step.to[1] += way * math::sin_deg(angle);
    } else if (kind < 5) {
      for (std::size_t i = 0; i < 3 && kind != 4; ++i)
        step.to[i] += random.between(-0.6, 0.6) * share;
      for (std::size_t i = 3; i < 6 && kind != 2; ++i) {
        if (random.below(2)) step.to[i] += random.between(-50, 50) * share;
      }
    } else {
      for (std::size_t i = 0; i < 6; ++i) step.to[i] += random.between(-0.02, 0.02);
    }
    return step;
  }

  /// Moves the step up or down to where the engine's answer changes, and a little on. False: it
  /// does not change.
  bool graze(Random& random, SoilStep& step) {
    const auto raised = [&](double by) {
      SoilStep other = step;
      other.from[2] += by;
      other.to[2] += by;
      return other;
    };
    const bool refused = is_refused(step);
    double same = 0;
    double other = refused ? 0.3 : -0.3;
    for (int i = 0; is_refused(raised(other)) == refused; ++i) {
      if (i == 2) return false;
      other *= 2;
    }
    while (std::fabs(other - same) > 0.2 * tolerance_) {
      const double middle = 0.5 * (same + other);
      (is_refused(raised(middle)) == refused ? same : other) = middle;
    }
    step = raised(same + random.between(-4, 4) * tolerance_);
    return true;
  }

  SoilMover mover_;
  double tolerance_;
  SoilOffsets offsets_;
  site::SiteWorld site_;
  Pose X_WE_ = Pose::Identity(), X_EW_ = Pose::Identity();
  std::shared_ptr<const soil::Terrain> bottom_;  // shared: the site's, too
  int component_ = -1;
  int robot_ = -1;
  std::optional<site::RobotView> view_;
  Q last_;
};

void soil_steps(Random& random, CaseRecord& record) {
  SoilSite site(random, random_mover(random));
  for (int stage = 0; stage < kStages; ++stage) {
    if (stage == 1) site.open();
    if (stage > 0) site.change(random);
    record.note([&] { return fmt::format("stage {}", stage); });
    for (int i = 0; i < kStepsAStage; ++i) site.ask(random, record);
  }
}

constexpr Generator kSoilGenerators[] = {
    {"soil", "bodies over soil that is dug and heaped", 1, kStages* kStepsAStage, soil_steps},
};

}  // namespace

std::span<const Generator> soil_generators() { return kSoilGenerators; }

}  // namespace rubicon::collision::proof
