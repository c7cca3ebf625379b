#include "src/results/verify/replay/check_support.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "src/motion/math/index.hpp"
#include "src/results/verify/geometry/balance.hpp"
#include "src/results/verify/geometry/depth.hpp"
#include "src/results/verify/geometry/footing.hpp"
#include "src/results/verify/input/box_tree.hpp"

namespace rubicon::verify {

namespace {

using Vec2 = Eigen::Vector2d;

/// m: gaps that are larger by less are no fault.
constexpr double kGapSlack = 2.5e-4;
/// m: a centre of mass is so far inside of what carries it, and what less is no fault.
constexpr double kMargin = 1e-3;
constexpr double kMarginSlack = 2e-5;

using math::at;

/// Something that stands for a time: a stay of a component, or a shape of the site.
struct Standing {
  int component = -1;
  Pose X_WS = Pose::Identity();
  Ticks from = 0;
  Ticks to = 0;
  const Hull* hull = nullptr;
  const Solid* solid = nullptr;
  Bounds bounds;
  Faces top;               ///< made when asked for
  Ticks floats_until = 0;  ///< it does not stand before
};

class SupportCheck {
 public:
  SupportCheck(const Trace& trace, const SiteParts& site, const std::vector<Stay>& stays,
               Ticks until, Faults& faults)
      : scene_(trace.scene),
        faults_(faults),
        until_(until),
        gap_(scene_.support->gap + kGapSlack),
        depth_(std::max(scene_.support->gap, 2 * scene_.contact) + kGapSlack),
        floating_(scene_.support->floating.begin(), scene_.support->floating.end()) {
    for (const SceneComponent& component : scene_.components) {
      hulls_.push_back(hull_of(component.shapes, scene_.meshes));
    }
    for (const ShapeData& shape : scene_.site) {
      site_hulls_.push_back(hull_of({shape}, scene_.meshes));
    }
    for (const Stay& stay : stays) {
      const auto& solid = site.components[at(stay.component)];
      if (!solid) continue;
      add({stay.component,
           stay.X_WO,
           stay.from,
           stay.to,
           &hulls_[at(stay.component)],
           solid.get(),
           {},
           {}});
    }
    components_ = static_cast<int>(standing_.size());
    // The obstacles of the site come first, one for each shape that has a solid.
    for (std::size_t i = 0; i < site.obstacles.size() && i < site_hulls_.size(); ++i) {
      if (site.obstacles[i].component >= 0) break;
      add({-1,
           Pose::Identity(),
           0,
           until + 1,
           &site_hulls_[i],
           site.obstacles[i].solid.get(),
           {},
           {}});
    }
    for (const SceneTask& task : scene_.tasks) {
      if (task.dig) soils_.insert(task.dig->soil);
    }
    for (const Record& record : trace.records) {
      const auto* end = std::get_if<TaskEnd>(&record.what);
      if (end != nullptr && end->result == TaskResult::done && record.run >= 0) {
        done_.emplace(trace.runs[at(record.run)], record.time);
      }
    }
    std::vector<Bounds> boxes;
    for (const Standing& each : standing_) boxes.push_back(each.bounds);
    tree_ = BoxTree(boxes);
    find_floating();
  }

  void run() {
    for (int i = 0; i < components_; ++i) {
      const Standing& each = standing_[at(i)];
      check(i, each.from);
      check_balance({i}, each.from);
      if (each.to >= until_) continue;
      check_balance(near(i), each.to);
      // Those that are left when it is taken.
      for (const int other : near(i)) {
        const Standing& left = standing_[at(other)];
        if (left.component >= 0 && left.from <= each.to && each.to < left.to) check(other, each.to);
      }
    }
    check_grounds();
  }

 private:
  void add(Standing standing) {
    standing.bounds = standing.solid->bounds.placed(standing.X_WS).grown(gap_);
    standing_.push_back(std::move(standing));
  }

  std::vector<int> near(int index) const {
    std::vector<int> found;
    tree_.meeting(standing_[at(index)].bounds, [&](int other) {
      if (other != index) found.push_back(other);
    });
    std::sort(found.begin(), found.end());
    return found;
  }

  static bool floats(const Standing& each, Ticks time) { return time < each.floats_until; }

