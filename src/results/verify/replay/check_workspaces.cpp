#include "src/results/verify/replay/check_workspaces.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "src/motion/math/index.hpp"
#include "src/motion/math/turns.hpp"

namespace rubicon::verify {

namespace {

using math::at;
using Point2 = Eigen::Vector2d;
using Outline = std::vector<Point2>;  ///< convex, counter-clockwise

/// m2 that two workspaces may have in common by rounding.
constexpr double kMostCommon = 1e-4;
/// Degrees a machine turns between two places at which it is looked at.
constexpr double kLookApart_deg = 5;
/// What lies between chord and arc where others look at a turn at other places: m of a machine 10 m
/// long, and m2 that two of them then have in common.
constexpr double kChordOff = 0.02;
constexpr double kMostBetweenChords = 0.02;

/// The convex outline of points: gift wrapping.
Outline outline_of(const std::vector<Point2>& points) {
  std::size_t first = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Point2& a = points[i];
    const Point2& b = points[first];
    if (a.y() < b.y() || (a.y() == b.y() && a.x() < b.x())) first = i;
  }
  Outline outline;
  std::size_t here = first;
  do {
    outline.push_back(points[here]);
    std::size_t next = here == 0 ? 1 : 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Point2 a = points[next] - points[here];
      const Point2 b = points[i] - points[here];
      const double turn = a.x() * b.y() - a.y() * b.x();
      if (turn < -1e-12 || (std::fabs(turn) <= 1e-12 && b.squaredNorm() > a.squaredNorm())) {
        next = i;
      }
    }
    here = next;
  } while (here != first && outline.size() <= points.size() &&
           (points[here] - points[first]).norm() > 1e-12);
  return outline;
}

/// m2 that both have: the one, cut at the edges of the other.
double common_area(const Outline& a, const Outline& b) {
  std::vector<Point2> left = a;
  for (std::size_t i = 0; i < b.size() && !left.empty(); ++i) {
    const Point2& from = b[i];
    const Point2 edge = b[(i + 1) % b.size()] - from;
    const auto inside = [&](const Point2& p) {
      return edge.x() * (p.y() - from.y()) - edge.y() * (p.x() - from.x());
    };
    std::vector<Point2> kept;
    for (std::size_t k = 0; k < left.size(); ++k) {
      const Point2& p = left[k];
      const Point2& next = left[(k + 1) % left.size()];
      const double here = inside(p);
      const double there = inside(next);
      if (here >= 0) kept.push_back(p);
      if ((here >= 0) != (there >= 0)) kept.push_back(p + (next - p) * (here / (here - there)));
    }
    left = std::move(kept);
  }
  double area = 0;
  for (std::size_t k = 0; k < left.size(); ++k) {
    const Point2& p = left[k];
    const Point2& next = left[(k + 1) % left.size()];
    area += (p.x() * next.y() - p.y() * next.x()) / 2;
  }
  return std::fabs(area);
}

/// The workspace of a machine during a leg.
struct Workspace {
  std::vector<Outline> outlines;
  Point2 lower = Point2::Constant(1e300), upper = Point2::Constant(-1e300);
};

/// When two machines load each other.
struct Together {
  int truck = -1;
  std::set<int> diggers;
  Ticks from = 0, to = 0;
};

class WorkspaceCheck {
 public:
  WorkspaceCheck(const Trace& trace, const std::vector<TaskRun>& runs,
                 const std::vector<RobotTrack>& tracks, const SiteParts& site, Faults& faults)
      : trace_(trace),
        rules_(*trace.scene.workspaces),
        runs_(runs),
        tracks_(tracks),
        site_(site),
        faults_(faults) {}

  void check() {
    find_together();
    for (const int robot : rules_.robots) find_corners(robot);
    check_foreseen();
    if (rules_.watch) return;
    for (std::size_t a = 0; a < rules_.robots.size(); ++a) {
      for (std::size_t b = a + 1; b < rules_.robots.size(); ++b) {
        check_pair(rules_.robots[a], rules_.robots[b]);
      }
    }
  }

