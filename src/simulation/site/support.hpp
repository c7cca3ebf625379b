#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "interpreter/check/plan_model.hpp"
#include "src/motion/collision/swept_query.hpp"
#include "src/simulation/site/resting.hpp"
#include "src/simulation/site/site_world.hpp"
#include "src/simulation/site/support_surface.hpp"

namespace rubicon::site {

/// Whether what stands on a site is carried: a component stands if its centre of mass is over the
/// hull of where it is in contact with what is below it, within the plan's gap, or if it touches
/// what it is fixed to; one that is braced needs contact below and the brace. Sites without shapes
/// have the ground, z = 0. Machines carry nothing. With `support equilibrium` the centre of mass
/// may be anywhere, and the forces between all that stands must be able to balance. How:
/// docs/support.md.
class Support {
 public:
  /// Plan and site must outlive it. `surfaces` are those of the plan's PreparedSite.
  Support(const interpreter::PlanModel& plan, const SiteWorld& site,
          const std::vector<SupportSurfacePtr>& surfaces);

  /// Fixings that need a task hold once it is done; without this none of them does.
  void set_done(std::function<bool(int task)> is_done) { is_done_ = std::move(is_done); }

  /// Looks which components do not stand where they are now, and why: nothing stands on these. By
  /// index.
  std::vector<std::pair<int, std::string>> find_floating();
  /// The reason why a component at X_WO does not stand among what stands now: "the nearest below is
  /// slab, 120 mm lower". Nothing: it stands.
  std::optional<std::string> why_not(int component, const math::Pose& X_WO);
  /// Those that stand now and would not without the component, because it holds them, or because
  /// they and what it holds would hold only each other.
  std::vector<int> left_without(int component);
  /// "wall does not stand; it is fixed to slab only after grout"
  std::string left_text(const std::vector<int>& left) const;

  /// What begins to move when forces cannot balance.
  struct Collapse {
    std::vector<int> components;  ///< that move; first those that leave what stays
    std::string text;             ///< "beam would turn on wall, and tip with it"
  };
  /// Nothing: the forces balance with the component at X_WO, or the plan does not ask.
  std::optional<Collapse> collapse_with(int component, const math::Pose& X_WO);
  /// The same when the component has been taken away.
  std::optional<Collapse> collapse_without(int component);

 private:
  friend class Equilibrium;
  using Vec2 = Eigen::Vector2d;
  /// A component by its index, then the shapes of the site, then the ground.
  using Thing = int;

  struct Placed {
    bool stands = false;
    math::Pose X_WO = math::Pose::Identity();
    math::Vec3 lower, upper;             ///< box around it, world
    std::optional<StandingSurface> top;  ///< made when asked for
  };
  /// The order in which things came to stand: each stands by what has a lower rank.
  using Rank = std::int64_t;
  static constexpr Rank kUnranked = std::numeric_limits<Rank>::max();

  /// What may carry.
  struct Carriers {
    Thing without = -1;
    Rank up_to = kUnranked;
    const std::set<Thing>* fallen = nullptr;  ///< these do not
    bool for_reason = true;                   ///< whether a reason is asked for
  };
  struct Answer {
    bool stands = false;
    std::vector<Thing> held_by;  ///< what has a part in that
    std::string reason;
  };

  bool is_component(Thing thing) const { return thing < components(); }
  int components() const { return static_cast<int>(plan_.components.size()); }
  std::string name_of(Thing thing) const;
  static std::size_t at(int index) { return static_cast<std::size_t>(index); }

  void follow();
  void look_again();
  bool stands_at_last(int component);
  void place(Thing thing, const math::Pose& X_WO);
  void take_away(Thing thing);
  std::vector<std::pair<int, int>> cells_of(const Placed& placed, double grown) const;
  std::vector<Thing> near(const math::Vec3& lower, const math::Vec3& upper);
  const StandingSurface& top_of(Thing thing);
  bool carries(Thing thing, const Carriers& carriers) const;
  Answer judge(int component, const math::Pose& X_WO, const Carriers& carriers,
               bool is_first = true);
  bool stands_by(int component, const Carriers& carriers);
  std::vector<int> beside(Thing thing);
  void sort_from_below(std::vector<int>& components) const;
  void rank_all();
  std::vector<int> unheld(Thing taken);
  static StandingSurface ground_under(const math::Vec3& lower, const math::Vec3& upper);
  std::vector<interpreter::ThingRef> fixings_of(int component) const;
  std::string pending_fixings(int component) const;
  bool hangs_on(Thing thing, int component) const;
  std::string reason_below(int component, const StandingSurface& bottom, Thing without);
  bool touches(int component, const math::Pose& X_WO, Thing thing);
  std::optional<Thing> holder(const std::vector<interpreter::ThingRef>& holders, int component,
                              const math::Pose& X_WO, const Carriers& carriers);
  const collision::BodyPtr& body_of(Thing thing);
  std::optional<Collapse> only_new(Collapse collapse, const std::vector<Thing>& around);

  /// It did not stand at the beginning, is still where it was then, and nothing that it is fixed to
  /// since then holds it.
  bool floats(Thing thing) const;

  const interpreter::PlanModel& plan_;
  const SiteWorld& site_;
  std::function<bool(int)> is_done_;
  Thing ground_ = -1;
  double gap_, depth_;
  std::size_t read_ = 0;  ///< changes of components that are known
  std::vector<SupportSurfacePtr> surfaces_;
  std::vector<collision::BodyPtr> bodies_;
  std::vector<Placed> placed_;
  std::vector<bool> floating_;
  std::vector<int> awaited_;  ///< tasks after which something is fixed that floats at the beginning
  /// What floats since these of them are done.
  struct Floating {
    std::vector<bool> done;
    std::vector<bool> floating;
  };
  std::vector<Floating> history_;  ///< from the beginning
  std::vector<Rank> ranks_;        ///< of components
  Rank last_rank_ = 0;
  bool is_ranked_ = false;
  /// Where things stand, in squares; those that are in many of them.
  std::map<std::pair<int, int>, std::vector<Thing>> squares_;
  std::vector<Thing> wide_;
};

}  // namespace rubicon::site