  /// What does not stand at the beginning does so when a task that fixes it is done, if that holds
  /// it then; and what rests on it with it.
  void find_floating() {
    std::vector<int> floating;
    std::set<Ticks> times;
    for (int i = 0; i < components_; ++i) {
      Standing& each = standing_[at(i)];
      const SceneComponent& component = scene_.components[at(each.component)];
      if (each.from > 0 || !floating_.contains(component.name)) continue;
      each.floats_until = std::numeric_limits<Ticks>::max();
      floating.push_back(i);
      for (const std::string& task : component.fixed_after) {
        const auto done = done_.find(task);
        if (done != done_.end() && done->second < each.to) times.insert(done->second);
      }
    }
    for (const Ticks time : times) {
      std::set<int> open;
      for (const int index : floating) {
        const SceneComponent& component = scene_.components[at(standing_[at(index)].component)];
        for (const std::string& task : component.fixed_after) {
          const auto done = done_.find(task);
          if (done != done_.end() && done->second <= time) open.insert(index);
        }
      }
      while (!open.empty()) {
        const int index = *open.begin();
        open.erase(open.begin());
        Standing& each = standing_[at(index)];
        if (!floats(each, time) || time >= each.to) continue;
        const std::vector<int> carriers = carriers_of(index, time);
        if (!is_carried(index, time, feet(index, carriers), carriers)) continue;
        each.floats_until = time;
        if (!balances(index, time)) {
          each.floats_until = std::numeric_limits<Ticks>::max();
          continue;
        }
        for (const int other : near(index)) {
          if (floats(standing_[at(other)], time)) open.insert(other);
        }
      }
    }
  }

  /// What stands near it just after `time`.
  std::vector<int> carriers_of(int index, Ticks time) const {
    std::vector<int> carriers;
    for (const int other : near(index)) {
      if (stands(standing_[at(other)], time)) carriers.push_back(other);
    }
    return carriers;
  }

  /// Neither moves while it stands.
  bool touch(int one, int other) {
    const auto [known, is_new] = touches_.try_emplace({one, other}, false);
    if (is_new) known->second = touch(standing_[at(one)], standing_[at(other)]);
    return known->second;
  }
  bool touch(const Standing& a, const Standing& b) const {
    const Pose X_BA = b.X_WS.inverse(Eigen::Isometry) * a.X_WS;
    DepthQuery query;
    query.limit = -gap_ - kGapSlack;
    for (const Convex& piece : a.solid->pieces) {
      for (const Convex& other : b.solid->pieces) {
        if (depth_test(piece, X_BA, other, query).nearness != Nearness::free) return true;
      }
    }
    return false;
  }

  bool is_held(int each, const std::vector<std::string>& names, const std::vector<int>& carriers) {
    return std::any_of(carriers.begin(), carriers.end(), [&](int index) {
      const Standing& other = standing_[at(index)];
      const std::string& name =
          other.component < 0 ? kSite : scene_.components[at(other.component)].name;
      return std::find(names.begin(), names.end(), name) != names.end() && touch(each, index);
    });
  }

  /// What a component is fixed to just after `time`.
  std::vector<std::string> fixed_by(const SceneComponent& component, Ticks time) const {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < component.fixed_to.size(); ++i) {
      const auto done = done_.find(component.fixed_after[i]);
      const bool holds =
          component.fixed_after[i].empty() || (done != done_.end() && done->second <= time);
      if (holds) names.push_back(component.fixed_to[i]);
    }
    return names;
  }

  /// Whether it stands by what else stands just after `time`.
  void check(int index, Ticks time) {
    Standing& each = standing_[at(index)];
    if (floats(each, time) || !checked_.emplace(index, time).second) return;
    const SceneComponent& component = scene_.components[at(each.component)];
    const std::vector<int> carriers = carriers_of(index, time);
    const Feet points = feet(index, carriers);
    if (is_carried(index, time, points, carriers)) return;
    faults_.push_back(
        {FaultKind::support, ResultFile::trace, 0, "", time,
         fmt::format("{} does not stand: {}", component.name,
                     points.at.empty()
                         ? fmt::format("nothing within {:.1f} mm below carries it",
                                       scene_.support->gap * 1000)
                         : fmt::format("its centre of mass is not {:.0f} mm inside of what "
                                       "carries it",
                                       kMargin * 1000))});
  }

