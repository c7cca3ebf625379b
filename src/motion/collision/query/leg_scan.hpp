#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "src/motion/collision/base/bounds.hpp"
#include "src/motion/collision/leg_query.hpp"
#include "src/motion/collision/query/leg_kernels.hpp"
#include "src/motion/collision/sweep/body.hpp"

namespace rubicon::collision {

/// One that stands and may be met.
struct ScannedObstacle {
  ObstacleId id = 0;
  const Body* body = nullptr;
  const Placement* X_WC = nullptr;
};

/// The room of a scan, kept for the next one.
struct LegScanRoom {
  std::vector<math::LaneFrame> frames;
  std::vector<LegPart> parts;
  std::vector<LanePart> placed;
  std::vector<int> placed_in;           ///< to each part: in which look it was placed last
  std::vector<std::size_t> first_part;  ///< of each item, and one more
  std::vector<StandingBox> standing;
  std::vector<LegPair> pairs;
  std::vector<ScannedObstacle> found;
  std::vector<ObstacleId> obstacles;
  std::vector<std::size_t> first_standing;  ///< of each of these, and one more
  std::vector<LegCandidate> candidates;
};

/// Answers a query about a leg by looking at the middles of four parts of it. A box that holds a
/// part of a body in the whole of such an interval is found from where it is in the middle, how it
/// moves there, and what it accelerates at most: pairs that such boxes are apart of are done with
/// for the interval, and only the others are looked at in quarters of it. Boxes around parts decide
/// what is free; what is met is only known of parts that are boxes. What stays open in short
/// intervals goes to the exact test. docs/collision.md, Legs.
class LegScan {
 public:
  using Collect = std::function<void(const Bounds&, std::vector<ScannedObstacle>&)>;

  LegScan(const LegQuery& query, const LegMotion& motion, const Collect& collect,
          LegScanRoom& room);
  LegAnswer run();

 private:
  enum class Outcome { free, met, open };

  void add_parts();
  void add_pairs();
  void collect_obstacles();
  void place(const LegIntervals& intervals, int part);
  LegIntervals begin_look(double from, double to);
  LegIntervals look_at(double from, double to);
  Outcome scan(const LegIntervals& intervals, double from, double to, std::size_t begin,
               std::size_t end, int depth);
  Outcome test_exactly(double from, double to);
  bool is_short(std::size_t begin, std::size_t end) const;
  void note_free(double until);
  void note_met(double share, const LegCandidate& candidate);

  const LegQuery& query_;
  const LegMotion& motion_;
  const Collect& collect_;
  LegScanRoom& room_;
  const LegKernels& kernels_;
  LegAnswer answer_;
  double margin_ = 0;  ///< m: so much more than what is needed is asked for
  int looks_ = 0;
  int exact_tests_ = 0;
};

}  // namespace rubicon::collision
