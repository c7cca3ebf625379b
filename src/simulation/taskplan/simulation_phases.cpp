#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "src/simulation/site/load_chart.hpp"
#include "src/simulation/taskplan/simulation.hpp"

namespace rubicon::taskplan {

/// Why the component cannot be taken.
std::string Simulation::gone(int component) const {
  for (int robot = 0; robot < static_cast<int>(plan_.robots.size()); ++robot) {
    const auto& load = site_.load(robot);
    if (!load || load->component != component) continue;
    const int holder = allocator_->state(robot).holder;
    return fmt::format("{} hangs on {} just then{}", site_.component_name(component),
                       robot_spec(robot).name,
                       holder >= 0 ? ": put this after " + spec(holder).name : std::string());
  }
  return site_.component_name(component) + " is not on the site any more";
}

/// Goes on with the phases until one takes time, the task is over or cannot be done.
void Simulation::run_phases(ActiveTask& active) {
  while (active.phase < active.phases.size()) {
    active.places.clear();
    came_further(active);
    if (!begin_phase(active)) return;
    note_progress();
    ++active.phase;
  }
  finish_task(active);
}

/// Whether the phase is over at once. If not, it takes time, or the task is to be rejected.
bool Simulation::begin_phase(ActiveTask& active) {
  switch (active.now().kind) {
    case Phase::Kind::motion:
      return begin_motion(active);
    case Phase::Kind::weigh:
      return weigh(active);
    case Phase::Kind::work:
      return begin_work(active);
    case Phase::Kind::attach:
      return attach(active);
    case Phase::Kind::detach:
      detach(active);
      return true;
    case Phase::Kind::remove:
      return remove(active);
  }
  return true;
}

/// The event of the task has come.
void Simulation::go_on(ActiveTask& active) {
  bool over = false;
  switch (active.doing) {
    case Doing::moving:
      if (!active.waits_in_script) wake_those_who_wait_for(spec(active.task).robot, -1);
      over = move_on(active);
      break;
    case Doing::working:
      end_work(active);
      over = true;
      break;
    case Doing::waiting_for_shift:
      active.outcome.waits.shift += now_.now - active.since;
      pause(active, "shift", "");
      if (active.then == Doing::working) {
        over = do_work(active);
      } else if (active.machine) {
        active.machine->resume_at(now_.now);
        active.doing = Doing::moving;
        over = move_on(active);
      } else {
        over = begin_motion(active);
      }
      break;
    case Doing::waiting_for_machine:
      over = retry(active);
      break;
    case Doing::waiting_for_crew:
      break;
    case Doing::held:
      complete(active);
      return;
  }
  if (over) run_phases_after(active);
}

void Simulation::run_phases_after(ActiveTask& active) {
  note_progress();
  ++active.phase;
  run_phases(active);
}

/// The task stood still until now.
void Simulation::pause(ActiveTask& active, const char* why, const std::string& whom) {
  if (!trace_ || active.since == now_.now) return;
  own_trace(active);
  trace_->pause(why, whom, active.since, now_.now);
}

void Simulation::wait_for_shift(ActiveTask& active, const schedule::WorkCalendar& calendar,
                                Doing then) {
  active.doing = Doing::waiting_for_shift;
  active.then = then;
  active.since = now_.now;
  const Ticks next = calendar.next_working(now_.now);
  if (next >= schedule::kEndOfTime) {
    reject(active, "there is no shift any more for all that it needs");
  } else {
    wake_at(active, next);
  }
}

/// The queue with the hours of a work: those of all that the task holds and of the crew that does
/// the work.
int Simulation::work_queue(const ActiveTask& active) {
  const int held = queue_[index(active.task)];
  const int crew = active.now().work->crew;
  if (crew < 0) return held;
  std::vector<int> hours = allocator_->resources(held);
  const int resource = crew_resource(crew);
  if (std::find(hours.begin(), hours.end(), resource) != hours.end()) return held;
  hours.push_back(resource);
  return std::get<int>(allocator_->queue_for({resource}, std::move(hours)));
}

bool Simulation::begin_work(ActiveTask& active) {
  const interpreter::WorkSpec& work = *active.now().work;
  if (interpreter::ticks_from_seconds(work.duration) == 0) return true;
  const int queue = work_queue(active);
  if (queue == queue_[index(active.task)]) return do_work(active);
  active.doing = Doing::waiting_for_crew;
  active.since = now_.now;
  active.crew = crew_resource(work.crew);
  new_waits_.push_back(active.task);
  allocator_->ask(queue, active.task, spec(active.task).priority, now_.now);
  return false;
}

void Simulation::crew_came(ActiveTask& active, const ResourceAllocator::Grant& grant) {
  const Ticks free = std::clamp(grant.free, active.since, now_.now);
  active.outcome.waits.resource += free - active.since;
  active.outcome.waits.shift += now_.now - free;
  if (trace_) own_trace(active);
  if (trace_ && free > active.since) {
    trace_->pause("crew", allocator_->name(active.crew), active.since, free);
  }
  if (trace_ && now_.now > free) trace_->pause("shift", "", free, now_.now);
  if (free > active.since) {
    links_->add_mid_wait(active.task,
                         {free, schedule::Held::resource, active.crew, grant.task_before});
  }
  active.crew_since = now_.now;
  do_work(active);
}

/// Always takes time: false.
bool Simulation::do_work(ActiveTask& active) {
  const interpreter::WorkSpec& spec = *active.now().work;
  const schedule::WorkCalendar& calendar = allocator_->calendar(work_queue(active));
  if (!calendar.works_at(now_.now) && !links_->is_milestone(active.task)) {
    wait_for_shift(active, calendar, Doing::working);
    return false;
  }
  const Ticks duration = interpreter::ticks_from_seconds(spec.duration);
  const Ticks finish = calendar.finish(now_.now, duration);
  if (finish >= schedule::kEndOfTime) {
    reject(active, fmt::format("its work ({}) is not done within 126 years", active.now().what));
    return false;
  }
  active.doing = Doing::working;
  active.outcome.work_time += duration;
  active.outcome.waits.shift += finish - now_.now - duration;
  const std::vector<int>& held = allocator_->resources(queue_[index(active.task)]);
  for (std::size_t i = 0; i < held.size(); ++i) {
    if (spec.crew < 0 || held[i] == crew_resource(spec.crew)) active.worked[i] += duration;
  }
  if (trace_) {
    own_trace(active);
    trace_->work(active.now().what, spec.crew < 0 ? "" : plan_.crews[index(spec.crew)].name,
                 now_.now, finish, duration);
  }
  wake_at(active, finish);
  return false;
}

void Simulation::end_work(ActiveTask& active) {
  if (active.crew < 0) return;
  ResourceHold hold;
  hold.resource = active.crew;
  hold.held = allocator_->hours(active.crew).work_between(active.crew_since, now_.now);
  hold.busy = interpreter::ticks_from_seconds(active.now().work->duration);
  active.outcome.holds.push_back(hold);
  allocator_->release(active.crew, now_.now, true);
  active.crew = -1;
}

/// Whether the component is where the tool took hold of it; if somebody moved it meanwhile, the
/// task begins again from its motion there.
bool Simulation::still_there(ActiveTask& active) {
  const int component = active.now().component;
  if (!site_.stands(component)) {
    reject(active, gone(component), users_of(component));
    return false;
  }
  if (site_.X_WO(component).matrix() == active.X_WO.matrix()) return true;
  active.phase = 0;
  if (begin_motion(active)) run_phases_after(active);
  return false;
}

bool Simulation::weigh(ActiveTask& active) {
  if (!still_there(active)) return false;
  const int robot = spec(active.task).robot;
  const int component = active.now().component;
  const interpreter::RobotSpec& machine = robot_spec(robot);
  const double mass = plan_.components[index(component)].mass;
  const double radius = site::chart_radius(machine.X_WM, site_.tool_pose(robot).translation());
  const double allowed = site::capacity_at(machine.robot->model.capacity, radius);
  if (mass <= allowed) return true;
  reject(active,
         fmt::format("too heavy: {} has {:g} kg, the load chart of {} allows {:g} kg at {:g} m",
                     site_.component_name(component), mass, machine.name, allowed, radius));
  return false;
}

/// Remembers where the component is, to go back to.
void Simulation::keep_component(int component) {
  journal_.on_undo([this, component, before = site_.component_state(component)] {
    site_.set_component_state(component, before);
  });
}

bool Simulation::attach(ActiveTask& active) {
  if (!still_there(active)) return false;
  const int robot = spec(active.task).robot;
  const int component = active.now().component;
  // Hanging on a machine it would be part of that, where people keep machines out.
  if (const auto zone = site_.zone_around(component, robot)) {
    active.doing = Doing::waiting_for_machine;
    active.since = now_.now;
    active.blockers = {{-1, zone->zone_task, site_.component_name(component), zone->name}};
    active.stubborn = active.may_go_on = false;
    new_waits_.push_back(active.task);
    return false;
  }
  keep_component(component);
  site_.attach(robot, component);
  if (trace_) {
    own_trace(active);
    trace_->attach(site_.component_name(component), site_.load(robot)->X_TO, now_.now);
  }
  wake_those_who_wait_for(robot, -1);
  return true;
}

void Simulation::detach(ActiveTask& active) {
  const int robot = spec(active.task).robot;
  const int component = active.now().component;
  keep_component(component);
  site_.detach(robot);
  if (trace_) {
    own_trace(active);
    trace_->detach(site_.component_name(component), site_.X_WO(component), now_.now);
  }
  wake_those_who_wait_for(robot, -1);
}

bool Simulation::remove(ActiveTask& active) {
  const int component = active.now().component;
  if (!site_.stands(component)) {
    reject(active, gone(component), users_of(component));
    return false;
  }
  keep_component(component);
  site_.remove(component);
  if (trace_) {
    own_trace(active);
    trace_->remove(site_.component_name(component), now_.now);
  }
  return true;
}

}  // namespace rubicon::taskplan
