#include "src/simulation/site/support.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "src/simulation/site/equilibrium.hpp"
#include "src/simulation/site/make_site.hpp"

namespace rubicon::site {

namespace {

using interpreter::ThingRef;

/// m: the side of a square of the index.
constexpr double kSquare = 4;
/// What is in more squares than this is looked at by everybody.
constexpr int kManySquares = 256;

/// m: a gap that is met to this is met.
constexpr double kRounding = 1e-9;

/// m: so far inside of what carries it must be a centre of mass. Reason: a thing on an edge turns.
constexpr double kMargin = 1e-3;

/// m: less than the margin by so much is rounding. Consequence: where a plan lies decides nothing.
constexpr double kMarginRounding = 1e-6;

/// m: nearer to an edge than this is on it.
constexpr double kOnEdge = 5e-5;

/// m: how exactly the distance from what a component is fixed to is measured.
constexpr double kResolution = 1e-4;

std::string length_text(double metres) {
  const double millimetres = metres * 1000;
  if (millimetres >= 9999.5) return fmt::format("{:.1f} m", metres);
  return millimetres < 9.95 ? fmt::format("{:.1f} mm", millimetres)
                            : fmt::format("{:.0f} mm", millimetres);
}

/// With as many digits as tell it from the limit that it misses.
std::string length_text(double metres, double limit) {
  std::string text = length_text(metres);
  for (int digits = 1; digits <= 3 && text == length_text(limit); ++digits) {
    const std::string exact = fmt::format("{:.{}f} mm", metres * 1000, digits);
    if (exact != fmt::format("{:.{}f} mm", limit * 1000, digits)) text = exact;
  }
  return text;
}

/// Where a centre of mass is that is so far inside of what carries it; outside: negative.
std::string place_text(double inside) {
  if (std::abs(inside) < kOnEdge) return "on the edge";
  return inside < 0 ? length_text(-inside) + " outside"
                    : "only " + length_text(inside, kMargin) + " inside";
}

}  // namespace

Support::Support(const interpreter::PlanModel& plan, const SiteWorld& site,
                 const std::vector<SupportSurfacePtr>& surfaces)
    : plan_(plan),
      site_(site),
      gap_(plan.support.gap + kRounding),
      depth_(std::max(plan.support.gap, 2 * plan.contact) + kRounding),
      surfaces_(surfaces) {
  const std::size_t things = plan.components.size() + plan.site.size() + 1;
  surfaces_.resize(things);
  bodies_.resize(things);
  placed_.resize(things);
  floating_.resize(things);
  ranks_.assign(plan.components.size(), kUnranked);
  for (std::size_t i = 0; i < plan.components.size(); ++i) {
    if (surfaces_[i] && site.stands(static_cast<int>(i))) {
      place(static_cast<Thing>(i), site.X_WO(static_cast<int>(i)));
    }
  }
  read_ = site.component_changes().size();
  for (std::size_t i = 0; i < plan.site.size(); ++i) {
    const std::size_t thing = plan.components.size() + i;
    place(static_cast<Thing>(thing), math::Pose::Identity());
  }
  if (plan.site.empty()) ground_ = static_cast<Thing>(things - 1);
}

std::string Support::name_of(Thing thing) const {
  if (is_component(thing)) return plan_.components[at(thing)].name;
  if (thing == ground_) return "the ground (z = 0)";
  return site_shape_name(plan_.site_names, at(thing - components()), plan_.site.size());
}

/// What was put down or taken since.
void Support::follow() {
  const std::vector<int>& changes = site_.component_changes();
  for (; read_ < changes.size(); ++read_) {
    const int component = changes[read_];
    if (!surfaces_[at(component)]) continue;
    take_away(component);
    // Soil that is being dug carries nothing.
    if (site_.stands(component) && site_.surface(component) == nullptr) {
      place(component, site_.X_WO(component));
      ranks_[at(component)] = ++last_rank_;
    }
  }
  look_again();
}

/// What did not stand at the beginning may stand once a task has fixed it, and what rests on it
/// with it. A run may go back to before that.
void Support::look_again() {
  if (!is_done_ || awaited_.empty()) return;
  std::vector<bool> done;
  for (const int task : awaited_) done.push_back(is_done_(task));
  if (done == history_.back().done) return;
  const auto is_later = [&](const Floating& entry) {
    for (std::size_t i = 0; i < done.size(); ++i) {
      if (entry.done[i] && !done[i]) return true;
    }
    return false;
  };
  while (is_later(history_.back())) history_.pop_back();
  floating_ = history_.back().floating;
  if (done == history_.back().done) return;
  std::set<int> open;
  for (int i = 0; i < components(); ++i) {
    const std::vector<interpreter::Fixing>& fixings = plan_.components[at(i)].fixed_to;
    const bool is_fixed_now = std::any_of(fixings.begin(), fixings.end(), [&](const auto& each) {
      return each.after >= 0 && is_done_(each.after);
    });
    if (is_fixed_now && floats(i)) open.insert(i);
  }
  while (!open.empty()) {
    const int each = *open.begin();
    open.erase(open.begin());
    if (!placed_[at(each)].stands || !stands_at_last(each)) continue;
    for (const int other : beside(each)) {
      if (floats(other)) open.insert(other);
    }
  }
  history_.push_back({std::move(done), floating_});
}

/// Whether what floated stands now: by its contact and what holds it, and by the balance of forces.
bool Support::stands_at_last(int component) {
  if (!stands_by(component, {})) return false;
  floating_[at(component)] = false;
  if (plan_.support.equilibrium && Equilibrium(*this).collapse_of({component})) {
    floating_[at(component)] = true;
    return false;
  }
  Rank& rank = ranks_[at(component)];
  if (!stands_by(component, {.up_to = rank - 1})) rank = ++last_rank_;
  return true;
}

std::vector<std::pair<int, int>> Support::cells_of(const Placed& placed, double grown) const {
  std::vector<std::pair<int, int>> cells;
  const auto square = [](double x) {
    return static_cast<int>(std::clamp(std::floor(x / kSquare), -1e8, 1e8));
  };
  const int x0 = square(placed.lower.x() - grown);
  const int x1 = square(placed.upper.x() + grown);
  const int y0 = square(placed.lower.y() - grown);
  const int y1 = square(placed.upper.y() + grown);
  if ((std::int64_t{x1} - x0 + 1) * (std::int64_t{y1} - y0 + 1) > kManySquares) return cells;
  for (int x = x0; x <= x1; ++x) {
    for (int y = y0; y <= y1; ++y) cells.emplace_back(x, y);
  }
  return cells;
}

void Support::place(Thing thing, const math::Pose& X_WO) {
  Placed& placed = placed_[at(thing)];
  placed.stands = true;
  placed.X_WO = X_WO;
  placed.top.reset();
  const SupportSurface& surface = *surfaces_[at(thing)];
  const math::Vec3 middle = X_WO * math::Vec3((surface.lower + surface.upper) / 2);
  const math::Vec3 half =
      X_WO.linear().cwiseAbs() * math::Vec3((surface.upper - surface.lower) / 2);
  placed.lower = middle - half;
  placed.upper = middle + half;
  const auto cells = cells_of(placed, 0);
  for (const auto& cell : cells) squares_[cell].push_back(thing);
  if (cells.empty()) wide_.push_back(thing);
}

void Support::take_away(Thing thing) {
  Placed& placed = placed_[at(thing)];
  if (!placed.stands) return;
  placed.stands = false;
  const auto cells = cells_of(placed, 0);
  for (const auto& cell : cells) std::erase(squares_[cell], thing);
  if (cells.empty()) std::erase(wide_, thing);
}

/// Things whose squares are those of a box, by number.
std::vector<Support::Thing> Support::near(const math::Vec3& lower, const math::Vec3& upper) {
  std::vector<Thing> found = wide_;
  Placed box;
  box.lower = lower;
  box.upper = upper;
  const auto cells = cells_of(box, plan_.support.gap + 2 * plan_.contact);
  for (const auto& cell : cells) {
    const auto square = squares_.find(cell);
    if (square == squares_.end()) continue;
    found.insert(found.end(), square->second.begin(), square->second.end());
  }
  if (cells.empty()) {
    found.clear();
    for (Thing thing = 0; thing < static_cast<Thing>(placed_.size()); ++thing) {
      if (placed_[at(thing)].stands) found.push_back(thing);
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

const StandingSurface& Support::top_of(Thing thing) {
  Placed& placed = placed_[at(thing)];
  if (!placed.top) placed.top = looking_up(*surfaces_[at(thing)], placed.X_WO);
  return *placed.top;
}

const collision::BodyPtr& Support::body_of(Thing thing) {
  collision::BodyPtr& body = bodies_[at(thing)];
  if (!body) {
    body = is_component(thing)
               ? prepare_named(plan_.components[at(thing)].shapes, name_of(thing))
               : prepare_named({plan_.site[at(thing - components())]}, name_of(thing));
  }
  return body;
}

bool Support::floats(Thing thing) const {
  return floating_[at(thing)] &&
         (!is_component(thing) ||
          placed_[at(thing)].X_WO.matrix() == plan_.components[at(thing)].X_WO.matrix());
}

/// In warned plans also what does not stand itself.
bool Support::carries(Thing thing, const Carriers& carriers) const {
  const bool strict = plan_.support.mode == interpreter::SupportRules::Mode::on;
  if (thing == carriers.without || !placed_[at(thing)].stands) return false;
  if (!is_component(thing)) return true;
  return ranks_[at(thing)] <= carriers.up_to && !(strict && floats(thing)) &&
         !(carriers.fallen && carriers.fallen->contains(thing));
}

bool Support::touches(int component, const math::Pose& X_WO, Thing thing) {
  const auto& body = body_of(component);
  if (!body) return false;
  collision::CollisionWorld alone;
  alone.insert(body_of(thing), placed_[at(thing)].X_WO);
  collision::SweptQuery query;
  query.contact_tolerance = plan_.contact;
  query.items.push_back({{body.get(), geometry::stationary(X_WO)}, true});
  return alone.clearance(query, gap_ + kResolution, kResolution).upper_bound <= gap_ + kResolution;
}

/// The first of them that the component touches, or a crew (-1).
std::optional<Support::Thing> Support::holder(const std::vector<ThingRef>& holders, int component,
                                              const math::Pose& X_WO, const Carriers& carriers) {
  for (const ThingRef& each : holders) {
    if (each.kind == ThingRef::Kind::crew) return -1;
    if (each.kind == ThingRef::Kind::component) {
      if (!surfaces_[at(each.index)] || !carries(each.index, carriers)) continue;
      if (touches(component, X_WO, each.index)) return each.index;
      continue;
    }
    for (std::size_t i = 0; i < plan_.site.size(); ++i) {
      const Thing thing = components() + static_cast<Thing>(i);
      if (touches(component, X_WO, thing)) return thing;
    }
  }
  return std::nullopt;
}

/// The ground, as far as it is below a box.
StandingSurface Support::ground_under(const math::Vec3& lower, const math::Vec3& upper) {
  SupportSurface plane;
  plane.facets.push_back({{{lower.x() - 1, lower.y() - 1, 0},
                           {upper.x() + 1, lower.y() - 1, 0},
                           {upper.x() + 1, upper.y() + 1, 0},
                           {lower.x() - 1, upper.y() + 1, 0}},
                          math::Vec3::UnitZ()});
  return looking_up(plane, math::Pose::Identity());
}

/// What the component is fixed to by now.
std::vector<ThingRef> Support::fixings_of(int component) const {
  std::vector<ThingRef> fixings;
  for (const interpreter::Fixing& each : plan_.components[at(component)].fixed_to) {
    if (each.after < 0 || (is_done_ && is_done_(each.after))) fixings.push_back(each.to);
  }
  return fixings;
}

/// "; it is fixed to slab only after grout"; "" if nothing is left to do.
std::string Support::pending_fixings(int component) const {
  std::vector<std::string> texts;
  for (const interpreter::Fixing& each : plan_.components[at(component)].fixed_to) {
    if (each.after < 0 || (is_done_ && is_done_(each.after))) continue;
    const bool is_site = each.to.kind == ThingRef::Kind::site;
    texts.push_back(fmt::format("{} only after {}", is_site ? "site" : name_of(each.to.index),
                                plan_.tasks[at(each.after)].name));
  }
  return texts.empty() ? "" : fmt::format("; it is fixed to {}", fmt::join(texts, ", to "));
}

/// Whether the thing says that it is fixed to the component.
bool Support::hangs_on(Thing thing, int component) const {
  if (!is_component(thing)) return false;
  const std::vector<ThingRef> fixed = fixings_of(thing);
  return std::find(fixed.begin(), fixed.end(), ThingRef{ThingRef::Kind::component, component}) !=
         fixed.end();
}

/// What is fixed to the component carries it only if it stands without it; asked for what is judged
/// first, so that the question ends.
Support::Answer Support::judge(int component, const math::Pose& X_WO, const Carriers& carriers,
                               bool is_first) {
  Answer answer;
  const SupportSurfacePtr& surface = surfaces_[at(component)];
  if (!surface) return {true, {}, {}};
  const StandingSurface bottom = looking_down(*surface, X_WO);
  const math::Vec3 middle = X_WO * math::Vec3((surface->lower + surface->upper) / 2);
  const math::Vec3 half =
      X_WO.linear().cwiseAbs() * math::Vec3((surface->upper - surface->lower) / 2);
  const math::Vec3 lower = middle - half;
  const math::Vec3 upper = middle + half;
  std::vector<Vec2> points;
  std::optional<Thing> not_standing;
  const auto rest_on = [&](Thing thing, const StandingSurface& top) {
    const Resting resting = rest(bottom, top, gap_, depth_, plan_.contact);
    if (resting.points.empty()) return;
    if (thing != ground_ && !carries(thing, carriers)) {
      if (!not_standing) not_standing = thing;
      return;
    }
    if (is_first && hangs_on(thing, component) &&
        !judge(thing, placed_[at(thing)].X_WO, {.without = component, .for_reason = false}, false)
             .stands) {
      return;
    }
    points.insert(points.end(), resting.points.begin(), resting.points.end());
    answer.held_by.push_back(thing);
  };
  for (const Thing thing : near(lower, upper)) {
    const Placed& placed = placed_[at(thing)];
    if (thing == component || thing == carriers.without) continue;
    if (placed.lower.z() > upper.z() + gap_ || placed.upper.z() < lower.z() - gap_) continue;
    rest_on(thing, top_of(thing));
  }
  if (ground_ >= 0) {
    rest_on(ground_, ground_under(lower, upper));
  }
  const interpreter::ComponentSpec& spec = plan_.components[at(component)];
  if (const auto held = holder(fixings_of(component), component, X_WO, carriers)) {
    return {true, {*held}, {}};
  }
  const Vec2 centre = (X_WO * surface->centre_of_mass).head<2>();
  const std::vector<Vec2> outline = convex_hull(points);
  const double inside = depth_in_polygon(outline, centre);
  // What has no weight turns nothing in the balance of forces: it is judged by its middle.
  const bool balances = plan_.support.equilibrium && spec.mass > 0;
  answer.stands = balances ? !inset(outline, kMargin - kMarginRounding).empty()
                           : inside >= kMargin - kMarginRounding;
  if (answer.stands) return answer;
  if (!points.empty()) {
    if (const auto brace = holder(spec.braced_by, component, X_WO, carriers)) {
      answer.stands = true;
      answer.held_by.push_back(*brace);
      return answer;
    }
  }
  if (!carriers.for_reason) return answer;
  if (!points.empty()) {
    std::vector<std::string> names;
    for (const Thing thing : answer.held_by) names.push_back(name_of(thing));
    constexpr std::size_t kMostNames = 3;
    const std::size_t more = names.size() > kMostNames ? names.size() - kMostNames : 0;
    names.resize(names.size() - more);
    const std::string where =
        balances ? fmt::format("it rests on less than {:.0f} mm", 2 * kMargin * 1000)
                 : fmt::format("its centre of mass is {}", place_text(inside));
    answer.reason =
        fmt::format("{} of {}{}{}", where, balances ? "" : "what carries it, ",
                    fmt::join(names, ", "), more > 0 ? fmt::format(" and {} more", more) : "");
  } else if (not_standing) {
    answer.reason = fmt::format("it rests on {}, which does not stand", name_of(*not_standing));
  } else {
    answer.reason = reason_below(component, bottom, carriers.without);
  }
  answer.reason += pending_fixings(component);
  return answer;
}

/// Nothing carries it: what comes nearest.
std::string Support::reason_below(int component, const StandingSurface& bottom, Thing without) {
  double least = std::numeric_limits<double>::infinity();
  double deepest = least;
  Thing nearest = -1;
  Thing around = -1;
  Vec2 lower = Vec2::Constant(least);
  Vec2 upper = -lower;
  for (const StandingSurface::Facet& facet : bottom.facets) {
    lower = lower.cwiseMin(facet.lower);
    upper = upper.cwiseMax(facet.upper);
  }
  for (Thing thing = 0; thing < static_cast<Thing>(placed_.size()); ++thing) {
    const Placed& placed = placed_[at(thing)];
    if (thing == component || thing == without || !placed.stands) continue;
    if ((placed.lower.head<2>().array() > upper.array()).any() ||
        (placed.upper.head<2>().array() < lower.array()).any()) {
      continue;
    }
    const Resting resting = rest(bottom, top_of(thing), gap_, depth_, plan_.contact);
    if (resting.distance < least) {
      least = resting.distance;
      nearest = thing;
    }
    // A neighbour that is higher is beside it, not around it.
    const bool is_site = !is_component(thing);
    if (is_site && resting.below < deepest) {
      deepest = resting.below;
      around = thing;
    }
  }
  if (ground_ >= 0) {
    double lowest = std::numeric_limits<double>::infinity();
    for (const StandingSurface::Facet& facet : bottom.facets) {
      for (const Vec2& p : facet.outline) lowest = std::min(lowest, facet.height(p));
    }
    if (lowest > 0 && lowest < least) {
      least = lowest;
      nearest = ground_;
    } else if (lowest < 0 && nearest < 0) {
      return fmt::format("it reaches {} below the ground (z = 0, as the plan has no site)",
                         length_text(-lowest));
    }
  }
  if (nearest >= 0) {
    return fmt::format("the nearest below is {}, {} lower", name_of(nearest),
                       length_text(least, plan_.support.gap));
  }
  if (around >= 0) {
    return fmt::format("it reaches {} below {}", length_text(deepest), name_of(around));
  }
  return "nothing is below it";
}

/// Whether a component that stands does so by these.
bool Support::stands_by(int component, const Carriers& carriers) {
  Carriers only = carriers;
  only.for_reason = false;
  // Ranks and what has fallen leave no ring: nobody need be asked what stands without it.
  return judge(component, placed_[at(component)].X_WO, only, false).stands;
}

/// Components that stand where they may touch the thing.
std::vector<int> Support::beside(Thing thing) {
  const Placed& one = placed_[at(thing)];
  std::vector<int> found;
  for (const Thing each : near(one.lower, one.upper)) {
    if (each == thing || !is_component(each)) continue;
    const Placed& other = placed_[at(each)];
    if ((other.lower.array() <= one.upper.array() + gap_ + kResolution).all() &&
        (other.upper.array() >= one.lower.array() - gap_ - kResolution).all()) {
      found.push_back(each);
    }
  }
  return found;
}

void Support::sort_from_below(std::vector<int>& some) const {
  std::stable_sort(some.begin(), some.end(), [this](int a, int b) {
    return placed_[at(a)].lower.z() < placed_[at(b)].lower.z();
  });
}

/// Ranks all that stands: what the site carries, what that carries, and so on; then, from below,
/// what is carried by neither.
void Support::rank_all() {
  is_ranked_ = true;
  ranks_.assign(ranks_.size(), kUnranked);
  std::vector<int> order;
  for (int i = 0; i < components(); ++i) {
    if (surfaces_[at(i)] && placed_[at(i)].stands) order.push_back(i);
  }
  sort_from_below(order);
  std::vector<std::size_t> place(at(components()));
  std::set<std::size_t> open;
  for (std::size_t i = 0; i < order.size(); ++i) {
    place[at(order[i])] = i;
    open.insert(i);
  }
  while (!open.empty()) {
    const int each = order[*open.begin()];
    open.erase(open.begin());
    if (!stands_by(each, {.up_to = kUnranked - 1})) continue;
    ranks_[at(each)] = ++last_rank_;
    for (const int other : beside(each)) {
      if (ranks_[at(other)] == kUnranked) open.insert(place[at(other)]);
    }
  }
}

std::vector<std::pair<int, std::string>> Support::find_floating() {
  follow();
  std::fill(floating_.begin(), floating_.end(), false);
  rank_all();
  const bool strict = plan_.support.mode == interpreter::SupportRules::Mode::on;
  std::vector<int> unranked;
  for (int i = 0; i < components(); ++i) {
    if (placed_[at(i)].stands && ranks_[at(i)] == kUnranked) unranked.push_back(i);
  }
  for (const int each : unranked) floating_[at(each)] = strict || !stands_by(each, {});
  std::vector<std::pair<int, std::string>> found;
  for (const int each : unranked) {
    if (floating_[at(each)])
      found.emplace_back(each, judge(each, placed_[at(each)].X_WO, {}).reason);
  }
  sort_from_below(unranked);
  for (const int each : unranked) ranks_[at(each)] = ++last_rank_;
  if (plan_.support.equilibrium) Equilibrium(*this).find_collapsing(found);
  awaited_.clear();
  for (const auto& [each, reason] : found) {
    for (const interpreter::Fixing& fixing : plan_.components[at(each)].fixed_to) {
      if (fixing.after >= 0) awaited_.push_back(fixing.after);
    }
  }
  std::sort(awaited_.begin(), awaited_.end());
  awaited_.erase(std::unique(awaited_.begin(), awaited_.end()), awaited_.end());
  history_ = {{std::vector<bool>(awaited_.size(), false), floating_}};
  return found;
}

std::optional<std::string> Support::why_not(int component, const math::Pose& X_WO) {
  follow();
  Answer answer = judge(component, X_WO, {});
  if (answer.stands) return std::nullopt;
  return std::move(answer.reason);
}

std::string Support::left_text(const std::vector<int>& left) const {
  constexpr std::size_t kMostLeft = 5;
  std::vector<std::string> names;
  std::string pending;
  for (const int each : left) {
    if (names.size() < kMostLeft) names.push_back(name_of(each));
    if (pending.empty()) pending = pending_fixings(each);
  }
  std::string text = fmt::format("{}", fmt::join(names, ", "));
  if (left.size() > kMostLeft) text += fmt::format(" and {} more", left.size() - kMostLeft);
  text += left.size() == 1 ? " does not stand" : " do not stand";
  return text + pending;
}

/// What falls when a thing that stands is taken: those that it helped to stand, then those that
/// these helped, unless others carry them that stand without. Each is asked by rank, so that what
/// it stands by has been asked before. Those that others carry get a new rank: after these.
std::vector<int> Support::unheld(Thing taken) {
  std::set<std::pair<Rank, int>> open;
  const auto ask_beside = [&](Thing thing) {
    for (const int each : beside(thing)) {
      if (each != taken && ranks_[at(each)] > ranks_[at(thing)])
        open.emplace(ranks_[at(each)], each);
    }
  };
  std::set<Thing> fallen;
  ask_beside(taken);
  while (!open.empty()) {
    const auto [rank, each] = *open.begin();
    open.erase(open.begin());
    if (stands_by(each, {.without = taken, .up_to = rank - 1, .fallen = &fallen})) continue;
    // What did not stand before does not fall by this.
    if (!stands_by(each, {.up_to = rank - 1})) continue;
    fallen.insert(each);
    ask_beside(each);
  }
  for (const int each : fallen) open.emplace(ranks_[at(each)], each);
  while (!open.empty()) {
    const int each = open.begin()->second;
    open.erase(open.begin());
    if (!stands_by(each, {.without = taken, .fallen = &fallen})) continue;
    fallen.erase(each);
    ranks_[at(each)] = ++last_rank_;
    for (const int other : beside(each)) {
      if (fallen.contains(other)) open.emplace(ranks_[at(other)], other);
    }
  }
  return {fallen.begin(), fallen.end()};
}

std::vector<int> Support::left_without(int component) {
  follow();
  if (!surfaces_[at(component)] || !placed_[at(component)].stands) return {};
  if (!is_ranked_) rank_all();
  const std::vector<int> fallen = unheld(component);
  std::vector<int> left, in_rings;
  for (const int each : beside(component)) {
    if (floats(each)) continue;
    const math::Pose& X_WO = placed_[at(each)].X_WO;
    if (!judge(each, X_WO, {.without = component, .for_reason = false}).stands) {
      const Answer now = judge(each, X_WO, {.for_reason = false});
      const bool has_part =
          std::find(now.held_by.begin(), now.held_by.end(), component) != now.held_by.end();
      if (now.stands && has_part) left.push_back(each);
    } else if (std::binary_search(fallen.begin(), fallen.end(), each) &&
               touches(each, X_WO, component)) {
      in_rings.push_back(each);
    }
  }
  return left.empty() ? in_rings : left;
}

}  // namespace rubicon::site
