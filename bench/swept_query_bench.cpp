#include <benchmark/benchmark.h>
#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/narrowphase/continuous_collision.h>

#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "src/collision/swept_query.hpp"

// One load among standing boxes, a step of half a metre or of five degrees with a lever of ten
// metres. Beside ours: FCL's tree with continuousCollide as it comes, which misses thin walls.

namespace {

using namespace rubicon;
using collision::Vec3;
using math::Pose;

constexpr int kSteps = 512;

struct Box {
  Vec3 half = Vec3::Constant(0.5);
  Pose X = Pose::Identity();
};

double between(std::mt19937& engine, double low, double high) {
  return low + (high - low) * static_cast<double>(engine()) * 0x1p-32;
}

/// `count` boxes in a square site of constant density, panels in every direction.
std::vector<Box> site(int count) {
  std::mt19937 engine(1);
  const double side = 4 * std::sqrt(static_cast<double>(count));
  std::vector<Box> boxes;
  for (int i = 0; i < count; ++i) {
    const double x = between(engine, 0, side);
    const double y = between(engine, 0, side);
    const double z = between(engine, 0, 12);
    Box box;
    box.half = Vec3(between(engine, 0.5, 3), between(engine, 0.05, 0.1), 1.5);
    box.X = math::translation(x, y, z) * math::rotation_z_deg(between(engine, 0, 360));
    boxes.push_back(box);
  }
  return boxes;
}

std::vector<geometry::ScrewMotion> steps(int count, bool rotate) {
  std::mt19937 engine(2);
  const double side = 4 * std::sqrt(static_cast<double>(count));
  std::vector<geometry::ScrewMotion> result;
  for (int i = 0; i < kSteps; ++i) {
    geometry::ScrewMotion step;
    const double x = between(engine, 0, side);
    const double y = between(engine, 0, side);
    const double z = between(engine, 0, 12);
    step.X0 = math::translation(x, y, z) * math::rotation_z_deg(between(engine, 0, 360));
    if (rotate) {
      step.point = step.X0.translation() + Vec3(10, 0, 0);
      step.angle_deg = 5;
    } else {
      step.slide = Vec3(0.5, 0, 0);
    }
    result.push_back(step);
  }
  return result;
}

const Vec3 kLoadHalf(1, 0.1, 0.5);

collision::BodyPtr body_of(const Vec3& half) {
  return collision::prepare({{geometry::Box{-half, half}, Pose::Identity()}});
}

void ours(benchmark::State& state, bool rotate) {
  const int count = static_cast<int>(state.range(0));
  collision::CollisionWorld world;
  for (const Box& box : site(count)) world.insert(body_of(box.half), box.X);
  const collision::BodyPtr load = body_of(kLoadHalf);
  std::vector<collision::SweptQuery> queries;
  for (const geometry::ScrewMotion& step : steps(count, rotate)) {
    collision::SweptQuery query;
    query.items.resize(1);
    query.items[0].moving.body = load.get();
    query.items[0].moving.motion.kind = step;
    queries.push_back(std::move(query));
  }
  int hits = 0;
  std::size_t next = 0;
  for (auto _ : state) {
    hits += world.test(queries[next]).hit.has_value();
    next = (next + 1) % queries.size();
  }
  state.counters["hit_share"] = static_cast<double>(hits) / static_cast<double>(state.iterations());
}

void fcl_default(benchmark::State& state, bool rotate) {
  const int count = static_cast<int>(state.range(0));
  std::vector<std::unique_ptr<fcl::CollisionObjectd>> objects;
  fcl::DynamicAABBTreeCollisionManagerd tree;
  for (const Box& box : site(count)) {
    objects.push_back(std::make_unique<fcl::CollisionObjectd>(
        std::make_shared<fcl::Boxd>(2 * box.half), fcl::Transform3d(box.X)));
    tree.registerObject(objects.back().get());
  }
  tree.setup();
  const auto load = std::make_shared<fcl::Boxd>(2 * kLoadHalf);
  const auto all_steps = steps(count, rotate);
  struct Question {
    const fcl::Boxd* load = nullptr;
    fcl::Transform3d start, end;
    const fcl::CollisionObjectd* swept = nullptr;
    bool hit = false;
  };
  int hits = 0;
  std::size_t next = 0;
  for (auto _ : state) {
    const geometry::Motion motion{all_steps[next]};
    next = (next + 1) % all_steps.size();
    Question question;
    question.load = load.get();
    question.start = motion.pose(0);
    question.end = motion.pose(1);
    const Vec3 middle = 0.5 * (question.start.translation() + question.end.translation());
    const double reach =
        kLoadHalf.norm() + (question.end.translation() - question.start.translation()).norm();
    fcl::CollisionObjectd swept(std::make_shared<fcl::Boxd>(Vec3::Constant(2 * reach)),
                                fcl::Transform3d(Eigen::Translation3d(middle)));
    question.swept = &swept;
    tree.collide(&swept, &question,
                 [](fcl::CollisionObjectd* first, fcl::CollisionObjectd* second, void* data) {
                   auto& asked = *static_cast<Question*>(data);
                   const fcl::CollisionObjectd* standing = first == asked.swept ? second : first;
                   const fcl::ContinuousCollisionRequestd request;
                   fcl::ContinuousCollisionResultd result;
                   fcl::continuousCollide(
                       asked.load, asked.start, asked.end, standing->collisionGeometry().get(),
                       standing->getTransform(), standing->getTransform(), request, result);
                   asked.hit = result.is_collide;
                   return asked.hit;
                 });
    hits += question.hit;
  }
  state.counters["hit_share"] = static_cast<double>(hits) / static_cast<double>(state.iterations());
}

BENCHMARK_CAPTURE(ours, translation, false)->RangeMultiplier(10)->Range(100, 10000);
BENCHMARK_CAPTURE(ours, rotation, true)->RangeMultiplier(10)->Range(100, 10000);
BENCHMARK_CAPTURE(fcl_default, translation, false)->RangeMultiplier(10)->Range(100, 10000);
BENCHMARK_CAPTURE(fcl_default, rotation, true)->RangeMultiplier(10)->Range(100, 10000);

}  // namespace
