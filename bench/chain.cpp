#include "bench/chain.hpp"

#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/narrowphase/collision.h>
#include <fmt/format.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/PathSimplifier.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>
#include <time.h>

#include <cmath>
#include <cstdlib>
#include <numbers>

namespace rubicon::bench {

namespace {

constexpr double kRadians = std::numbers::pi / 180;

Eigen::Vector3d unit(char axis) {
  return axis == 'x'   ? Eigen::Vector3d::UnitX()
         : axis == 'y' ? Eigen::Vector3d::UnitY()
                       : Eigen::Vector3d::UnitZ();
}

double processor_seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
}

std::string box_text(const ChainBox& box) {
  const Eigen::Vector3d& h = box.half;
  return fmt::format("box({}, {}, {}, {}, {}, {})", -h.x(), -h.y(), -h.z(), h.x(), h.y(), h.z());
}

}  // namespace

Move shift(double x, double y, double z) { return {'t', {x, y, z}, 0}; }
Move turn(char axis, double degrees) { return {axis, Eigen::Vector3d::Zero(), degrees}; }

Eigen::Isometry3d pose_of(const Moves& moves) {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  for (const Move& move : moves) {
    if (move.what == 't') {
      X.translate(move.shift);
    } else {
      X.rotate(Eigen::AngleAxisd(move.degrees * kRadians, unit(move.what)));
    }
  }
  return X;
}

std::string text_of(const Moves& moves) {
  std::string text;
  for (const Move& move : moves) {
    text += text.empty() ? "" : " * ";
    text += move.what == 't'
                ? fmt::format("trans({}, {}, {})", move.shift.x(), move.shift.y(), move.shift.z())
                : fmt::format("rot{}({})", move.what, move.degrees);
  }
  return text;
}

std::size_t Chain::joints() const {
  std::size_t count = 0;
  for (const ChainLink& link : links) count += link.axis != '-';
  return count;
}

std::vector<Eigen::Isometry3d> Chain::poses(const std::vector<double>& q_deg) const {
  std::vector<Eigen::Isometry3d> all;
  std::size_t joint = 0;
  for (const ChainLink& link : links) {
    Eigen::Isometry3d X = pose_of(link.fixed);
    if (link.parent >= 0) X = all[static_cast<std::size_t>(link.parent)] * X;
    if (link.axis != '-') {
      X.rotate(Eigen::AngleAxisd(link.sign * q_deg[joint++] * kRadians, unit(link.axis)));
    }
    all.push_back(X);
  }
  return all;
}

std::string Chain::robot_text() const {
  std::string text = fmt::format("robot {} {{\n  time_step 1;\n", name);
  for (const ChainLink& link : links) {
    const bool root = link.parent < 0;
    text += fmt::format("  body {}{} {{\n", link.name,
                        root ? "" : " on " + links[static_cast<std::size_t>(link.parent)].name);
    std::string frame = text_of(link.fixed);
    if (link.axis != '-') {
      text += fmt::format("    param phi range({}, {}) step(5) speed({} deg/s) start({});\n",
                          link.lower, link.upper, link.speed, (link.lower + link.upper) / 2);
      frame += fmt::format("{}rot{}({}phi)", frame.empty() ? "" : " * ", link.axis,
                           link.sign < 0 ? "-" : "");
    }
    if (!frame.empty()) text += fmt::format("    frame {};\n", frame);
    for (const ChainBox& box : link.boxes) {
      text += fmt::format("    shape {}{}{};\n", box_text(box), box.at.empty() ? "" : " at ",
                          text_of(box.at));
    }
    text += "  }\n";
  }
  const int count = static_cast<int>(links.size());
  for (int a = 0; a < count; ++a) {
    for (int b = a + 2; b < count; ++b) {
      if (meets_itself && b - a > apart) continue;
      text += fmt::format("  touching {} {};\n", links[static_cast<std::size_t>(a)].name,
                          links[static_cast<std::size_t>(b)].name);
    }
  }
  return text +
         fmt::format("  tool {};\n  behaviour {{ chain {{ follow }}; }}\n}}\n", links.back().name);
}

std::string plan_text(const Chain& chain, const ChainProblem& problem) {
  std::string text = fmt::format("plan problem {{\n  robot \"{}.robot\";\n", chain.name);
  for (std::size_t i = 0; i < problem.obstacles.size(); ++i) {
    const ChainBox& box = problem.obstacles[i];
    text +=
        fmt::format("  component c{} {{ shape {}; at {}; }}\n", i, box_text(box), text_of(box.at));
  }
  const auto values = [&](const std::vector<double>& q) {
    std::string list;
    std::size_t joint = 0;
    for (const ChainLink& link : chain.links) {
      if (link.axis == '-') continue;
      list += fmt::format("{}{}.phi {}", list.empty() ? "" : ", ", link.name, q[joint++]);
    }
    return list;
  };
  return text +
         fmt::format("  start {};\n  goal {};\n}}\n", values(problem.start), values(problem.goal));
}

struct FclChain::Impl {
  const Chain* chain = nullptr;
  std::vector<std::unique_ptr<fcl::CollisionObjectd>> standing;
  fcl::DynamicAABBTreeCollisionManagerd tree;
  struct Moved {
    std::size_t link = 0;
    Eigen::Isometry3d X_L;
    std::unique_ptr<fcl::CollisionObjectd> object;
  };
  std::vector<Moved> moved;
};

