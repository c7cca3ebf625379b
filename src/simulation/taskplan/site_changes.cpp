#include "src/simulation/taskplan/site_changes.hpp"

#include <utility>

namespace rubicon::taskplan {

/// Remembers where the component is, to go back to.
void SiteChanges::keep(int component) {
  journal_.on_undo([&site = site_, component, before = site_.component_state(component)] {
    site.set_component_state(component, before);
  });
}

void SiteChanges::attach(int robot, int component) {
  keep(component);
  site_.attach(robot, component);
}

void SiteChanges::detach(int robot) {
  keep(site_.load(robot)->component);
  site_.detach(robot);
}

void SiteChanges::remove(int component) {
  keep(component);
  site_.remove(component);
}

void SiteChanges::open_soil(int component, const interpreter::MotionDigSpec& dig) {
  open(component, *dig.before, dig.after);
}

void SiteChanges::begin_dig(int component) {
  site_.set_being_dug(component, true);
  journal_.on_undo([&site = site_, component] { site.set_being_dug(component, false); });
}

void SiteChanges::open_heap(int component, const std::shared_ptr<const soil::Terrain>& ground) {
  open(component, *ground, ground);
}

void SiteChanges::open(int component, const soil::Terrain& surface,
                       std::shared_ptr<const soil::Terrain> bottom) {
  journal_.on_undo([&site = site_, component, before = site_.component_state(component)] {
    site.close_soil(component, before);
  });
  site_.open_soil(component, surface, std::move(bottom));
}

void SiteChanges::set_surface(int component, const std::map<int, soil::Millimetres>& heights) {
  std::map<int, soil::Millimetres> before;
  for (const auto& each : heights) {
    before.emplace(each.first,
                   site_.surface(component)->heights[static_cast<std::size_t>(each.first)]);
  }
  journal_.on_undo([&site = site_, component, before = std::move(before)] {
    site.set_surface(component, before);
  });
  site_.set_surface(component, heights);
}

void SiteChanges::hold_zone(int task, const std::string& task_name, const site::PeopleZone& zone,
                            int exempt_robot) {
  site_.hold_zone(task, task_name, zone, exempt_robot);
  journal_.on_undo([&site = site_, task] { site.release_zone(task); });
}

void SiteChanges::release_zone(int task, const std::string& task_name, const site::PeopleZone& zone,
                               int exempt_robot) {
  site_.release_zone(task);
  journal_.on_undo([&site = site_, task, task_name, zone, exempt_robot] {
    site.hold_zone(task, task_name, zone, exempt_robot);
  });
}

SiteChanges::Moment SiteChanges::moment(int robots) const {
  Moment moment;
  moment.mark = journal_.mark();
  for (int robot = 0; robot < robots; ++robot) {
    moment.machines.push_back(site_.machine_state(robot));
  }
  for (int moving = 0; moving < site_.movings(); ++moving) {
    moment.movings.push_back(site_.moving(moving).state());
  }
  moment.traffic = site_.traffic();
  return moment;
}

void SiteChanges::go_back(const Moment& moment, Ticks now) {
  journal_.undo_to(moment.mark);
  site_.set_time(now);
  for (std::size_t robot = 0; robot < moment.machines.size(); ++robot) {
    site_.set_machine_state(static_cast<int>(robot), moment.machines[robot]);
  }
  for (std::size_t moving = 0; moving < moment.movings.size(); ++moving) {
    site_.set_moving_state(static_cast<int>(moving), moment.movings[moving]);
  }
  site_.set_traffic(moment.traffic);
}

}  // namespace rubicon::taskplan
