#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "interpreter/check/plan_model.hpp"
#include "src/simulation/schedule/journal.hpp"
#include "src/simulation/schedule/ticks.hpp"
#include "src/simulation/site/site_world.hpp"

namespace rubicon::taskplan {

/// Where the people of a task work.
inline site::PeopleZone zone_of(const interpreter::TaskSpec& task) {
  return {task.zones, task.zones_overhead};
}

using schedule::Journal;
using schedule::Ticks;

/// Changes the site so that a run can go back to an earlier moment.
class SiteChanges {
 public:
  /// `site` must outlive it.
  explicit SiteChanges(site::SiteWorld& site) : site_(site) {}

  void attach(int robot, int component);
  /// Puts down what hangs on the robot.
  void detach(int robot);
  void remove(int component);
  /// The component is soil from now on, which is dug bit by bit.
  void open_soil(int component, const interpreter::MotionDigSpec& dig);
  /// Crews dig the component, which is soil, from now on: no truck drives over that.
  void begin_dig(int component);
  /// The component is soil that is tipped on this ground.
  void open_heap(int component, const std::shared_ptr<const soil::Terrain>& ground);
  void set_surface(int component, const std::map<int, soil::Millimetres>& heights);
  /// People of `task` work in the shapes from now on.
  void hold_zone(int task, const std::string& task_name, const site::PeopleZone& zone,
                 int exempt_robot);
  void release_zone(int task, const std::string& task_name, const site::PeopleZone& zone,
                    int exempt_robot);

  /// What is copied to go back to: where the machines are and what keeps a timetable, and how many
  /// changes there were.
  struct Moment {
    Journal::Mark mark = 0;
    std::vector<site::MachineState> machines;
    std::vector<site::MovingState> movings;
    std::vector<traffic::Traffic> traffic;
  };
  Moment moment(int robots) const;
  void go_back(const Moment& moment, Ticks now);
  Journal::Mark mark() const { return journal_.mark(); }
  void forget_before(Journal::Mark mark) { journal_.forget_before(mark); }

 private:
  void keep(int component);
  void open(int component, const soil::Terrain& surface,
            std::shared_ptr<const soil::Terrain> bottom);

  site::SiteWorld& site_;
  Journal journal_;
};

}  // namespace rubicon::taskplan