 private:
  /// From one tip to the next a truck belongs to who loads it.
  void find_together() {
    for (const TaskRun& run : runs_) {
      if (!run.happened || run.task < 0 || run.robot < 0) continue;
      const SceneTask& task = trace_.scene.tasks[at(run.task)];
      if (!task.haul) continue;
      std::set<int> all;
      std::map<int, int> digger_of;  // by component of the soil
      for (const SceneTask& other : trace_.scene.tasks) {
        const auto& digs = task.haul->digs;
        if (!other.motion_dig || std::find(digs.begin(), digs.end(), other.name) == digs.end()) {
          continue;
        }
        all.insert(other.robot);
        digger_of[other.motion_dig->soil] = other.robot;
      }
      Together now{run.robot, all, run.start, run.end};
      for (const int index : run.records) {
        const Record& record = trace_.records[at(index)];
        const auto* taken = std::get_if<SoilTaken>(&record.what);
        if (taken == nullptr) continue;
        if (taken->volume > 0) {
          now.diggers = {digger_of[taken->component]};
          continue;
        }
        now.to = record.time;
        together_.push_back(now);
        now = {run.robot, all, record.time, run.end};
      }
      together_.push_back(now);
    }
  }

  bool are_together(int a, int b, Ticks from, Ticks to) const {
    return std::any_of(together_.begin(), together_.end(), [&](const Together& each) {
      const bool pair = (each.truck == a && each.diggers.contains(b)) ||
                        (each.truck == b && each.diggers.contains(a));
      return pair && each.from < to && from < each.to;
    });
  }

  void find_corners(int robot) {
    std::vector<std::vector<Vec3>>& corners = corners_[robot];
    for (const SceneBody& body : trace_.scene.robots[at(robot)].bodies) {
      std::vector<Vec3>& own = corners.emplace_back();
      for (const ShapeData& shape : body.shapes) {
        const Bounds bounds = make_solid({shape}, trace_.scene.meshes)->bounds;
        for (int corner = 0; corner < 8; ++corner) {
          own.emplace_back(((corner & 1) != 0 ? bounds.upper : bounds.lower).x(),
                           ((corner & 2) != 0 ? bounds.upper : bounds.lower).y(),
                           ((corner & 4) != 0 ? bounds.upper : bounds.lower).z());
        }
      }
    }
  }

  /// Where the motion of a leg leads next: to its waypoint, or to its end.
  std::optional<std::vector<double>> goal_of(int robot, const Leg& leg) const {
    if (leg.run < 0) return std::nullopt;
    const std::vector<Leg>& legs = tracks_[at(robot)].legs;
    const std::vector<double>* last = &leg.q1;
    for (const int index : runs_[at(leg.run)].records) {
      const Record& record = trace_.records[at(index)];
      if (record.line <= leg.line) continue;
      if (const auto* end = std::get_if<MotionEnd>(&record.what)) {
        std::vector<double> q = end->q;
        for (const auto& [parameter, off] : end->residual) q[at(parameter)] += off;
        return q;
      }
      const auto* goal = std::get_if<Goal>(&record.what);
      if (goal == nullptr) continue;
      for (const Leg& each : legs) {
        if (each.moves() && each.run == leg.run && each.line < record.line) last = &each.q1;
      }
      return *last;
    }
    return std::nullopt;
  }

  /// Where a leg leads: to the waypoint of a guide, or to the goal.
  std::optional<std::vector<double>> aim_of(int robot, const Leg& leg) const {
    const std::vector<std::vector<double>>* way = nullptr;
    int k = 0;
    if (leg.run < 0) return std::nullopt;
    for (const int index : runs_[at(leg.run)].records) {
      const Record& record = trace_.records[at(index)];
      if (record.line >= leg.line) break;
      if (const auto* plan = std::get_if<GuidePlan>(&record.what)) {
        if (!plan->way.empty()) way = &plan->way;
      } else if (const auto* point = std::get_if<WayPoint>(&record.what)) {
        k = point->k;
      } else if (std::holds_alternative<Goal>(record.what) ||
                 std::holds_alternative<MotionEnd>(record.what)) {
        way = nullptr;
        k = 0;
      }
    }
    if (way == nullptr || k < 1 || at(k) >= way->size()) return goal_of(robot, leg);
    return (*way)[at(k)];
  }

