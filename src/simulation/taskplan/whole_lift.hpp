#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "src/simulation/schedule/network.hpp"
#include "src/simulation/schedule/ticks.hpp"

namespace rubicon::schedule {
class WorkCalendar;
}

namespace rubicon::taskplan {

using schedule::Ticks;
struct ActiveTask;
class Stage;

/// A lift under way that is held whole (interpreter::held_whole): from its hook work, or the
/// pick-up where there is none, to its release. Nothing interrupts it; whether it was over in time
/// is judged at its end.
struct WholeLift {
  int task = -1;
  Ticks from = 0;
  Ticks shift_end = 0;  ///< of the shift of all that it needs in which it began
  bool fresh = false;   ///< it began with that shift
  bool stays = false;   ///< it has been begun again so often that it goes on, however late it is
  Ticks motion_before = 0;
  Ticks work_before = 0;  ///< of its task, before the lift
  std::vector<Ticks> over_time_before, outside_before;
  std::string because;  ///< why it waited for this shift; "": it did not
  Ticks before = 0;     ///< the end of the shift into which it did not fit then
};

/// Why a lift does not begin before a certain shift.
struct LiftNote {
  Ticks not_before = 0;
  Ticks shift_end = 0;                               ///< of the shift into which it does not fit
  std::string because;                               ///< "23 min do not fit before 12:00"
  int times = 1;                                     ///< that it was found for this task and shift
  Ticks own = 0;                                     ///< the lift's motion and crew work, at least
  std::optional<schedule::MissedShift> missed = {};  ///< whom it waited for, if it would have fit
};

/// What runs found out about lifts and went back for. A later run begins with it, but for tasks
/// that begin otherwise than before.
class LiftNotes {
 public:
  /// Null if there is none.
  const LiftNote* of(int task) const;
  void add(int task, LiftNote note);
  /// Whether lifts of the task have been begun again so often that they are no more.
  bool are_enough(int task) const;
  /// For a task that has not begun it is found out again: who was before it may have changed.
  /// What was found often stays, so that runs end.
  template <typename HasBegun>
  void forget_unless(const HasBegun& has_begun) {
    std::erase_if(notes_, [&](const auto& each) {
      return each.second.times < kMostTimes && !has_begun(each.first);
    });
  }

 private:
  static constexpr int kMostTimes = 3;
  /// So often a task begins again for its lift; each time costs what the run did since it began.
  static constexpr int kMostNotes = 100;

  std::map<int, LiftNote> notes_;
  std::map<std::pair<int, Ticks>, int> times_;
  std::map<int, int> count_;  ///< notes of each task
};

/// Whether the lift that a task is about to begin, or is in, is held whole.
bool is_held_whole(const Stage& stage, int task);
/// The hours in which all works that the lift of the task needs.
const schedule::WorkCalendar& lift_hours(Stage& stage, int task);
/// A queue with these hours, in which nobody waits.
int lift_queue(Stage& stage, int task);
/// The robot and crews that the lift needs, as resources.
std::vector<int> lift_resources(const Stage& stage, int task);
/// Less than this sooner, a lift that waited from `since` for a shift begins no sooner; `note`: why
/// it waited, null: it came out of shift.
Ticks first_gain_of_lift(Stage& stage, int task, Ticks since, const LiftNote* note);
/// The lift of the task, if it is under way and held whole; else null.
const WholeLift* lift_of(const Stage& stage, int task);

/// It begins now; `waited_for`: why it waited for this shift, null if it did not.
void begin_lift(ActiveTask& task, Stage& stage, const LiftNote* waited_for);
/// It is to be released now. False if that is not to be: it is begun again in a shift into which
/// it fits, or its task is rejected because there is none.
bool end_lift(ActiveTask& task, Stage& stage);
/// Its task begins again.
void forget_lift(Stage& stage, int task);

/// The first task under way whose lift has been going on beyond its shift and will be begun again.
std::optional<int> overdue_lift(const Stage& stage);
/// Makes the note for it and asks for the run to go back: it would have taken at least as long as
/// until now.
void repeat_overdue_lift(Stage& stage, int task);

}  // namespace rubicon::taskplan
