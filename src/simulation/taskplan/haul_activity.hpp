#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "src/simulation/taskplan/activity.hpp"
#include "src/simulation/taskplan/haulage.hpp"
#include "src/simulation/taskplan/motion_activity.hpp"

namespace rubicon::taskplan {

/// A truck with a body hauls what robots dig: it chooses one of them, queues, is loaded, drives to
/// where it tips, and comes back, until all of them are done. All of its ways are motions by its
/// behaviour or its guides. What it shares with those who dig is in the `Haulage` of the stage.
class HaulActivity : public Activity {
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
    return std::make_unique<HaulActivity>(*this);
  }

 private:
  /// What is under way; in this order for each load.
  enum class Part : std::uint8_t {
    choosing,  ///< it waits until there is a place for it
    coming,    ///< to the queue, or to where it is loaded
    queueing,  ///< it waits for its turn
    entering,  ///< to the place before its own in the queue, or to where it is loaded
    loading,   ///< it waits until it is full
    leaving,   ///< to the first waypoint on its way to tip
    parting,   ///< it waits until nobody else tips where it could
    going,     ///< to where it tips
    raising,
    tipping,  ///< work
    lowering,
    clearing,  ///< off the place where it has tipped, for another
    done
  };

  /// A load as it lies on its earth.
  struct TippedLoad {
    std::map<int, soil::Millimetres> heights;
    soil::CubicMillimetres loose = 0;
    std::int64_t placed = 0;  ///< of the whole heap, mm of cells
  };

  /// A place where it can stand to tip.
  struct TipPlace {
    math::Pose X_WL;        ///< its tool frame there
    int cells_from_it = 0;  ///< from the place of the plan
  };

  math::Vec3 fall_E(const ActiveTask& task, const Stage& stage, const math::Pose& X_WT) const;
  std::optional<TippedLoad> lie(ActiveTask& task, Stage& stage, const math::Pose& X_WT) const;
  std::optional<TippedLoad> room(ActiveTask& task, Stage& stage) const;
  std::optional<TipPlace> place_to_tip(ActiveTask& task, Stage& stage,
                                       const math::Pose& X_WL) const;
  void open_heap(const ActiveTask& task, Stage& stage) const;
  Step go_on(ActiveTask& task, Stage& stage, Step step);
  Step next(ActiveTask& task, Stage& stage);
  Step choose(ActiveTask& task, Stage& stage);
  std::optional<Step> clear_the_tip(ActiveTask& task, Stage& stage, bool for_good);
  bool is_behind_another(const ActiveTask& task, const Stage& stage, int dig,
                         double distance) const;
  Step stand(ActiveTask& task, Stage& stage);
  Step look_in_queue(ActiveTask& task, Stage& stage);
  Step go_elsewhere(ActiveTask& task, Stage& stage);
  std::size_t behind(const ActiveTask& task, const Stage& stage);
  Step look_at_load(ActiveTask& task, Stage& stage);
  Step leave(ActiveTask& task, Stage& stage);
  Step go_to_tip(ActiveTask& task, Stage& stage);
  Step arrive_at_tip(ActiveTask& task, Stage& stage);
  Step stand_farther(ActiveTask& task, Stage& stage);
  void note_row(const ActiveTask& task, Stage& stage, int cells) const;
  void end_wait(ActiveTask& task, Stage& stage, const std::string& whom);
  Step tip(ActiveTask& task, Stage& stage);
  void note_where_it_tipped(const ActiveTask& task, Stage& stage) const;
  void forget_truck(const ActiveTask& task, Stage& stage);
  Step wait(ActiveTask& task, Stage& stage);
  Step begin_leg(ActiveTask& task, Stage& stage, std::vector<interpreter::GoalSpec> goals,
                 const char* situation, const char* what);

  static const interpreter::HaulSpec& spec_of(const ActiveTask& task, const Stage& stage);
  schedule::Ticks worked(const ActiveTask& task, const Stage& stage) const;

  Part part_ = Part::choosing;
  std::vector<interpreter::GoalSpec> rest_;  ///< where it goes after the leg that is under way
  const char* situation_ = "";               ///< of these legs
  const char* what_ = "";
  Snapshot<Activity> inner_;  ///< a motion or a work; null: none
  schedule::Ticks begun_ = 0;
  bool waits_ = false;
  schedule::Ticks since_ = 0;               ///< it waits
  int dig_ = -1;                            ///< the task that it goes to, or was loaded by
  std::size_t spot_ = 0;                    ///< its place there; behind all: it has none yet
  int stays_with_ = -1;                     ///< the robot in whose queue it stands,
  std::optional<schedule::Ticks> arrived_;  ///< and since when
  TipPlace tip_;                            ///< where it tips
  std::vector<int> at_tips_;                ///< robots that have all places where it could tip
  /// It comes from where it tipped: the waypoint of its way back that is next.
  std::optional<std::size_t> back_;
  HauledLoad load_;
  std::vector<std::pair<int, double>> lowered_;  ///< what it raises to tip, as it drives
};

}  // namespace rubicon::taskplan