  struct Feet {
    std::vector<Vec2> at;
    double margin = kMargin - kMarginSlack;  ///< m: so far inside must a centre of mass be
  };
  /// Where it rests on these. What is round is larger than its triangles, by about the margin.
  Feet feet(int index, const std::vector<int>& carriers) {
    const Standing& each = standing_[at(index)];
    Feet points;
    if (each.hull->is_round) points.margin = 0;
    const auto add_to_points = [&](const std::vector<Vec2>& more) {
      points.at.insert(points.at.end(), more.begin(), more.end());
    };
    for (const int other : carriers) {
      const auto [known, is_new] = feet_.try_emplace({index, other});
      if (is_new) {
        Standing& under = standing_[at(other)];
        if (under.top.empty()) under.top = faces_looking(*under.hull, under.X_WS, true);
        known->second =
            footing(faces_looking(*each.hull, each.X_WS, false), under.top, gap_, depth_);
      }
      add_to_points(known->second);
      if (standing_[at(other)].hull->is_round && !known->second.empty()) points.margin = 0;
    }
    if (scene_.site.empty()) {
      add_to_points(
          footing(faces_looking(*each.hull, each.X_WS, false), ground(each.bounds), gap_, depth_));
    }
    return points;
  }

  bool is_carried(int index, Ticks time, const Feet& points, const std::vector<int>& carriers) {
    const Standing& each = standing_[at(index)];
    const SceneComponent& component = scene_.components[at(each.component)];
    const Vec2 centre = (each.X_WS * each.hull->centre_of_mass).head<2>();
    const bool balances = scene_.support->friction && component.mass > 0;
    if (balances ? is_as_wide(points.at, points.margin)
                 : is_between(centre, points.at, points.margin)) {
      return true;
    }
    if (is_held(index, fixed_by(component, time), carriers)) return true;
    return !points.at.empty() &&
           (component.has_brace_crew || is_held(index, component.braced_by, carriers));
  }

  /// Whether what stands is carried by what came to stand before it, down to the site: parts that
  /// hold only each other have no such order.
  void check_grounds() {
    turns_.assign(standing_.size(), 0);
    std::map<Ticks, std::pair<std::vector<int>, std::vector<int>>> events;  // taken, put
    for (int i = 0; i < components_; ++i) {
      const Standing& each = standing_[at(i)];
      if (each.floats_until < each.to) {
        turns_[at(i)] = kNoTurn;
        events[std::max(each.from, each.floats_until)].second.push_back(i);
      }
      if (each.to < until_) events[each.to].first.push_back(i);
    }
    for (const auto& [time, event] : events) {
      std::set<int> loose = loose_without(event.first, time);
      for (const int each : event.second) {
        if (stands(standing_[at(each)], time)) loose.insert(each);
      }
      ground_again(loose, time);
      tell_loose(loose, time);
    }
  }

  /// By those whose turn was before `turn` and that are not loose.
  bool is_carried_before(int index, Ticks time, std::int64_t turn, const std::set<int>& loose) {
    std::vector<int> carriers;
    for (const int other : near(index)) {
      if (turns_[at(other)] < turn && !loose.contains(other) && stands(standing_[at(other)], time))
        carriers.push_back(other);
    }
    return is_carried(index, time, feet(index, carriers), carriers);
  }

  /// Those that lose what came to stand before them when these are taken.
  std::set<int> loose_without(const std::vector<int>& taken, Ticks time) {
    std::set<std::pair<std::int64_t, int>> open;
    const auto ask_near = [&](int index) {
      for (const int other : near(index)) {
        const std::int64_t turn = turns_[at(other)];
        const bool is_later = turns_[at(index)] < turn && turn < kNoTurn;
        if (is_later && !known_loose_.contains(other) && stands(standing_[at(other)], time))
          open.emplace(turn, other);
      }
    };
    for (const int each : taken) ask_near(each);
    std::set<int> loose;
    while (!open.empty()) {
      const auto [turn, index] = *open.begin();
      open.erase(open.begin());
      if (is_carried_before(index, time, turn, loose)) continue;
      loose.insert(index);
      ask_near(index);
    }
    return loose;
  }