FclChain::FclChain(const Chain& chain, const std::vector<ChainBox>& obstacles, double shrunk)
    : impl_(std::make_unique<Impl>()) {
  impl_->chain = &chain;
  const auto object = [](const Eigen::Vector3d& half, const Eigen::Isometry3d& X) {
    auto made = std::make_unique<fcl::CollisionObjectd>(
        std::make_shared<fcl::Boxd>(Eigen::Vector3d(2 * half)), X);
    made->computeAABB();
    return made;
  };
  for (const ChainBox& box : obstacles) {
    impl_->standing.push_back(object(box.half, pose_of(box.at)));
    impl_->tree.registerObject(impl_->standing.back().get());
  }
  impl_->tree.setup();
  for (std::size_t i = 0; i < chain.links.size(); ++i) {
    for (const ChainBox& box : chain.links[i].boxes) {
      const Eigen::Vector3d half = box.half - Eigen::Vector3d::Constant(shrunk);
      impl_->moved.push_back({i, pose_of(box.at), object(half, Eigen::Isometry3d::Identity())});
    }
  }
}

FclChain::~FclChain() = default;

bool FclChain::free(const std::vector<double>& q_deg) const {
  const Chain& chain = *impl_->chain;
  const std::vector<Eigen::Isometry3d> poses = chain.poses(q_deg);
  for (Impl::Moved& each : impl_->moved) {
    each.object->setTransform(poses[each.link] * each.X_L);
    each.object->computeAABB();
  }
  bool met = false;
  const auto meets_other = [](fcl::CollisionObjectd* a, fcl::CollisionObjectd* b, void* data) {
    const fcl::CollisionRequestd request;
    fcl::CollisionResultd result;
    fcl::collide(a, b, request, result);
    *static_cast<bool*>(data) = result.isCollision();
    return result.isCollision();
  };
  for (const Impl::Moved& each : impl_->moved) {
    if (chain.links[each.link].parent < 0 && chain.links[each.link].axis == '-') continue;
    impl_->tree.collide(each.object.get(), &met, meets_other);
    if (met) return false;
  }
  if (!chain.meets_itself) return true;
  for (const Impl::Moved& a : impl_->moved) {
    for (const Impl::Moved& b : impl_->moved) {
      if (static_cast<int>(b.link) - static_cast<int>(a.link) <= chain.apart) continue;
      if (!a.object->getAABB().overlap(b.object->getAABB())) continue;
      meets_other(a.object.get(), b.object.get(), &met);
      if (met) return false;
    }
  }
  return true;
}

OmplWay rrt_connect_of_ompl(const Chain& chain, const FclChain& world, const ChainProblem& problem,
                            double resolution, unsigned seed, double limit, bool simplify) {
  namespace ob = ::ompl::base;
  namespace og = ::ompl::geometric;
  ::ompl::msg::setLogLevel(::ompl::msg::LOG_NONE);
  ::ompl::RNG::setSeed(seed);
  const auto count = static_cast<unsigned>(chain.joints());
  const auto space = std::make_shared<ob::RealVectorStateSpace>(count);
  ob::RealVectorBounds bounds(count);
  unsigned joint = 0;
  for (const ChainLink& link : chain.links) {
    if (link.axis == '-') continue;
    bounds.setLow(joint, link.lower * kRadians);
    bounds.setHigh(joint++, link.upper * kRadians);
  }
  space->setBounds(bounds);
  og::SimpleSetup setup(space);
  std::vector<double> q(count);
  setup.setStateValidityChecker([&](const ob::State* state) {
    for (unsigned i = 0; i < count; ++i) {
      q[i] = state->as<ob::RealVectorStateSpace::StateType>()->values[i] / kRadians;
    }
    return world.free(q);
  });
  setup.getSpaceInformation()->setStateValidityCheckingResolution(resolution);
  ob::ScopedState<> start(space);
  ob::ScopedState<> goal(space);
  for (unsigned i = 0; i < count; ++i) {
    start[i] = problem.start[i] * kRadians;
    goal[i] = problem.goal[i] * kRadians;
  }
  setup.setStartAndGoalStates(start, goal);
  setup.setPlanner(std::make_shared<og::RRTConnect>(setup.getSpaceInformation()));
  setup.setup();
  OmplWay way;
  const double begin = processor_seconds();
  const bool solved = setup.solve(limit) == ob::PlannerStatus::EXACT_SOLUTION;
  if (solved && simplify) setup.simplifySolution();
  way.seconds = processor_seconds() - begin;
  if (!solved) return way;
  for (const ob::State* state : setup.getSolutionPath().getStates()) {
    for (unsigned i = 0; i < count; ++i) {
      q[i] = state->as<ob::RealVectorStateSpace::StateType>()->values[i] / kRadians;
    }
    way.points.push_back(q);
  }
  return way;
}

bool meets(const FclChain& world, const std::vector<std::vector<double>>& way, double step) {
  for (std::size_t k = 0; k + 1 < way.size(); ++k) {
    double most = 0;
    for (std::size_t i = 0; i < way[k].size(); ++i) {
      most = std::max(most, std::fabs(way[k + 1][i] - way[k][i]));
    }
    const int parts = static_cast<int>(std::ceil(most / step)) + 1;
    std::vector<double> q(way[k].size());
    for (int n = 0; n <= parts; ++n) {
      for (std::size_t i = 0; i < q.size(); ++i) {
        q[i] = way[k][i] + (way[k + 1][i] - way[k][i]) * n / parts;
      }
      if (!world.free(q)) return true;
    }
  }
  return false;
}

}  // namespace rubicon::bench
