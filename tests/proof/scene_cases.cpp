#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "tests/proof/generators.hpp"
#include "tests/proof/mesh_models.hpp"
#include "tests/proof/solid.hpp"
#include "tests/unit/collision/meshes.hpp"

namespace rubicon::collision::proof {
namespace {

constexpr double kSceneTolerance = 1e-3;
constexpr int kQueries = 16;

/// A body of convex pieces or triangles.
struct Part {
  BodyPtr body;
  Pieces pieces;
};

Part solid_part(const Solid& solid) {
  return {prepare({solid.shape()}), pieces_of(solid.polytope())};
}

/// Two boxes that form one body.
Part compound(Random& random) {
  Part part;
  std::vector<geometry::Shape> shapes;
  for (int i = 0; i < 2; ++i) {
    const Solid solid = box_solid(
        Vec3{random.between(0.05, 0.4), random.between(0.05, 0.4), random.between(0.05, 0.4)});
    geometry::Shape shape = solid.shape();
    shape.X_BS = random.pose(0.5);
    part.pieces.add(placed(solid.polytope(), shape.X_BS));
    shapes.push_back(shape);
  }
  part.body = prepare(shapes);
  return part;
}

Part random_part(Random& random) {
  switch (random.below(8)) {
    case 0:
      return compound(random);
    case 3: {
      // Open, so that its triangles are all there is to it.
      const MeshModel& ground = coarse_models()[2];
      return {ground.body, ground.pieces};
    }
    case 1:
      return solid_part(random_prism(random, random.between(0.2, 0.6)));
    case 2:
      // Flat, like a panel.
      return solid_part(box_solid(
          Vec3{random.between(0.3, 1.5), random.between(0.02, 0.1), random.between(0.3, 1.5)}));
    default:
      return solid_part(box_solid(
          Vec3{random.between(0.05, 0.5), random.between(0.05, 0.5), random.between(0.05, 0.5)}));
  }
}

/// The world beside a plain list of what stands in it.
struct Scene {
  struct Obstacle {
    Part part;
    Pose X_WB;
  };
  CollisionWorld world;
  std::map<ObstacleId, Obstacle> obstacles;
  double size = 1;