  /// Takes those out that others carry that are not loose, from below.
  void ground_again(std::set<int>& loose, Ticks time) {
    std::set<std::pair<double, int>> open;
    const auto ask = [&](int index) { open.emplace(standing_[at(index)].bounds.lower.z(), index); };
    for (const int index : loose) ask(index);
    while (!open.empty()) {
      const int index = open.begin()->second;
      open.erase(open.begin());
      if (!is_carried_before(index, time, kNoTurn, loose)) continue;
      loose.erase(index);
      turns_[at(index)] = ++last_turn_;
      for (const int other : near(index)) {
        if (loose.contains(other)) ask(other);
      }
    }
  }

  void tell_loose(const std::set<int>& loose, Ticks time) {
    std::vector<std::string> names;
    bool are_told = false;
    for (const int index : loose) {
      names.push_back(scene_.components[at(standing_[at(index)].component)].name);
      // What nothing carries at all is told of by itself.
      are_told = are_told || !is_carried_before(index, time, kNoTurn, {});
    }
    for (const int index : loose) {
      if (turns_[at(index)] == kNoTurn) turns_[at(index)] = ++last_turn_;
      known_loose_.insert(index);
    }
    if (names.empty() || are_told) return;
    constexpr std::size_t kMostNames = 5;
    const std::size_t more = names.size() > kMostNames ? names.size() - kMostNames : 0;
    names.resize(names.size() - more);
    faults_.push_back({FaultKind::support, ResultFile::trace, 0, "", time,
                       fmt::format("{}{} hold only each other", fmt::join(names, ", "),
                                   more > 0 ? fmt::format(" and {} more", more) : "")});
  }

  bool stands(const Standing& each, Ticks time) const {
    return each.from <= time && time < each.to && !floats(each, time);
  }

  /// Carried by what is outside: the ground, soil, what is fixed to the site.
  bool is_anchored(int index, Ticks time) {
    const Standing& each = standing_[at(index)];
    if (each.component < 0) return true;
    const SceneComponent& component = scene_.components[at(each.component)];
    if (soils_.contains(component.name)) return true;
    const auto is_site = [](const std::string& name) { return name == kSite; };
    const std::vector<std::string> fixed = fixed_by(component, time);
    if (std::none_of(fixed.begin(), fixed.end(), is_site)) return false;
    return is_held(index, {kSite}, near(index));
  }

  /// Points at which one that stands rests on another, once each, the margin inside. Neither moves
  /// while it stands.
  const std::vector<FootingPoint>& bearing(int over, int under) {
    const auto [known, is_new] = bearings_.try_emplace({over, under});
    if (!is_new) return known->second;
    Standing& lower = standing_[at(under)];
    if (lower.top.empty()) lower.top = faces_looking(*lower.hull, lower.X_WS, true);
    known->second = distinct(lower.top, over, lower.hull->is_round);
    return known->second;
  }
  std::vector<FootingPoint> distinct(const Faces& top, int over, bool is_round) const {
    const Standing& upper = standing_[at(over)];
    std::vector<FootingPoint> points;
    std::set<std::array<std::int64_t, 6>> seen;
    for (const FootingPoint& each :
         footing_points(faces_looking(*upper.hull, upper.X_WS, false), top, gap_, depth_)) {
      std::array<std::int64_t, 6> key;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<Eigen::Index>(axis);
        key[axis] = std::llround(each.point[i] * 1e6);
        key[axis + 3] = std::llround(each.normal[i] * 1e6);
      }
      if (seen.insert(key).second) points.push_back(each);
    }
    return is_round || upper.hull->is_round ? points : drawn_in(points, kMargin - kMarginSlack);
  }

  void check_balance(const std::vector<int>& first, Ticks time) {
    const std::vector<int> members = unbalanced_with(first, time);
    if (members.empty()) return;
    const std::string& name = scene_.components[at(standing_[at(members[0])].component)].name;
    faults_.push_back({FaultKind::support, ResultFile::trace, 0, "", time,
                       fmt::format("{} and what it rests on do not stand: their weights cannot be "
                                   "balanced",
                                   name)});
  }

  bool balances(int index, Ticks time) {
    const bool balances = unbalanced_with({index}, time).empty();
    balanced_.clear();
    return balances;
  }