  /// Whether the robot carried soil, or something hung on it, in a leg.
  bool is_loaded(const Leg& leg) const {
    if (leg.hanging >= 0) return true;
    const TaskRun& run = runs_[at(leg.run)];
    if (run.task < 0 || !trace_.scene.tasks[at(run.task)].haul) return false;
    bool loaded = false;
    for (const int index : run.records) {
      const Record& record = trace_.records[at(index)];
      if (record.line >= leg.line) break;
      const auto* taken = std::get_if<SoilTaken>(&record.what);
      if (taken != nullptr) loaded = taken->volume > 0;
    }
    return loaded;
  }

  /// What a robot is foreseen to sweep at a time: its step, and what it does of the straight way on
  /// in the seconds that are left. Two of them where a step ends then and the next begins: the
  /// trace does not tell which it was in when it was looked at. None: it makes no step.
  std::vector<Workspace> foreseen(int robot, Ticks time) const {
    std::vector<Workspace> found;
    for (const Leg& leg : tracks_[at(robot)].legs) {
      if (!leg.moves() || leg.run < 0 || leg.from > time || leg.to < time) continue;
      const std::optional<std::vector<double>> aim = aim_of(robot, leg);
      if (!aim) continue;
      const SceneRobot& machine = trace_.scene.robots[at(robot)];
      const bool loaded = is_loaded(leg);
      std::vector<double> end = leg.q1;
      double needs = 0;
      for (std::size_t i = 0; i < end.size(); ++i) {
        const SceneParameter& p = machine.parameters[i];
        double left = (*aim)[i] - leg.q1[i];
        if (p.cyclic) left = math::normalised_deg(left);
        end[i] += left;
        const double speed = loaded ? p.loaded_speed : p.speed;
        if (speed > 0) needs = std::max(needs, std::fabs(left) / speed);
      }
      const double left =
          rules_.foreseen - static_cast<double>(leg.to - time) / static_cast<double>(kSecond);
      const double share = needs > 0 ? std::clamp(left / needs, 0.0, 1.0) : 1.0;
      for (std::size_t i = 0; i < end.size(); ++i) {
        end[i] = leg.q1[i] + (end[i] - leg.q1[i]) * share;
      }
      Workspace& result = found.emplace_back();
      add_swept(robot, leg.q0, leg.q1, result);
      add_swept(robot, leg.q1, end, result);
    }
    return found;
  }

  /// Looks at what tasks were told is foreseen: of a machine that goes first, what it would really
  /// sweep; and that the way which a guide planned then keeps out of it.
  void check_foreseen() {
    for (const TaskRun& run : runs_) {
      if (!run.happened || run.robot < 0) continue;
      Ticks looked = -1;
      Workspace all;
      for (const int index : run.records) {
        const Record& record = trace_.records[at(index)];
        const auto fault = [&](std::string text) {
          faults_.push_back({FaultKind::contact, ResultFile::trace, record.line,
                             trace_.runs[at(run.run)], record.time, std::move(text)});
        };
        if (const auto* told = std::get_if<Foreseen>(&record.what)) {
          if (record.time != looked) all = {};
          looked = record.time;
          const std::string text = why_not_foreseen(run.robot, *told, record.time, all);
          if (!text.empty()) return fault(text);
        } else if (std::holds_alternative<Try>(record.what)) {
          looked = -1;
        } else if (const auto* plan = std::get_if<GuidePlan>(&record.what)) {
          if (record.time != looked || plan->way.empty()) continue;
          Workspace own;
          std::vector<double> q = plan->way.front();
          for (std::size_t k = 1; k < plan->way.size(); ++k) {
            std::vector<double> next = q;
            for (std::size_t i = 0; i < q.size(); ++i) {
              const double off = plan->way[k][i] - q[i];
              const bool turns = trace_.scene.robots[at(run.robot)].parameters[i].cyclic;
              next[i] += turns ? math::normalised_deg(off) : off;
            }
            add_swept(run.robot, q, next, own);
            q = std::move(next);
          }
          if (overlap(own, all, kMostBetweenChords)) {
            return fault(fmt::format("the way round of {} meets what is foreseen",
                                     trace_.scene.robots[at(run.robot)].name));
          }
        }
      }
    }
  }