  void insert(Part part, const Pose& X_WB) {
    const ObstacleId id = world.insert(part.body, X_WB);
    obstacles.emplace(id, Obstacle{std::move(part), X_WB});
  }
  void insert_random(Random& random) {
    Pose X = random.pose(size);
    if (random.below(2)) X.linear().setIdentity();
    insert(random_part(random), X);
  }
  void remove_random(Random& random) {
    auto victim = obstacles.begin();
    std::advance(victim, random.below(static_cast<int>(obstacles.size())));
    world.remove(victim->first);
    obstacles.erase(victim);
  }
};

/// One item of the query as the oracle sees it.
struct Mover {
  Part part;
  Path path;
  bool against_world = true;
};

/// A pair in the order in which the first blocking one is asked for.
struct Candidate {
  SweptHit hit;
  Truth truth = Truth::kFree;
};

std::vector<Candidate> candidates(const Scene& scene, const std::vector<Mover>& movers,
                                  const SweptQuery& query) {
  std::vector<Candidate> result;
  for (int i = 0; i < static_cast<int>(movers.size()); ++i) {
    if (!movers[i].against_world) continue;
    for (const auto& [id, obstacle] : scene.obstacles) {
      if (std::find(query.ignore.begin(), query.ignore.end(), id) != query.ignore.end()) continue;
      const Truth truth = pieces_truth(movers[i].part.pieces, movers[i].path, obstacle.part.pieces,
                                       standing(obstacle.X_WB), kSceneTolerance);
      if (truth != Truth::kFree) result.push_back({SweptHit{i, id, std::nullopt}, truth});
    }
  }
  for (const auto& [first, second] : query.pairs) {
    const Truth truth =
        pieces_truth(movers[first].part.pieces, movers[first].path, movers[second].part.pieces,
                     movers[second].path, kSceneTolerance);
    if (truth != Truth::kFree) result.push_back({SweptHit{first, std::nullopt, second}, truth});
  }
  return result;
}

bool same(const SweptHit& a, const SweptHit& b) {
  return a.item == b.item && a.obstacle == b.obstacle && a.other_item == b.other_item;
}

/// The answer is right if it names a pair that is not free and comes before no surer one. Only the
/// first sure hit and the pairs too near to call before it will do.
Outcome judged(const std::vector<Candidate>& all, const SweptResult& answer) {
  Outcome outcome;
  outcome.engine_hit = answer.hit.has_value();
  const auto sure = std::find_if(all.begin(), all.end(),
                                 [](const Candidate& c) { return c.truth == Truth::kHit; });
  const auto end = sure == all.end() ? sure : sure + 1;
  const bool named = answer.hit && std::any_of(all.begin(), end, [&](const Candidate& c) {
                       return same(c.hit, *answer.hit);
                     });
  if (sure != all.end()) {
    // A wrong pair counts as a miss of the right one.
    outcome.truth = Truth::kHit;
    outcome.engine_hit = named;
  } else {
    outcome.truth = all.empty() || (answer.hit && !named) ? Truth::kFree : Truth::kNearBoundary;
  }
  return outcome;
}

std::string text_of_hit(const std::optional<SweptHit>& hit) {
  if (!hit) return "nothing";
  return hit->obstacle ? fmt::format("item {} and obstacle {}", hit->item, *hit->obstacle)
                       : fmt::format("items {} and {}", hit->item, hit->other_item.value_or(-1));
}

void ask(const Scene& scene, Random& random, CaseRecord& record) {
  std::vector<Mover> movers;
  SweptQuery query;
  query.contact_tolerance = kSceneTolerance;
  const Vec3 middle = random.vector(scene.size);
  PathSizes sizes;
  sizes.radius = random.below(2) ? 3 : 20;
  sizes.angle_deg = 5;
  for (int count = 1 + random.below(3); count > 0; --count) {
    Pose X = random.pose(1);
    X.translation() += middle;
    movers.push_back({random_part(random), random_path(random, X, sizes), random.below(5) != 0});
  }
  const int count = static_cast<int>(movers.size());
  for (int i = 0; i < count; ++i) {
    query.items.push_back(
        test::item(*movers[i].part.body, movers[i].path.motion, movers[i].against_world));
    for (int j = 0; j < i; ++j) {
      if (random.below(2)) query.pairs.emplace_back(i, j);
    }
  }
  for (const auto& [id, obstacle] : scene.obstacles) {
    if (random.below(20) == 0) query.ignore.insert(query.ignore.begin(), id);
  }
  const std::vector<Candidate> all = candidates(scene, movers, query);
  const SweptResult answer = scene.world.test(query);
  Outcome outcome = judged(all, answer);
  outcome.motion = count > 1 ? MotionKind::kPair : movers.front().path.kind;
  record.outcomes.push_back(outcome);
  record.note([&] {
    std::string text = fmt::format("{} obstacles, {} items; the engine names {}; of all pairs:",
                                   scene.obstacles.size(), count, text_of_hit(answer.hit));
    for (const Candidate& candidate : all) {
      text += fmt::format(" {} ({});", text_of_hit(std::optional(candidate.hit)),
                          candidate.truth == Truth::kHit ? "hit" : "near");
    }
    return text;
  });
}

/// A site that grows and shrinks between queries of up to three bodies; the oracle asks for each
/// pair, in order.
void scene(Random& random, CaseRecord& record) {
  Scene site;
  constexpr int kCounts[] = {0, 1, 3, 10, 30, 100, 300};
  const int count = kCounts[random.below(7)];
  // About one body in a cube of 1.2 m: queries meet nothing, something, several.
  site.size = 0.6;
  while (8 * site.size * site.size * site.size < 1.7 * count) site.size *= 1.1;
  if (random.below(3) == 0)
    site.insert(solid_part(box_solid(Vec3(2 * site.size, 2 * site.size, 0.1))),
                at(0, 0, -site.size));
  for (int i = 0; i < count; ++i) site.insert_random(random);
  for (int i = 0; i < kQueries; ++i) {
    for (int change = random.below(4); change > 0; --change) {
      if (!site.obstacles.empty() && random.below(2)) {
        site.remove_random(random);
      } else {
        site.insert_random(random);
      }
    }
    ask(site, random, record);
  }
}

constexpr Generator kSceneGenerators[] = {
    {"scene", "many obstacles, some come and go", 8, kQueries, scene},
};

}  // namespace

std::span<const Generator> scene_generators() { return kSceneGenerators; }

}  // namespace rubicon::collision::proof