  /// What has forces with these, if their weights cannot be balanced just after `time`; nothing
  /// where they can, or that is known.
  std::vector<int> unbalanced_with(const std::vector<int>& first, Ticks time) {
    std::vector<int> members;
    if (!scene_.support->friction) return members;
    std::map<int, int> body_of;
    const auto take = [&](int index) {
      const Standing& each = standing_[at(index)];
      if (each.component < 0 || !stands(each, time) || is_anchored(index, time)) return;
      if (body_of.emplace(index, static_cast<int>(members.size())).second) {
        members.push_back(index);
      }
    };
    for (const int index : first) take(index);
    std::vector<BalancedBody> bodies;
    std::vector<std::pair<int, int>> rests;
    std::vector<std::pair<int, int>> joints;
    for (std::size_t next = 0; next < members.size(); ++next) {
      const int index = members[next];
      const Standing& each = standing_[at(index)];
      const SceneComponent& component = scene_.components[at(each.component)];
      std::vector<int> around;
      for (const int other : near(index)) {
        if (stands(standing_[at(other)], time)) around.push_back(other);
      }
      for (const int other : around) {
        if (!bearing(index, other).empty()) {
          rests.emplace_back(index, other);
          take(other);
        }
        const Standing& its = standing_[at(other)];
        if (its.component < 0) continue;
        if (!bearing(other, index).empty()) take(other);
        const SceneComponent& named = scene_.components[at(its.component)];
        if (is_held(index, fixed_by(component, time), {other})) {
          joints.emplace_back(index, other);
          take(other);
        }
        if (is_held(other, fixed_by(named, time), {index})) take(other);
      }
      bodies.push_back({each.X_WS * each.hull->centre_of_mass, component.mass,
                        component.has_brace_crew || is_held(index, component.braced_by, around)});
    }
    if (members.empty() || !balanced_.emplace(members, time).second) return {};
    std::vector<BalancePoint> points;
    for (const auto& [over, under] : rests) {
      const auto lower = body_of.find(under);
      for (const FootingPoint& each : bearing(over, under)) {
        points.push_back({body_of[over], lower == body_of.end() ? -1 : lower->second, each});
      }
    }
    if (scene_.site.empty()) {
      for (const int index : members) {
        for (const FootingPoint& each :
             distinct(ground(standing_[at(index)].bounds), index, false)) {
          points.push_back({body_of[index], -1, each});
        }
      }
    }
    std::vector<BalanceJoint> fixed;
    for (const auto& [one, other] : joints) {
      const auto second = body_of.find(other);
      fixed.push_back({body_of[one], second == body_of.end() ? -1 : second->second});
    }
    if (balance_of(bodies, points, fixed, *scene_.support->friction) != Balance::fails) return {};
    return members;
  }

  static Faces ground(const Bounds& box) {
    const Vec3 a(box.lower.x() - 1, box.lower.y() - 1, 0);
    const Vec3 b(box.upper.x() + 1, box.lower.y() - 1, 0);
    const Vec3 c(box.upper.x() + 1, box.upper.y() + 1, 0);
    const Vec3 d(box.lower.x() - 1, box.upper.y() + 1, 0);
    return {{a, b, c}, {a, c, d}};
  }

  inline static const std::string kSite = "site";

  const Scene& scene_;
  Faults& faults_;
  Ticks until_;
  double gap_, depth_;
  std::set<std::string> floating_;
  std::vector<Hull> hulls_, site_hulls_;
  std::vector<Standing> standing_;
  int components_ = 0;  ///< of `standing_` so many are of components
  BoxTree tree_;
  std::set<std::pair<int, Ticks>> checked_;
  std::set<std::string> soils_;
  std::map<std::string, Ticks> done_;  ///< when tasks were done
  std::map<std::pair<int, int>, std::vector<FootingPoint>> bearings_;
  std::set<std::pair<std::vector<int>, Ticks>> balanced_;
  std::map<std::pair<int, int>, std::vector<Vec2>> feet_;
  std::map<std::pair<int, int>, bool> touches_;
  /// In which turn each came to stand by those of earlier turns; the site is there before.
  static constexpr std::int64_t kNoTurn = std::numeric_limits<std::int64_t>::max();
  std::vector<std::int64_t> turns_;
  std::int64_t last_turn_ = 0;
  std::set<int> known_loose_;
};

}  // namespace

void check_support(const Trace& trace, const SiteParts& site, const std::vector<Stay>& stays,
                   Ticks until, Faults& faults) {
  if (!trace.scene.support || trace.scene.support->mode != "on") return;
  SupportCheck(trace, site, stays, until, faults).run();
}

}  // namespace rubicon::verify
