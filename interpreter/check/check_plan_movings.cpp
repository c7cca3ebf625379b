#include <fmt/format.h>

#include <map>

#include "interpreter/check/check_plan_parts.hpp"
#include "src/motion/geometry/above.hpp"

namespace rubicon::interpreter::plan_check {

namespace {

/// Degrees: from here on it is not clear which way round is the short one.
constexpr double kHalfTurn = 180 - 1e-6;

/// m and degrees: two poses within it are the same place. What is written twice may be computed
/// twice.
constexpr double kSamePlace = 1e-9;
constexpr double kSameTurn = 1e-7;

bool same_place(const math::Pose& X_first, const math::Pose& X_second) {
  return (X_first.translation() - X_second.translation()).norm() <= kSamePlace &&
         geometry::turn_between_deg(X_first, X_second) <= kSameTurn;
}

class MovingCheck {
 public:
  MovingCheck(Subject& subject, const syntax::MovingItem& item)
      : subject_(subject), item_(item), who_("moving '" + item.name.text + "'") {}

  MovingSpec run() {
    MovingSpec moving;
    moving.name = item_.name.text;
    moving.span = item_.name.span;
    moving.timetable.repeat = item_.repeat;
    for (const syntax::Shape& each : item_.shapes) {
      std::optional<geometry::Shape> shape = subject_.shapes.resolve(each);
      if (!shape) continue;
      if (item_.people) {
        const double top = geometry::highest_point(*shape) + geometry::kAirOverPeople;
        moving.overhead.push_back(geometry::with_what_is_above(*shape, top));
      }
      moving.shapes.push_back(*std::move(shape));
    }
    if (item_.shapes.empty()) {
      wrong(item_.name.span, who_ + " has no shape: it would be in nobody's way",
            "write shape box(...); in its own frame");
    }
    if (item_.paths.empty()) {
      wrong(item_.name.span, who_ + " has no path",
            "write path 0 s FRAME, 20 s FRAME; with where it is at which time");
      return moving;
    }
    if (item_.paths.size() > 1) {
      subject_.twice(span_of(item_.paths[1]), "the path of " + who_ + " is given twice",
                     span_of(item_.paths[0]));
    }
    add_places(item_.paths[0], moving.timetable);
    if (is_whole_) check_ends(moving.timetable);
    return moving;
  }

 private:
  static Span span_of(const std::vector<syntax::MovingItem::Place>& path) {
    Span span = path.front().time.span;
    span.end = path.back().at.span.end;
    return span;
  }

  void wrong(Span span, std::string message, std::string hint = {}) {
    subject_.error("P49", span, std::move(message), std::move(hint));
    is_whole_ = false;
  }

  void add_places(const std::vector<syntax::MovingItem::Place>& path,
                  geometry::Timetable& timetable) {
    for (const syntax::MovingItem::Place& each : path) {
      const auto seconds = resolve_duration(subject_, each.time, "the time");
      const math::Pose X_WO = resolve_frame_or_identity(subject_, each.at);
      if (!seconds) {
        is_whole_ = false;
        continue;
      }
      geometry::TimedPlace place{schedule::ticks_from_seconds(*seconds), X_WO};
      if (!timetable.places.empty()) check_step(timetable.places.back(), place, each);
      if (item_.people && !geometry::stands_upright(X_WO)) {
        wrong(each.at.span, who_ + " has people, and leans here: what is over them must be clear",
              "turn it with rotz only");
      }
      timetable.places.push_back(place);
    }
  }

  void check_step(const geometry::TimedPlace& before, const geometry::TimedPlace& place,
                  const syntax::MovingItem::Place& written) {
    if (place.time <= before.time) {
      wrong(written.time.span,
            fmt::format("the times of a path ascend, but {:g} s comes after {:g} s",
                        schedule::seconds_from_ticks(place.time),
                        schedule::seconds_from_ticks(before.time)));
    }
    if (geometry::turn_between_deg(before.X_WO, place.X_WO) >= kHalfTurn) {
      wrong(written.at.span,
            who_ + " turns by 180 degrees to this place: which way round is not said",
            "write a place between the two");
    }
  }

  void check_ends(const geometry::Timetable& timetable) {
    const auto& path = item_.paths[0];
    if (path.size() < 2) {
      wrong(path.front().time.span, who_ + " has one place in its path; expected two or more",
            "what stands all the time is a component or a site shape");
      return;
    }
    if (timetable.repeat &&
        !same_place(timetable.places.front().X_WO, timetable.places.back().X_WO)) {
      wrong(path.back().at.span, who_ + " repeats its path, which does not end where it begins",
            "end the path at its first place");
    }
  }

  Subject& subject_;
  const syntax::MovingItem& item_;
  std::string who_;
  bool is_whole_ = true;
};

}  // namespace

void check_movings(Subject& subject) {
  std::map<std::string, Span> seen;
  for (const syntax::PlanItem& each : subject.plan.items) {
    const auto* item = std::get_if<syntax::MovingItem>(&each);
    if (item == nullptr) continue;
    MovingSpec moving = MovingCheck(subject, *item).run();
    const auto [place, is_new] = seen.emplace(moving.name, moving.span);
    if (!is_new) {
      subject.twice(moving.span, fmt::format("moving '{}' is declared twice", moving.name),
                    place->second);
      continue;
    }
    const auto component = subject.component_spans.find(moving.name);
    if (component != subject.component_spans.end()) {
      subject.twice(
          moving.span,
          fmt::format("'{}' is a component; what moves needs a name of its own", moving.name),
          component->second);
    }
    subject.model.movings.push_back(std::move(moving));
  }
}

}  // namespace rubicon::interpreter::plan_check
