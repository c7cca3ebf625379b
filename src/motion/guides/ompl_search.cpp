#include <algorithm>

#include "src/motion/guides/planners.hpp"
#include "src/motion/ompl_bridge/ompl_library_io.hpp"

namespace rubicon::guides {

namespace {

/// What a planner of OMPL asks, answered by a space. Of the tests some are left for the shortcuts.
class SpaceQuestion : public ompl_bridge::Question {
 public:
  explicit SpaceQuestion(Space& space)
      : space_(space),
        most_checks_(space.spec().checks -
                     std::min(space.spec().improve, space.spec().checks / 2)) {}

  std::size_t size() const override { return space_.size(); }
  double lower(std::size_t i) const override { return space_.lower(i); }
  double upper(std::size_t i) const override { return space_.upper(i); }
  double weight(std::size_t i) const override { return space_.weight(i); }
  bool cyclic(std::size_t i) const override { return space_.parameter(i).cyclic; }
  bool keeps() const override { return !space_.spec().keep.empty(); }
  bool symmetric() const override { return space_.leg().heading() < 0; }
  bool steers() const override { return space_.leg().steers(); }
  double distance(std::span<const double> a, std::span<const double> b) const override {
    return space_.distance(a, b);
  }
  Point partway(std::span<const double> a, std::span<const double> b, double share) const override {
    return space_.towards(a, b, space_.distance(a, b) * share);
  }
  void fit(Point& point) const override {
    point = space_.moved(point, std::vector<double>(space_.size()));
  }
  bool stands(std::span<const double> point) override {
    return space_.keeps(space_.configuration(point)) && space_.stands(point);
  }
  bool leg_is_free(std::span<const double> a, std::span<const double> b) override {
    return space_.leg_is_free(a, b);
  }
  bool spent() const override { return static_cast<double>(space_.checks()) >= most_checks_; }

 private:
  Space& space_;
  double most_checks_;
};

}  // namespace

Search plan_by_ompl(Space& space, const Point& start, const Point& goal) {
  Search search;
  const ompl_bridge::OmplPlugin* const library = ompl_bridge::ompl_library();
  if (library == nullptr) {
    search.cause = ompl_bridge::ompl_fault();
    return search;
  }
  const GuideSpec& spec = space.spec();
  ompl_bridge::Asked asked;
  asked.planner = spec.planner;
  asked.settings = spec.settings;
  asked.seed = spec.seed;
  asked.range = spec.step;
  asked.nodes = spec.nodes;
  asked.tells_tree = spec.tells_tree;
  asked.start = start;
  asked.goal = goal;
  if (space.leg_is_free(start, goal)) {
    search.way = {start, goal};
    search.nodes = 2;
    return search;
  }
  SpaceQuestion question(space);
  ompl_bridge::Answer answer = library->plan(question, asked);
  search.way = std::move(answer.way);
  search.nodes = answer.nodes;
  search.out_of_nodes = answer.out_of_nodes;
  search.cause = std::move(answer.cause);
  search.tree = std::move(answer.tree);
  // Whatever it took for tested: each leg of the way is tested as it will be driven.
  for (std::size_t k = 0; k + 1 < search.way.size(); ++k) {
    if (space.leg_is_free(search.way[k], search.way[k + 1])) continue;
    search.way.clear();
    search.cause = "a leg of the way that " + spec.planner + " of OMPL found is refused";
  }
  return search;
}

}  // namespace rubicon::guides
