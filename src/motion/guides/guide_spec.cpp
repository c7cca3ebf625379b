#include "src/motion/guides/guide_spec.hpp"

#include <algorithm>
#include <array>

namespace rubicon::guides {

namespace {

constexpr unsigned bit(GuideKind kind) { return 1u << static_cast<unsigned>(kind); }
constexpr unsigned kPlanners = 0x7ff;
constexpr unsigned kVisibility = bit(GuideKind::visibility);
constexpr unsigned kTravel = 0x7ffff & ~kPlanners & ~kVisibility;
constexpr unsigned kAll = kPlanners | kTravel | kVisibility;
constexpr unsigned kAstar = bit(GuideKind::astar);
constexpr unsigned kPrm = bit(GuideKind::prm);
constexpr unsigned kConnect = bit(GuideKind::rrt_connect);
constexpr unsigned kDstar = bit(GuideKind::dstar_lite);
constexpr unsigned kDrrt = bit(GuideKind::drrt);
constexpr unsigned kPotential = bit(GuideKind::potential);
constexpr unsigned kOmpl = bit(GuideKind::ompl);
constexpr unsigned kSearched = kAstar | kDstar;
constexpr unsigned kLattice = kSearched | kPotential;
constexpr unsigned kThesis = kPlanners & ~kConnect & ~kLattice & ~kPrm & ~kDrrt & ~kOmpl;
constexpr unsigned kSteered =
    (kThesis & ~bit(GuideKind::rrt_limcon)) | kConnect | kAstar | kPrm | kDrrt | kOmpl;
constexpr unsigned kPlus = bit(GuideKind::rrt_plus);
constexpr unsigned kGathered = kPlus | bit(GuideKind::rrt_nonuniform);

constexpr std::array kKinds{
    KindInfo{GuideKind::rrt, "rrt", "a tree grown towards samples from everywhere (RRT)"},
    KindInfo{GuideKind::rrt_nonuniform, "rrt_nonuniform",
             "the same, with samples that gather about the goal"},
    KindInfo{GuideKind::rrt_plus, "rrt_plus",
             "the same, greedy, drawn to the goal, and stepping aside where it is stuck"},
    KindInfo{GuideKind::rrt_limcon, "rrt_limcon",
             "a tree that moves one parameter at a time and never away from the goal"},
    KindInfo{GuideKind::rrt_connect, "rrt_connect",
             "two trees, from start and goal, with long legs; then shortcuts"},
    KindInfo{GuideKind::astar, "astar",
             "the cheapest way over a lattice of two to four parameters (A*)"},
    KindInfo{GuideKind::prm, "prm",
             "the shortest way over a roadmap of random configurations, tested where it is used"},
    KindInfo{GuideKind::dstar_lite, "dstar_lite",
             "as astar, but repaired after a change instead of searched again (D* Lite)"},
    KindInfo{GuideKind::drrt, "drrt",
             "a tree from the goal, cut where it is no longer free and grown again"},
    KindInfo{GuideKind::potential, "potential",
             "down a field that draws to the goal and away from obstacles; stops in a minimum"},
    KindInfo{GuideKind::ompl, "ompl",
             "a planner of OMPL by its name, over the same tests: ompl \"RRTConnect\""},
    KindInfo{GuideKind::bug1, "bug1",
             "without a map: once round each obstacle, then on from its nearest point"},
    KindInfo{GuideKind::bug2, "bug2",
             "without a map: round each obstacle until the line to the goal is met again"},
    KindInfo{GuideKind::visbug21, "visbug21", "as bug2, but it looks ahead and cuts corners"},
    KindInfo{GuideKind::pledge, "pledge",
             "out of a maze: one direction, round what is in it; finds a goal only ahead of it"},
    KindInfo{GuideKind::simple, "simple",
             "without a map: round each obstacle until the way is clear; loops in a trap"},
    KindInfo{GuideKind::tangent, "tangent", "as simple, and as bug2 where that is a trap"},
    KindInfo{GuideKind::ace, "ace", "as tangent, for obstacles that move"},
    KindInfo{GuideKind::visibility, "visibility",
             "the shortest way round all that stands, with a map (visibility graph)"}};

// Reason for the upper bounds: with more a way takes minutes to look for.
constexpr std::array kClauses{
    ClauseInfo{"seed", &GuideSpec::seed, true, 0, 9007199254740991.0, kPlanners,
               "of its random numbers"},
    ClauseInfo{
        "nodes", &GuideSpec::nodes, true, 1, 1e5, kAll,
        "at most, of its trees or its lattice; of prm those of its roadmap; without a map the "
        "stretches between two decisions"},
    ClauseInfo{"checks", &GuideSpec::checks, true, 1, 1e7, kAll,
               "at most, of legs and configurations, for one way"},
    ClauseInfo{
        "step", &GuideSpec::step, false, 1e-3, 1e6, kPlanners & ~kPrm,
        "the longest leg of a tree, weighted (a degree counts 1, a metre 10); of "
        "rrt_connect the shortest, of astar, dstar_lite and potential the pitch of the lattice, of "
        "ompl its range"},
    ClauseInfo{"goal_bias", &GuideSpec::goal_bias, false, 0, 1, kThesis | kDrrt,
               "the share of samples that are the goal itself; of drrt the start"},
    ClauseInfo{"uniform_nodes", &GuideSpec::uniform_nodes, true, 0, 1e6, kPlus,
               "nodes before its samples gather about the goal"},
    ClauseInfo{"rejections", &GuideSpec::rejections, true, 0, 1e6, kPlus,
               "refused legs in a row before it steps aside"},
    ClauseInfo{"greed", &GuideSpec::greed, true, 1, 1e6, kPlus, "steps in one direction"},
    ClauseInfo{"concentration", &GuideSpec::concentration, false, 1, 1000, kGathered,
               "how closely samples gather about the goal"},
    ClauseInfo{"smooth", &GuideSpec::smooth, false, 0, 1000, kThesis,
               "the longest shortcut, in steps; 0: none"},
    ClauseInfo{"improve", &GuideSpec::improve, true, 0, 1e6,
               kConnect | kSearched | kPrm | kDrrt | kOmpl,
               "tests of shortcuts after a way is found"},
    ClauseInfo{"safety", &GuideSpec::safety, false, 0, 1000, kAstar,
               "a leg to where all about is blocked costs so many times its length more"},
    ClauseInfo{"nearest", &GuideSpec::nearest, true, 1, 1000, kPrm,
               "each node of the roadmap is joined to so many"},
    ClauseInfo{"vision", &GuideSpec::vision, false, 0, 1e4, bit(GuideKind::visbug21),
               "how far it sees, m; 0: as far as the robot's sensor, or 10 m"},
    ClauseInfo{"attraction", &GuideSpec::attraction, false, 1e-6, 1e6, kPotential,
               "how strongly the goal draws"},
    ClauseInfo{"repulsion", &GuideSpec::repulsion, false, 0, 1e6, kPotential,
               "how strongly what is near repels (m2); 0: not"},
    ClauseInfo{"influence", &GuideSpec::influence, false, 1e-3, 1000, kPotential,
               "what is farther away does not repel, m", true},
    ClauseInfo{"turn_radius", &GuideSpec::turn_radius, false, 0, 1000, kSteered,
               "of a vehicle that steers: it turns no narrower, m; 0: it turns on the spot", true},
    ClauseInfo{"replans", &GuideSpec::replans, true, 0, 1000, kAll,
               "ways planned again in one motion"}};

constexpr std::array kNeighbourWords{"straight", "all"};
constexpr std::array kHandWords{"right", "left"};
constexpr std::array kHeuristicWords{"manhattan", "octile", "euclid"};

constexpr std::array kChoices{
    ChoiceInfo{
        "neighbours", kNeighbourWords,
        [](GuideSpec& spec, std::size_t word) { spec.neighbours = static_cast<Neighbours>(word); },
        kLattice, "which nodes are next to each other: one parameter apart, or all about"},
    ChoiceInfo{
        "heuristic", kHeuristicWords,
        [](GuideSpec& spec, std::size_t word) { spec.heuristic = static_cast<Heuristic>(word); },
        kAstar, "how it estimates what is left to the goal"},
    ChoiceInfo{"hand", kHandWords,
               [](GuideSpec& spec, std::size_t word) { spec.left_hand = word == 1; }, kTravel,
               "on which side it keeps what it follows"}};

}  // namespace

std::span<const KindInfo> guide_kinds() { return kKinds; }
std::span<const ClauseInfo> guide_clauses() { return kClauses; }

const char* name_of(GuideKind kind) {
  return kind == GuideKind::lanes ? "lanes" : kKinds[static_cast<std::size_t>(kind)].name;
}

std::string full_name(const GuideSpec& spec) {
  const std::string kind = name_of(spec.kind);
  return spec.planner.empty() ? kind : kind + ' ' + spec.planner;
}

std::optional<GuideKind> find_kind(std::string_view name) {
  for (const KindInfo& info : kKinds) {
    if (info.name == name) return info.kind;
  }
  return std::nullopt;
}

const ClauseInfo* find_clause(std::string_view name) {
  const auto* const found = std::find_if(kClauses.begin(), kClauses.end(),
                                         [&](const ClauseInfo& info) { return info.name == name; });
  return found == kClauses.end() ? nullptr : &*found;
}

std::span<const ChoiceInfo> guide_choices() { return kChoices; }

const ChoiceInfo* find_choice(std::string_view name) {
  const auto* const found = std::find_if(kChoices.begin(), kChoices.end(),
                                         [&](const ChoiceInfo& info) { return info.name == name; });
  return found == kChoices.end() ? nullptr : &*found;
}

bool has_over(GuideKind kind) { return (kLattice & bit(kind)) != 0; }

bool is_admissible(const GuideSpec& spec) {
  return spec.heuristic != Heuristic::manhattan || spec.neighbours == Neighbours::straight;
}

GuideSpec default_guide(GuideKind kind) {
  GuideSpec spec;
  spec.kind = kind;
  if (kind == GuideKind::rrt || kind == GuideKind::rrt_nonuniform) spec.goal_bias = 0;
  const unsigned of = bit(kind);
  if ((of & kThesis) != 0) spec.nodes = 8000;
  if (kind == GuideKind::prm) spec.nodes = 500;
  if ((of & kLattice) != 0) spec.step = 10;
  if (kind == GuideKind::potential) spec.nodes = 20000;
  if (kind == GuideKind::dstar_lite) spec.nodes = 100000;
  if (kind == GuideKind::drrt) spec.nodes = 8000;
  if (kind == GuideKind::ompl) {
    spec.step = 0;  // as OMPL sets it
    spec.checks = 20000;
  }
  return spec;
}

}  // namespace rubicon::guides
