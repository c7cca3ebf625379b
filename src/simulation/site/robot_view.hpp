#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "interpreter/program/world.hpp"
#include "src/simulation/site/free_line.hpp"
#include "src/simulation/site/site_world.hpp"
#include "src/simulation/site/step_query.hpp"

namespace rubicon::site {

/// The site as one robot's machine meets it. A step sweeps all its bodies and its load; what it may
/// not meet: everything that stands, its own bodies that are not joined, the load its bodies but
/// the hook, the zones where people work, and what belongs to other machines. The site must outlive
/// it.
class RobotView : public interpreter::World {
 public:
  RobotView(SiteWorld& site, int robot) : site_(site), index_(robot) {}

  std::optional<interpreter::HitPair> propose(const interpreter::MotionStep& step) override;
  std::optional<interpreter::HitPair> refusal(const interpreter::MotionStep& step) const override;
  double free_distance(std::span<const double> q, double heading_deg, double range) const override;
  bool is_met_moving(std::span<const double> q, double heading_deg, double range) const override;
  std::optional<interpreter::HitPair> blocked_at(std::span<const double> q) const override;
  interpreter::LegLook look_along(std::span<const double> q_from, std::span<const double> q_to,
                                  bool whole, double least) const override;
  std::uint64_t version() const override { return site_.version(index_); }
  /// `transport`, while a component is attached; `safety`, while what hangs on the tool, or else
  /// the tool, would be over people on the straight way to the goal (1995 paper, 3.2 and 4.2).
  bool situation(const std::string& name, std::span<const double> q,
                 std::span<const double> q_goal) const override;
  std::vector<guides::Thing> things() const override { return site_.things(index_); }
  guides::Nearness nearest(std::span<const double> q, double range,
                           const guides::PairsLeftOut& left_out) const override;
  guides::LaneAnswer next_node(const guides::LaneQuestion& question,
                               std::optional<interpreter::HitPair>& before) override {
    return site_.next_node(index_, question, before);
  }
  std::vector<interpreter::ForeseenWay> foreseen(std::span<const double> q,
                                                 std::span<const double> q_goal) override;
  void keep_out_of_foreseen(bool keeps) override { keeps_out_ = keeps; }
  bool loaded() const override {
    return site_.load(index_).has_value() || site_.carries_soil(index_);
  }

  /// What the load would meet that people turn by the angle about the vertical through the tool's
  /// origin, over all that it sweeps: what stands, the robot's own bodies but the hook, zones, and
  /// what belongs to other machines. Something must hang there.
  /// `until`: when they are done.
  std::optional<interpreter::HitPair> turn_hit(double angle_deg, Ticks until) const;

 private:
  class BodiesOnLeg;
  struct Legs;
  struct LineVolume;

  bool can_look_along() const;
  bool others_leave_free(std::span<const double> q_from, std::span<const double> q_to,
                         double share) const;
  bool is_ever_moved(int part) const;
  const SiteRobot& robot() const { return site_.robot(index_); }
  std::optional<interpreter::HitPair> swept_hit(const interpreter::MotionStep& step,
                                                bool on_line) const;
  bool look_ahead(const interpreter::MotionStep& step) const;
  collision::Bounds bounds_on_line(const interpreter::MotionStep& step) const;
  std::optional<interpreter::HitPair> overload(const interpreter::MotionStep& step,
                                               bool on_line) const;
  bool has_chart_for_load() const;
  bool is_allowed_by_chart(std::span<const double> q_from, std::span<const double> q_to) const;
  bool is_within_chart(std::span<const double> q) const;
  collision::SweptResult entering_hit(const StepQuery& step) const;
  std::optional<interpreter::HitPair> own_hit(const StepQuery& step) const;
  std::optional<interpreter::HitPair> others_hit(const StepQuery& step, Ticks until) const;
  bool is_load(int part) const { return part == robot().load_part(); }
  std::optional<OtherMet> other_met(const collision::SweptQuery& query, std::span<const int> parts,
                                    Ticks until) const;
  std::optional<OtherMet> people_under_load(const collision::SweptQuery& query,
                                            std::span<const int> parts, Ticks until) const;
  std::pair<collision::SweptQuery, std::vector<int>> loads_of(const collision::SweptQuery& query,
                                                              std::span<const int> parts) const;
  bool zone_met(const collision::SweptQuery& query, std::span<const int> parts,
                collision::MovingBodies& bodies) const;
  std::vector<bool> are_buffers(std::span<const int> parts) const;
  bool nothing_to_meet() const;
  collision::SweptQuery pushed(const std::vector<ReservedPart>& parts, double heading_deg,
                               double distance) const;
  bool people_below(std::span<const double> q, std::span<const double> q_goal) const;
  std::vector<ReservedPart> parts_at(std::span<const double> q) const;
  std::optional<interpreter::HitPair> standing_machine_at(
      const std::vector<ReservedPart>& parts) const;
  const std::string& part_name(int part) const;

  std::optional<interpreter::HitPair> foreseen_hit(std::span<const double> q_from,
                                                   std::span<const double> q_to) const;

  SiteWorld& site_;
  int index_;
  std::vector<ForeseenRegion> foreseen_;             ///< when it was asked last
  bool keeps_out_ = false;                           ///< of these
  mutable collision::ClearanceBudget budget_;        ///< never changes an answer
  mutable FreeLine line_;                            ///< nor does this: what lies on it is free
  mutable bool line_is_within_chart_ = false;        ///< of the load, everywhere on it
  mutable std::shared_ptr<LineVolume> line_volume_;  // shared: of a type that is not known here
  mutable StepVolume step_volume_;                   ///< of the step that was tested last
  mutable std::shared_ptr<Legs> legs_;               // shared: of a type that is not known here
  mutable std::vector<bool> moved_bodies_;  ///< those that a step of it can move; found once
};

}  // namespace rubicon::site
