#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "src/motion/geometry/shape.hpp"
#include "src/motion/geometry/timetable.hpp"
#include "src/simulation/schedule/ticks.hpp"
#include "src/simulation/site/reserved_volume.hpp"

namespace rubicon::site {

using schedule::Ticks;

/// Why something that keeps a timetable stands: what it would enter next.
struct MovingStop {
  Ticks since = 0;
  std::string by;    ///< as in messages
  int machine = -1;  ///< whose it is
  int moving = -1;   ///< or which other thing with a timetable
};

/// How far a thing with a timetable is: by how much the timetable has shifted, and whether it
/// stands. All else follows from the time.
struct MovingState {
  int stops = 0;  ///< so far
  Ticks delay = 0;
  std::optional<MovingStop> stop;
};

/// Something that moves by a timetable, in windows: a second of a way, or the ten-thousandth part
/// of a way of more than 10,000 s; a stay is one window. When a window begins it takes all that it
/// sweeps in it, if that is free; else it stops there. What it takes is its own until the window is
/// over. Times are those of the site, poses and volumes in {W}.
class MovingThing {
 public:
  /// `body` and `overhead` (null: no people) in the frame of the timetable.
  MovingThing(std::string name, collision::BodyPtr body, collision::BodyPtr overhead,
              geometry::Timetable timetable, double contact_tolerance);

  const std::string& name() const { return name_; }
  const MovingState& state() const { return state_; }
  void set_state(MovingState state) { state_ = std::move(state); }
  bool has_people() const { return overhead_ != nullptr; }
  bool repeats() const { return timetable_.repeat; }
  Ticks period() const { return timetable_.period(); }

  /// Stands where the present window begins, from now on.
  void stop(MovingStop stop) {
    if (!state_.stop) ++state_.stops;
    state_.stop = std::move(stop);
  }
  /// Goes on now; its timetable has shifted by how long it stood.
  void go_on(Ticks now);

  bool is_gone(Ticks now) const;
  /// On the site: not before its first time, nor while it cannot come on, nor after its last.
  bool is_present(Ticks now) const;
  /// Its windows are gone through without a stop from `now` on: the site time at which the next one
  /// begins; the end of time where there is none.
  Ticks next_window(Ticks now) const;
  /// Site time at which it leaves for good; the end of time where it repeats.
  Ticks last_time() const;

  /// Where its frame is, on the site or not.
  math::Pose pose(Ticks now) const { return geometry::pose_at(timetable_, own_time(now)); }

  /// The box around all that it ever sweeps, what is above people included.
  const collision::Bounds& reach() const { return reach_; }
  /// Windows of a passage, from 0; the one that it is in, or stands before.
  int windows() const { return static_cast<int>(windows_.size()); }
  int window_at(Ticks now) const;
  /// When the window `ahead` places after the present one begins.
  Ticks window_begin(Ticks now, int ahead) const;
  /// -1: there is none.
  int window_after(Ticks now, int ahead) const;
  const collision::Bounds& bounds(int window) const { return at(window).bounds; }

  /// Its bodies over a window, as a question: first itself, then, with people, what is over them.
  const collision::SweptQuery& query(int window) const;
  /// What belongs to it now; only where it is present.
  const ReservedVolume& volume(Ticks now) const;
  const ReservedVolume& overhead(Ticks now) const;
  /// The first item of the query that meets what it sweeps in the windows that begin before
  /// `until`, from the present one on; where it stands now, as long as it stands.
  std::optional<ReservedVolume::Hit> meets(collision::MovingBodies& bodies, Ticks now, Ticks until,
                                           bool with_overhead) const;

  /// What a window was found free of, by the number of changes of it: machines, standing things.
  struct Known {
    std::uint64_t machines = 0;
    std::uint64_t standing = 0;
  };
  Known& known(int window) const { return at(window).known; }

 private:
  struct Window {
    Ticks from = 0;  ///< of the first passage
    Ticks to = 0;
    geometry::Motion motion;
    collision::Bounds bounds;
    mutable Known known;
    // made when asked for; shared: copies of a site ask the same
    mutable std::shared_ptr<const ReservedVolume> volume, overhead, standing, standing_overhead;
    mutable std::shared_ptr<const collision::SweptQuery> query;
  };

  const Window& at(int window) const { return windows_[static_cast<std::size_t>(window)]; }
  Ticks own_time(Ticks now) const {
    return (state_.stop ? state_.stop->since : now) - state_.delay;
  }
  /// Of the passage in which the own time lies, when it began, less when the first one did.
  Ticks passed(Ticks own) const;
  void add_windows(const geometry::TimedMotion& stretch);
  const ReservedVolume& volume_of(int window, bool overhead, bool standing) const;

  std::string name_;
  collision::BodyPtr body_, overhead_;
  geometry::Timetable timetable_;
  double contact_tolerance_;
  std::vector<Window> windows_;
  collision::Bounds reach_;
  MovingState state_;
};

}  // namespace rubicon::site
