#include "src/motion/guides/planned_guide.hpp"

#include <fmt/format.h>

#include <utility>

#include "src/motion/guides/lane_guide.hpp"
#include "src/motion/guides/planners.hpp"

namespace rubicon::guides {

namespace {

Search search(Space& space, const GuideTask& task, const Point& start, const Point& goal,
              PlanMemory& memory) {
  Search found;
  switch (space.spec().kind) {
    case GuideKind::rrt_connect:
      return connect_trees(space, start, goal, *task.model, task.loaded);
    case GuideKind::astar:
      found = space.leg().steers() ? search_arcs(space, start, goal)
                                   : search_lattice(space, start, goal);
      break;
    case GuideKind::potential:
      return descend(space, start, goal);
    case GuideKind::prm:
      found = search_roadmap(space, start, goal, memory.roadmap);
      break;
    case GuideKind::dstar_lite:
      found = repair_lattice(space, start, goal, memory.lattice);
      break;
    case GuideKind::drrt:
      found = search_tree(space, start, goal, memory.tree);
      break;
    case GuideKind::ompl:
      found = plan_by_ompl(space, start, goal);
      break;
    default:
      return grow_to_goal(space, start, goal);
  }
  // Shortcuts save time and know nothing of safety.
  if (!found.way.empty() && !(space.spec().safety > 0)) {
    shorten(space, found.way, *task.model, task.loaded);
  }
  return found;
}

}  // namespace

PlanReport plan_way(const GuideSpec& spec, const GuideTask& task, std::span<const double> q,
                    MotionTests& tests) {
  PlanMemory memory;
  return plan_way(spec, task, q, tests, memory);
}

PlanReport plan_way(const GuideSpec& spec, const GuideTask& task, std::span<const double> q,
                    MotionTests& tests, PlanMemory& memory) {
  using Outcome = PlanReport::Outcome;
  PlanReport report;
  report.seed = spec.seed;
  Space space(*task.model, task.mounting, q, spec, tests, task.clauses);
  const Point start = space.point(q);
  const auto end = [&](Outcome outcome) {
    report.outcome = outcome;
    report.checks = space.checks();
    report.refused = space.refused();
    return std::move(report);
  };
  if (!space.keeps(q)) return end(Outcome::start_not_kept);
  if (!space.stands(start)) return end(Outcome::start_blocked);
  const std::vector<double>* goal = nullptr;
  bool kept = task.goals.empty();
  for (const std::vector<double>& each : task.goals) {
    if (!space.keeps(each)) continue;
    kept = true;
    if (!space.stands(space.point(each))) continue;
    goal = &each;
    break;
  }
  if (!kept) return end(Outcome::goal_not_kept);
  if (goal == nullptr) return end(Outcome::goal_blocked);
  report.goal = *goal;
  const Point target = space.point(*goal);
  // Steps are refused where the whole leg is free only within what the engine leaves undecided.
  // Then legs are tested as they are stepped.
  for (const bool by_steps : {false, true}) {
    if (by_steps) space.test_by_steps();
    Search found = is_travel(spec.kind) ? travel_way(space, task, q, target, tests)
                                        : search(space, task, start, target, memory);
    report.nodes += found.nodes;
    report.events = std::move(found.events);
    report.tree.clear();
    for (const auto& [from, to] : found.tree) {
      report.tree.emplace_back(space.configuration(from), space.configuration(to));
    }
    if (found.way.empty() && !found.cause.empty()) {
      report.cause = std::move(found.cause);
      return end(found.was_refused ? Outcome::not_certified : Outcome::no_way);
    }
    if (found.way.empty()) {
      return end(found.out_of_nodes ? Outcome::out_of_nodes : Outcome::out_of_checks);
    }
    found.way = space.with_chords(found.way);
    found.way.erase(found.way.begin());
    if (!space.steps_are_free(q, found.way)) continue;
    report.way.emplace_back(q.begin(), q.end());
    for (const Point& point : found.way) report.way.push_back(space.configuration(point));
    report.metrics =
        way_metrics(*task.model, task.mounting, report.way, task.loaded, spec.turn_radius);
    return end(Outcome::found);
  }
  return end(Outcome::not_certified);
}

bool way_is_free(const GuideSpec& spec, const GuideTask& task, std::span<const double> q,
                 const std::vector<std::vector<double>>& way, MotionTests& tests) {
  Space space(*task.model, task.mounting, q, spec, tests, task.clauses);
  std::vector<Point> points;
  for (std::size_t k = 1; k < way.size(); ++k) points.push_back(space.point(way[k]));
  return space.steps_are_free(q, points);
}

std::unique_ptr<Guide> make_guide(const GuideSpec& spec, GuideTask task) {
  if (spec.kind == GuideKind::lanes) return std::make_unique<LaneGuide>(spec, std::move(task));
  return std::make_unique<PlannedGuide>(spec, std::move(task));
}

GuideAnswer PlannedGuide::way_point() const {
  GuideAnswer answer;
  answer.kind = GuideAnswer::Kind::way_point;
  answer.q = (*way_)[next_];
  answer.k = static_cast<int>(next_);
  answer.n = static_cast<int>(way_->size()) - 1;
  return answer;
}

GuideAnswer PlannedGuide::begin(std::span<const double> q, MotionTests& tests) {
  GuideSpec spec = spec_;
  spec.seed += planned_;  // another try is another way
  PlanReport report = plan_way(spec, task_, q, tests, memory_);
  ++planned_;
  GuideAnswer answer;
  if (report.found()) {
    way_ = std::make_shared<const std::vector<std::vector<double>>>(report.way);
    next_ = 1;
    answer = way_point();
  }
  answer.planned = std::move(report);
  return answer;
}

GuideAnswer PlannedGuide::reached(std::span<const double>, MotionTests&) {
  ++next_;
  return way_point();
}

GuideAnswer PlannedGuide::ended_short(std::span<const double> q, MotionTests& tests) {
  if (planned_ <= static_cast<int>(spec_.replans)) return begin(q, tests);
  GuideAnswer answer;
  answer.reason = fmt::format("{} ways were planned", planned_);
  return answer;
}

}  // namespace rubicon::guides
