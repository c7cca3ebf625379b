#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "src/earth/hauling/truck_rounds.hpp"
#include "src/earth/soil/bites.hpp"
#include "src/simulation/taskplan/activity.hpp"
#include "src/simulation/taskplan/motion_activity.hpp"

namespace rubicon::taskplan {

/// A robot digs a pit: bucket by bucket it goes to where the next cut begins, cuts, lifts, goes to
/// where it empties the bucket, and empties it, each by its behaviour, with the soil as it stands
/// then. Trucks go round by the durations of their stages; without one it waits.
class DigActivity : public Activity {
 public:
  Step begin(ActiveTask& task, Stage& stage) override;
  Step resume(ActiveTask& task, Stage& stage) override;
  Step granted(ActiveTask& task, Stage& stage, const ResourceAllocator::Grant& grant) override;
  WaitSet waits(const ActiveTask& task, const Stage& stage) const override;
  std::string text_of(const ActiveTask& task, const Stage& stage,
                      const WaitTarget& target) const override;
  std::string standstill_reason(const ActiveTask& task, const Stage& stage) const override;
  bool wakes_at(const ActiveTask& task, const Stage& stage, const SiteEvent& event) const override;
  std::vector<int> robots_in_the_way(const Stage& stage) const override;
  std::unique_ptr<Activity> snapshot() const override {
    return std::make_unique<DigActivity>(*this);
  }

 private:
  /// What is under way; in this order for each bucket.
  enum class Part : std::uint8_t {
    calling,      ///< for a truck
    approaching,  ///< to above the cut
    entering,     ///< down
    cutting,      ///< towards the machine
    filling,      ///< work
    raising,      ///< up, out of the soil
    awaiting,     ///< for a truck with a body, before it goes there
    swinging,     ///< to where the bucket is emptied
    opening,
    dumping,  ///< work
    tipping,  ///< all is dug: the last truck has to tip
    done
  };

  Step go_on(ActiveTask& task, Stage& stage, Step step);
  Step next(ActiveTask& task, Stage& stage);
  Step call_truck(ActiveTask& task, Stage& stage);
  Step wait_for_trucks(ActiveTask& task, Stage& stage, hauling::Nanoseconds time);
  Step choose_cut(ActiveTask& task, Stage& stage);
  std::vector<soil::Bite> find_cuts(const ActiveTask& task, const Stage& stage);
  bool wants_more(const ActiveTask& task, const Stage& stage) const;
  Step begin_leg(ActiveTask& task, Stage& stage, const math::Pose& X_WG, const char* situation,
                 const char* what);
  Step begin_work(ActiveTask& task, Stage& stage, const interpreter::WorkSpec& work,
                  const char* what);
  double distance_now(const ActiveTask& task, const Stage& stage) const;
  Step take(ActiveTask& task, Stage& stage);
  void fill(ActiveTask& task, Stage& stage);
  bool raise(ActiveTask& task, Stage& stage);
  void leave_cell();
  void empty(ActiveTask& task, Stage& stage);
  Step finish(ActiveTask& task, Stage& stage);
  bool is_over_truck() const {
    return inner_ && (part_ == Part::swinging || part_ == Part::opening);
  }
  void reject_for_truck(ActiveTask& task, Stage& stage);
  Step await_truck(ActiveTask& task, Stage& stage);
  void load_truck(ActiveTask& task, Stage& stage);

  static const interpreter::MotionDigSpec& spec_of(const ActiveTask& task, const Stage& stage);
  math::Pose X_WE(const ActiveTask& task, const Stage& stage) const;
  /// Worked since its beginning.
  hauling::Nanoseconds worked(const ActiveTask& task, const Stage& stage) const;
  std::string place_text(const ActiveTask& task, const Stage& stage) const;

  Part part_ = Part::calling;
  Snapshot<Activity> inner_;  ///< a motion or a work; null: none
  Ticks begun_ = 0;           ///< the task digs since then
  Ticks since_ = 0;           ///< it waits for a truck
  bool waits_for_truck_ = false;
  std::shared_ptr<const std::vector<int>> cells_;  // shared: never changed
  soil::BiteRules rules_;
  /// Its earth and all soil in it.
  std::shared_ptr<const std::set<std::string>> grounds_;  // shared: never changed
  std::vector<soil::BucketBox> boxes_;  ///< of the bucket, in the frame of its body
  std::set<int> put_off_;               ///< cells that no cut can reach
  soil::DigTarget target_;
  soil::Bite bite_;
  std::vector<double> q_entering_;        ///< where the bucket went in from
  Ticks entered_ = 0;                     ///< when
  std::map<int, soil::Millimetres> cut_;  ///< by this bucket: new heights
  soil::CubicMillimetres cut_volume_ = 0;
  BucketOutcome bucket_;
  int passes_ = 0;  ///< of this bucket
  bool is_full_ = false;
  bool is_blocked_ = false;  ///< its last cut ended short, for what stands was in the way
  std::string blocked_;      ///< why one did, since soil was taken last
  std::map<int, double> blocked_from_;  ///< by cell: where that cut began (m from the machine)
  hauling::TruckRounds trucks_;
};

}  // namespace rubicon::taskplan
