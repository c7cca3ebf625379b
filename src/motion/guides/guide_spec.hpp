#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rubicon::guides {

/// How a guide finds its way (docs/guides.md).
enum class GuideKind : std::uint8_t {
  rrt,
  rrt_nonuniform,
  rrt_plus,
  rrt_limcon,
  rrt_connect,
  astar,
  prm,
  dstar_lite,
  drrt,
  potential,
  ompl,  ///< a planner of OMPL, by its name
  // of vehicles, without a map
  bug1,
  bug2,
  visbug21,
  pledge,
  simple,
  tangent,
  ace,
  visibility,  ///< with one
  lanes        ///< of the vehicles of a fleet; plans do not name it
};

/// Whether it goes round outlines in the plan view: for machines that travel.
constexpr bool is_travel(GuideKind kind) {
  return kind >= GuideKind::bug1 && kind <= GuideKind::visibility;
}

/// Which nodes of a lattice are neighbours: those that are a pitch apart in one parameter, or in
/// any number of them.
enum class Neighbours : std::uint8_t { straight, all };

/// What is left to the goal, as a lattice estimates it: `fitting` is the nearest to the truth that
/// is never above it.
enum class Heuristic : std::uint8_t { manhattan, octile, euclid, fitting };

/// What a guide keeps on its whole way: the sum of factors times parameters is at most a value.
struct KeptBound {
  std::vector<std::pair<int, double>> terms;  ///< parameters that are no whole turns apart from
                                              ///< themselves: none is cyclic or derived
  double most = 0;
};

/// A guide as it was declared: its kind and the values of its clauses. Distances between
/// configurations are Euclidean, each parameter times its weight.
struct GuideSpec {
  std::string name;
  GuideKind kind = GuideKind::rrt_connect;
  double seed = 1;
  double nodes = 20000;    ///< at most, of its trees or lattice; prm: of its roadmap
  double checks = 200000;  ///< at most, of legs and configurations
  double step = 5;         ///< longest leg between two nodes (weighted; rrt_connect: the shortest);
                           ///< astar: the pitch of its lattice
  double goal_bias = 0.1;  ///< share of the samples that are the goal
  double uniform_nodes = 30;    ///< rrt_plus: so many nodes before samples gather about the goal
  double rejections = 5;        ///< rrt_plus: more in a row, and it steps aside
  double greed = 8;             ///< rrt_plus: steps in one direction
  double concentration = 1;     ///< of samples about the goal: larger, nearer
  double smooth = 1.5;          ///< a shortcut is at most so many steps long; 0: none
  double improve = 200;         ///< tests of shortcuts after a way was found
  double safety = 0;            ///< astar: what the nearness of obstacles costs
  double nearest = 10;          ///< prm: each node is joined to so many
  double vision = 0;            ///< visbug21: how far it sees, m; 0: as the robot's sensor
  bool left_hand = false;       ///< of travel: what it follows is on its left
  double attraction = 1;        ///< potential: how strongly the goal draws
  double repulsion = 1;         ///< potential, m2: how strongly what is near repels
  double influence = 1;         ///< potential, m: what is farther does not repel
  double turn_radius = 0;       ///< m: a vehicle that steers turns no narrower; 0: on the spot
  double replans = 10;          ///< ways planned again in one motion
  double thinks = 0;            ///< s of the site's time for each check
  std::vector<KeptBound> keep;  ///< all of them
  std::vector<std::pair<int, double>> weights;  ///< by parameter; else 1 a degree, 10 a metre
  std::vector<int> over;  ///< astar: the parameters that its lattice spans; none: all
  Neighbours neighbours = Neighbours::all;
  Heuristic heuristic = Heuristic::fitting;
  std::string planner;                                   ///< ompl: the name of the planner
  std::vector<std::pair<std::string, double>> settings;  ///< ompl: of the planner's parameters
  bool tells_tree = false;  ///< no clause: for pictures and full traces
};

/// What a kind is called, and in a few words what it does.
struct KindInfo {
  GuideKind kind;
  const char* name;
  const char* text;
};
std::span<const KindInfo> guide_kinds();
const char* name_of(GuideKind kind);
/// The name of the kind, and of which planner it is: "ompl RRTConnect".
std::string full_name(const GuideSpec& spec);
std::optional<GuideKind> find_kind(std::string_view name);

/// A clause with one number.
struct ClauseInfo {
  const char* name;
  double GuideSpec::*value;
  bool whole;  ///< a count
  double least;
  double most;
  unsigned kinds;          ///< bit 1 << kind: those that have it
  const char* text;        ///< what it says, with its unit
  bool is_length = false;  ///< m; else a plain number

  bool is_of(GuideKind kind) const { return (kinds >> static_cast<unsigned>(kind) & 1u) != 0; }
};
std::span<const ClauseInfo> guide_clauses();
const ClauseInfo* find_clause(std::string_view name);

/// A clause with one word of a few.
struct ChoiceInfo {
  const char* name;
  std::span<const char* const> words;  ///< in the order of the values
  void (*choose)(GuideSpec& spec, std::size_t word);
  unsigned kinds;    ///< as of ClauseInfo
  const char* text;  ///< what it says

  bool is_of(GuideKind kind) const { return (kinds >> static_cast<unsigned>(kind) & 1u) != 0; }
};
std::span<const ChoiceInfo> guide_choices();
const ChoiceInfo* find_choice(std::string_view name);

/// The clause that says which parameters a lattice spans: `over boom.phi, stick.phi;`.
inline constexpr const char* kOverClause = "over";
bool has_over(GuideKind kind);
/// A lattice spans at most so many parameters: with more it has too many nodes to look through.
inline constexpr std::size_t kMostSpanned = 4;

/// Whether the heuristic of a spec is never above what is really left.
bool is_admissible(const GuideSpec& spec);

/// The clause with which weights are given: `weight x 20, boom.phi 2;`.
inline constexpr const char* kWeightClause = "weight";

/// The clause that says what holds on the whole way: `keep (abs(boom.phi + stick.phi) <= 90);`.
inline constexpr const char* kKeepClause = "keep";

/// The clause that sets a parameter of a planner of OMPL: `set "range" 20;`.
inline constexpr const char* kSetClause = "set";

/// The clause that says what planning takes of the site's time: `thinks 20 us per check;`.
inline constexpr const char* kThinksClause = "thinks";
/// s, of a check at most.
inline constexpr double kMostThinking = 60;

/// A guide of this kind with the defaults of its clauses.
GuideSpec default_guide(GuideKind kind);

}  // namespace rubicon::guides
