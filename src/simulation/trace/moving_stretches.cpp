#include "src/simulation/trace/moving_stretches.hpp"

#include <algorithm>

namespace rubicon::trace {

namespace {

using geometry::TimedPlace;

bool is_same_place(const TimedPlace& a, const TimedPlace& b) {
  return a.X_WO.isApprox(b.X_WO, 1e-12);
}

class TimetableFollower {
 public:
  TimetableFollower(const geometry::Timetable& timetable, Ticks until, std::size_t most)
      : timetable_(timetable), until_(until), most_(most) {}

  /// By its timetable, from one time of the site to another.
  void go(Ticks from, Ticks to) {
    to = std::min(to, until_);
    while (from < to && stretches_.size() < most_) {
      if (own_ < timetable_.begin()) {
        const Ticks waits = std::min(timetable_.begin() - own_, to - from);
        own_ += waits;
        from += waits;
        continue;
      }
      if (!timetable_.repeat && own_ >= timetable_.end()) return;
      const Ticks passed = timetable_.repeat ? (own_ - timetable_.begin()) / timetable_.period() *
                                                   timetable_.period()
                                             : 0;
      const Ticks at = own_ - passed;
      const auto next =
          std::upper_bound(timetable_.places.begin(), timetable_.places.end(), at,
                           [](Ticks time, const TimedPlace& place) { return time < place.time; });
      const Ticks lasts = std::min(next->time - at, to - from);
      stretches_.push_back({is_same_place(*(next - 1), *next) ? MovingStretch::Kind::stays
                                                              : MovingStretch::Kind::goes,
                            from, from + lasts, pose(), math::Pose::Identity()});
      own_ += lasts;
      from += lasts;
      stretches_.back().X_to =
          lasts == next->time - at ? next->X_WO : geometry::pose_at(timetable_, own_);
    }
  }

  /// It was stopped from one time to another; what could not come on yet is not there.
  void stop(Ticks from, Ticks to) {
    to = std::min(to, until_);
    const bool outside = own_ < timetable_.begin() || (own_ == timetable_.begin() && own_ > 0);
    if (from >= to || outside || stretches_.size() >= most_) return;
    stretches_.push_back({MovingStretch::Kind::stopped, from, to, pose(), pose()});
  }

  std::vector<MovingStretch> take() { return std::move(stretches_); }

 private:
  math::Pose pose() const { return geometry::pose_at(timetable_, own_); }

  const geometry::Timetable& timetable_;
  Ticks until_;
  std::size_t most_;
  Ticks own_ = 0;  ///< the time of the timetable
  std::vector<MovingStretch> stretches_;
};

}  // namespace

std::vector<MovingStretch> moving_stretches(const geometry::Timetable& timetable,
                                            std::span<const MovingStop> stops, Ticks until,
                                            std::size_t most) {
  TimetableFollower follower(timetable, until, most);
  Ticks since = 0;
  bool stands = false;
  for (const MovingStop& each : stops) {
    // It may be stopped by one thing after the other.
    if (each.t < since || (!each.goes_on && stands)) continue;
    if (stands) {
      follower.stop(since, each.t);
    } else {
      follower.go(since, each.t);
    }
    since = each.t;
    stands = !each.goes_on;
  }
  if (stands) {
    follower.stop(since, until);
  } else {
    follower.go(since, until);
  }
  return follower.take();
}

}  // namespace rubicon::trace
