#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <string>
#include <utility>
#include <vector>

/// Machines whose bodies hang on each other by one joint each, told once: for the text of a robot
/// file, and for FCL and OMPL, which know nothing of that text.
namespace rubicon::bench {

/// A pose, as turns and shifts one after the other.
struct Move {
  char what = 't';  ///< t: a shift; x, y, z: a turn about that axis
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
  double degrees = 0;
};
using Moves = std::vector<Move>;
Move shift(double x, double y, double z);
Move turn(char axis, double degrees);
Eigen::Isometry3d pose_of(const Moves& moves);
std::string text_of(const Moves& moves);

struct ChainBox {
  Moves at;
  Eigen::Vector3d half;
};

struct ChainLink {
  std::string name;
  int parent = -1;
  Moves fixed = {};
  char axis = '-';  ///< of its joint; -: it has none
  double sign = 1;
  double lower = 0, upper = 0, speed = 0;  ///< degrees, degrees a second
  std::vector<ChainBox> boxes = {};
};

struct Chain {
  std::string name;
  std::vector<ChainLink> links;  ///< parents first
  /// Links further apart than that are tested against each other.
  int apart = 2;
  bool meets_itself = true;

  std::size_t joints() const;
  std::vector<Eigen::Isometry3d> poses(const std::vector<double>& q_deg) const;
  std::string robot_text() const;
};

/// A problem: what stands, where the machine begins and where it shall end (degrees).
struct ChainProblem {
  std::vector<ChainBox> obstacles;
  std::vector<double> start, goal;
};
std::string plan_text(const Chain& chain, const ChainProblem& problem);

/// The same by FCL: single poses.
class FclChain {
 public:
  /// `shrunk`: by so much each box of the machine is smaller on each side, m.
  FclChain(const Chain& chain, const std::vector<ChainBox>& obstacles, double shrunk = 0);
  ~FclChain();
  bool free(const std::vector<double>& q_deg) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// RRTConnect of OMPL, poses tested by FCL every `resolution` of the extent of the space; its way,
/// and the seconds that solving took. None: not within `limit` seconds.
struct OmplWay {
  std::vector<std::vector<double>> points;
  double seconds = 0;
};
OmplWay rrt_connect_of_ompl(const Chain& chain, const FclChain& world, const ChainProblem& problem,
                            double resolution, unsigned seed, double limit, bool simplify = false);

/// Whether a way meets anything at poses every `step` degrees of the joint that moves most.
bool meets(const FclChain& world, const std::vector<std::vector<double>>& way, double step);

}  // namespace rubicon::bench