  /// "" where it is right; adds what is told to `all`.
  std::string why_not_foreseen(int robot, const Foreseen& told, Ticks time, Workspace& all) const {
    const std::string& name = trace_.scene.robots[at(told.robot)].name;
    const auto rank = [&](int each) {
      return std::find(rules_.robots.begin(), rules_.robots.end(), each) - rules_.robots.begin();
    };
    const auto count = static_cast<std::ptrdiff_t>(rules_.robots.size());
    if (!(rules_.foreseen > 0) || rank(robot) == count || rank(told.robot) >= rank(robot)) {
      return fmt::format("{} gives way to {}, which does not go first", name,
                         trace_.scene.robots[at(robot)].name);
    }
    if (std::fabs(told.seconds - rules_.foreseen) > 1e-6) {
      return fmt::format("{} is foreseen for {:g} s instead of {:g} s", name, told.seconds,
                         rules_.foreseen);
    }
    const std::vector<Workspace> real = foreseen(told.robot, time);
    if (real.empty()) return fmt::format("{} is foreseen to move, and makes no step", name);
    Workspace region;
    for (const std::vector<double>& numbers : told.outlines) {
      Outline outline;
      for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) {
        outline.emplace_back(numbers[i], numbers[i + 1]);
      }
      add(std::move(outline), region);
      add(region.outlines.back(), all);
    }
    const auto off = [&](const Workspace& each, const Workspace& within, const char* what) {
      for (const Outline& outline : each.outlines) {
        for (const Point2& p : outline) {
          if (is_in(p, within)) continue;
          return fmt::format("{} {} ({:.2f}, {:.2f}) in the {:g} s that are foreseen", name, what,
                             p.x(), p.y(), rules_.foreseen);
        }
      }
      return std::string();
    };
    std::string text;
    for (const Workspace& each : real) {
      text = off(each, region, "sweeps");
      if (text.empty()) text = off(region, each, "does not sweep");
      if (text.empty()) break;
    }
    return text;
  }

  static void add(Outline outline, Workspace& to) {
    for (const Point2& p : outline) {
      to.lower = to.lower.cwiseMin(p);
      to.upper = to.upper.cwiseMax(p);
    }
    to.outlines.push_back(std::move(outline));
  }

  /// Whether a place is in any of the outlines, or hardly beside them.
  static bool is_in(const Point2& p, const Workspace& region) {
    return std::any_of(region.outlines.begin(), region.outlines.end(), [&](const Outline& outline) {
      for (std::size_t i = 0; i < outline.size(); ++i) {
        const Point2& from = outline[i];
        const Point2 edge = outline[(i + 1) % outline.size()] - from;
        const double length = edge.norm();
        if (!(length > 0)) continue;
        const double left =
            (edge.x() * (p.y() - from.y()) - edge.y() * (p.x() - from.x())) / length;
        if (left < -kChordOff) return false;
      }
      return true;
    });
  }

  Workspace workspace(int robot, const Leg& leg) const {
    const SceneRobot& machine = trace_.scene.robots[at(robot)];
    std::vector<double> end = leg.q0;
    if (leg.moves()) {
      end = leg.q1;
      const double seconds = static_cast<double>(leg.to - leg.from) / kSecond;
      double length2 = 0;
      for (std::size_t i = 0; i < end.size(); ++i) {
        const SceneParameter& p = machine.parameters[i];
        const double off = leg.q1[i] - leg.q0[i];
        if (!p.rotation && !p.derived) length2 += off * off;
      }
      const double speed = std::sqrt(length2) / seconds;
      const std::optional<std::vector<double>> goal = goal_of(robot, leg);
      for (std::size_t i = 0; i < end.size(); ++i) {
        const SceneParameter& p = machine.parameters[i];
        const double rate = (leg.q1[i] - leg.q0[i]) / seconds;
        const double way =
            p.rotation ? rate * (rules_.reaction + std::fabs(rate) / (2 * rules_.turn_braking))
                       : rate * (rules_.reaction + speed / (2 * rules_.braking));
        double more = way;
        if (goal) {
          double left = (*goal)[i] - leg.q1[i];
          if (p.cyclic) left = math::normalised_deg(left);
          if (left * way >= 0 && std::fabs(left) < std::fabs(way)) more = left;
        }
        end[i] += more;
      }
    }
    Workspace result;
    add_swept(robot, leg.q0, end, result);
    return result;
  }

  /// What the bodies of a robot sweep in the plan view from one configuration straight to another.
  void add_swept(int robot, const std::vector<double>& q0, const std::vector<double>& end,
                 Workspace& result) const {
    const SceneRobot& machine = trace_.scene.robots[at(robot)];
    double turned = 0;
    for (std::size_t i = 0; i < end.size(); ++i) {
      if (!machine.parameters[i].rotation) continue;
      turned = std::max(turned, std::fabs(end[i] - q0[i]));
    }
    const Mechanism& mechanism = *site_.robots[at(robot)].mechanism;
    const auto& corners = corners_.at(robot);
    const auto seen = [&](std::size_t body, const std::vector<double>& q) {
      const Pose X = mechanism.pose(static_cast<int>(body), q);
      std::vector<Point2> points;
      for (const Vec3& p : corners[body]) points.emplace_back((X * p).head<2>());
      return points;
    };
    const int parts = std::max(1, static_cast<int>(std::ceil(turned / kLookApart_deg)));
    std::vector<double> before = q0;
    for (int part = 1; part <= parts; ++part) {
      std::vector<double> here = q0;
      for (std::size_t i = 0; i < here.size(); ++i) here[i] += (end[i] - here[i]) * part / parts;
      for (std::size_t body = 0; body < corners.size(); ++body) {
        if (corners[body].empty()) continue;
        std::vector<Point2> points = seen(body, before);
        const std::vector<Point2> more = seen(body, here);
        points.insert(points.end(), more.begin(), more.end());
        add(outline_of(points), result);
      }
      before = std::move(here);
    }
  }

  static bool overlap(const Workspace& a, const Workspace& b, double most = kMostCommon) {
    if ((a.lower.array() > b.upper.array()).any() || (b.lower.array() > a.upper.array()).any()) {
      return false;
    }
    for (const Outline& one : a.outlines) {
      for (const Outline& other : b.outlines) {
        if (common_area(one, other) > most) return true;
      }
    }
    return false;
  }

  void check_pair(int a, int b) {
    const std::vector<Leg>& first = tracks_[at(a)].legs;
    const std::vector<Leg>& second = tracks_[at(b)].legs;
    std::vector<std::optional<Workspace>> known_first(first.size()), known_second(second.size());
    std::size_t j = 0;
    for (std::size_t i = 0; i < first.size(); ++i) {
      while (j < second.size() && second[j].to <= first[i].from) ++j;
      for (std::size_t k = j; k < second.size() && second[k].from < first[i].to; ++k) {
        if (!first[i].moves() && !second[k].moves()) continue;
        const Ticks from = std::max(first[i].from, second[k].from);
        const Ticks to = std::min(first[i].to, second[k].to);
        if (from >= to || are_together(a, b, from, to)) continue;
        if (!known_first[i]) known_first[i] = workspace(a, first[i]);
        if (!known_second[k]) known_second[k] = workspace(b, second[k]);
        if (!overlap(*known_first[i], *known_second[k])) continue;
        const Leg& late = first[i].from >= second[k].from ? first[i] : second[k];
        faults_.push_back(
            {FaultKind::contact, ResultFile::trace, late.line,
             late.run < 0 ? std::string() : trace_.runs[at(runs_[at(late.run)].run)], from,
             fmt::format("the workspace of {} overlaps that of {}", trace_.scene.robots[at(a)].name,
                         trace_.scene.robots[at(b)].name)});
        return;  // one of a pair is enough
      }
      known_first[i].reset();
    }
  }

  const Trace& trace_;
  const SceneWorkspaces& rules_;
  const std::vector<TaskRun>& runs_;
  const std::vector<RobotTrack>& tracks_;
  const SiteParts& site_;
  Faults& faults_;
  std::vector<Together> together_;
  std::map<int, std::vector<std::vector<Vec3>>> corners_;
};

}  // namespace

void check_workspaces(const Trace& trace, const std::vector<TaskRun>& runs,
                      const std::vector<RobotTrack>& tracks, const SiteParts& site,
                      Faults& faults) {
  if (trace.scene.workspaces) WorkspaceCheck(trace, runs, tracks, site, faults).check();
}

}  // namespace rubicon::verify
