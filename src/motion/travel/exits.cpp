#include "src/motion/travel/exits.hpp"

#include <algorithm>
#include <optional>

namespace rubicon::travel {
namespace {

/// m outside of an outline: more than the rounding to the lattice.
constexpr double kOutside = 4 / kPitchesPerMetre;
/// m; exits that are nearer to each other are one.
constexpr double kSameExit = 1e-5;
/// As many edges are looked at.
constexpr std::size_t kMostEdges = 48;

std::size_t at_number(int number) { return static_cast<std::size_t>(number); }

Vec2 left_of(const Edge& edge) { return {-edge.heading.y(), edge.heading.x()}; }

class ExitFinder {
 public:
  ExitFinder(const Outline& outline, const Vec2& place) : outline_(outline), place_(place) {}

  void look_at_edges() {
    std::vector<Exit> nearest;
    each_edge([&](int number, const Composite& composite, const Edge& edge) {
      const Vec2 from = composite.nodes[at_number(edge.from)].p;
      const double along = std::clamp((place_ - from).dot(edge.heading), 0.0, edge.length);
      Vec2 outwards = left_of(edge);
      if (along == 0) outwards += left_of(composite.edges[at_number(edge.previous)]);
      if (along == edge.length) outwards += left_of(composite.edges[at_number(edge.next)]);
      nearest.push_back(exit_at(from + along * edge.heading, outwards, number, edge.loop));
    });
    sort(nearest);
    for (std::size_t i = 0; i < std::min(nearest.size(), kMostEdges); ++i) offer(nearest[i]);
  }

  /// To where it first leads out of what covers the place.
  void look_along(const Vec2& direction) {
    std::optional<Exit> first;
    each_edge([&](int number, const Composite& composite, const Edge& edge) {
      const double across = edge.heading.x() * direction.y() - edge.heading.y() * direction.x();
      if (across <= 0) return;
      const Vec2 way = place_ - composite.nodes[at_number(edge.from)].p;
      const double along = (way.x() * direction.y() - way.y() * direction.x()) / across;
      const double distance = (way.x() * edge.heading.y() - way.y() * edge.heading.x()) / across;
      if (along < 0 || along > edge.length || distance < 0) return;
      if (first && first->distance <= distance) return;
      const Vec2 point = place_ + distance * direction;
      first = exit_at(point, left_of(edge), number, edge.loop);
    });
    if (first) offer(*first);
  }

  std::vector<Exit> found() {
    sort(exits_);
    return std::move(exits_);
  }

 private:
  template <typename Look>
  void each_edge(const Look& look) const {
    for (std::size_t i = 0; i < outline_.composites().size(); ++i) {
      const Composite& composite = outline_.composites()[i];
      for (const Edge& edge : composite.edges) look(static_cast<int>(i), composite, edge);
    }
  }

  Exit exit_at(const Vec2& point, const Vec2& outwards, int composite, int loop) const {
    const Vec2 place = metres(snap(point + kOutside * outwards));
    return {place, (place - place_).norm(), composite, loop};
  }

  static void sort(std::vector<Exit>& exits) {
    std::stable_sort(exits.begin(), exits.end(),
                     [](const Exit& a, const Exit& b) { return a.distance < b.distance; });
  }

  void offer(const Exit& exit) {
    const bool known = std::any_of(exits_.begin(), exits_.end(), [&](const Exit& other) {
      return (other.place - exit.place).norm() <= kSameExit;
    });
    if (!known && !outline_.covers(ExactPoint(snap(exit.place)))) exits_.push_back(exit);
  }

  const Outline& outline_;
  Vec2 place_;
  std::vector<Exit> exits_;
};

}  // namespace

std::vector<Exit> exits_of(const Outline& outline, const Vec2& place,
                           std::span<const Vec2> directions) {
  if (!outline.covers(ExactPoint(snap(place)))) return {};
  ExitFinder finder(outline, place);
  finder.look_at_edges();
  for (const Vec2& direction : directions) finder.look_along(direction);
  return finder.found();
}

}  // namespace rubicon::travel
