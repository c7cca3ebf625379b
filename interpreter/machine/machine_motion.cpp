#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "interpreter/machine/machine.hpp"
#include "interpreter/machine/run_time_error.hpp"
#include "src/motion/robot/turns.hpp"

namespace rubicon::interpreter {

/// Makes one attempt of a command, or comes to the stop that it needs before it; false if a
/// livelock, circling or the budget stopped it first.
bool Machine::attempt(std::int32_t index, World& world, EventSink* events) {
  const bool planned = std::exchange(stopped_, false);
  if (!planned && !may_attempt(index, world)) return false;
  const Node& node = node_at(index);
  const bool waits = node.kind == Node::Kind::wait;
  Refusal refusal = Refusal::none;
  std::int32_t limit = -1;
  Ticks duration = 0;
  const int n = task_.first_n + tries_++;
  if (!waits) {
    if (!planned) refusal = plan(node, world, limit);
    if (refusal == Refusal::none) {
      robot::apply_rules(*model_, task_.mounting, q_, steps_, q_next_);
      limit = first_out_of_range(q_next_);
      if (limit < 0) limit = first_locked(q_next_);
      if (limit >= 0) refusal = Refusal::limit;
      duration = plan_run(world.loaded());
    }
  }
  if (refusal == Refusal::none && (waits || must_stop(world, duration)) && stop(events)) {
    --tries_;
    stopped_ = true;
    pending_ = index;
    return true;
  }
  pending_ = -1;
  if (waits) {
    time_ += ticks_from_seconds(model_->time_step);
    ++accepted_;
    result_ = true;
    if (events) events->wait(n, time_, node.span);
    return true;
  }

  std::optional<HitPair> hit;
  if (refusal == Refusal::none) {
    hit = world.propose({q_, q_next_, time_, duration, goal_.q, target_.q});
    if (hit) refusal = Refusal::hit;
  }
  switch (refusal) {
    case Refusal::none:
      note_aside();
      if (way_.begun()) way_.add(q_, q_next_, tool_place(q_next_), target_.p_WG);
      std::copy(q_next_.begin(), q_next_.end(), q_.begin());
      robot::normalise(*model_, q_);
      time_ += duration;
      run_.swap(run_next_);
      ++accepted_;
      break;
    case Refusal::at_goal:
      ++rejected_.at_goal;
      break;
    case Refusal::no_direction:
      ++rejected_.no_direction;
      break;
    case Refusal::limit:
      ++rejected_.limit;
      break;
    case Refusal::hit:
      ++rejected_.hit;
      last_hit_ = hit;
      break;
  }
  result_ = refusal == Refusal::none;
  if (events) {
    const bool several = node.kind == Node::Kind::together;
    const bool follows = node.kind == Node::Kind::follow;
    const bool lines = node.kind == Node::Kind::line;
    Attempt record;
    record.n = n;
    record.command = several                            ? "together"
                     : follows                          ? "follow"
                     : lines                            ? "line"
                     : node.kind == Node::Kind::move_to ? "move_to"
                                                        : "move_dir";
    record.parameters = program_->parameter_names[static_cast<std::size_t>(index)];
    record.span = node.span;
    record.accepted = result_;
    record.refusal = refusal;
    if (refusal == Refusal::limit) record.limit = parameter(limit).display_name;
    record.hit = hit ? &*hit : nullptr;
    if (hit) {
      refused_steps_.clear();
      if (follows || lines) {
        for (const int i : follows ? leg().stepped() : line().stepped()) {
          refused_steps_.push_back(steps_[static_cast<std::size_t>(i)]);
        }
      }
      for (std::int32_t i = 0; !follows && !lines && i < (several ? node.count : 1); ++i) {
        const Node& part = several ? node_at(child_at(node, i)) : node;
        refused_steps_.push_back(steps_[static_cast<std::size_t>(part.target)]);
      }
      record.steps = refused_steps_;
    }
    record.time = time_;
    record.q = q_;
    events->attempt(record);
  }
  return true;
}

/// Plans the steps of a command's parts; what is refused of each. None: at least one part moves.
Refusal Machine::plan(const Node& node, const World& world, std::int32_t& limit) {
  if (node.kind == Node::Kind::follow) {
    return leg().next_step(q_, target_.q, steps_) ? Refusal::none : Refusal::at_goal;
  }
  if (node.kind == Node::Kind::line) return plan_line(limit);
  std::fill(steps_.begin(), steps_.end(), 0.0);
  const bool several = node.kind == Node::Kind::together;
  const std::int32_t parts = several ? node.count : 1;
  Refusal first = Refusal::none;
  bool something = false;
  for (std::int32_t i = 0; i < parts; ++i) {
    std::int32_t part_limit = -1;
    const Refusal refusal =
        plan_part(several ? node_at(child_at(node, i)) : node, world, steps_, part_limit);
    if (i == 0) {
      first = refusal;
      limit = part_limit;
    }
    something = something || refusal == Refusal::none;
  }
  return something ? Refusal::none : first;
}

const robot::ToolLine& Machine::line() {
  if (!line_) {
    line_ = std::make_shared<const robot::ToolLine>(
        *model_, task_.mounting, task_.clauses.deviation.value_or(model_->deviation),
        task_.clauses);
  }
  return *line_;
}

/// Parameters whose values the goal names beside its frame.
std::vector<int> Machine::named_beside_frame() const {
  std::vector<int> named;
  if (!goal_.X_WG) return named;
  for (const auto& [index, value] : task_.goals[way_point_].values) named.push_back(index);
  return named;
}

Refusal Machine::plan_line(std::int32_t& limit) {
  const robot::ToolLine::Step step = line().next_step(q_, target_.q, named_beside_frame(), steps_);
  switch (step.kind) {
    case robot::ToolLine::Step::Kind::made:
      return Refusal::none;
    case robot::ToolLine::Step::Kind::there:
      return Refusal::at_goal;
    case robot::ToolLine::Step::Kind::limit:
      limit = step.parameter;
      return Refusal::limit;
    case robot::ToolLine::Step::Kind::none:
      break;
  }
  return Refusal::no_direction;
}

/// The steps that decide how long the planned steps take: all that are as long as counts as there.
/// What is shorter (a heading that is turned by its rounding) is over long before the others; where
/// all are, the longest decides.
void Machine::find_steps_of_run() {
  run_steps_.assign(steps_.size(), 0.0);
  std::size_t longest = 0;
  bool any = false;
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    const double length = std::fabs(steps_[i]);
    if (length > std::fabs(steps_[longest])) longest = i;
    if (!(length > kEpsilon * model_->parameters[i].step)) continue;
    run_steps_[i] = steps_[i];
    any = true;
  }
  if (!any && !steps_.empty()) run_steps_[longest] = steps_[longest];
}

/// How long the planned steps take together: as long as the slowest. `run_next_` is then the run
/// that they begin, or go on with.
Ticks Machine::plan_run(bool loaded) {
  find_steps_of_run();
  run_next_.clear();
  bool goes_on = true;
  std::size_t moved = 0;
  for (std::size_t i = 0; i < run_steps_.size(); ++i) {
    const double ds = run_steps_[i];
    if (ds == 0) continue;
    const robot::Parameter& p = model_->parameters[i];
    run_next_.emplace_back(static_cast<std::int32_t>(i), ds > 0, loaded ? p.loaded_speed : p.speed,
                           p.acceleration);
    goes_on =
        goes_on && moved < run_.size() && run_[moved].is_of(static_cast<std::int32_t>(i), ds > 0);
    ++moved;
  }
  goes_on_ = goes_on && moved == run_.size();
  if (goes_on_) run_next_ = run_;
  Ticks duration = 0;
  bool accelerates = false;
  std::size_t next = 0;
  for (const double ds : run_steps_) {
    if (ds == 0) continue;
    duration = std::max(duration, run_next_[next].advance(std::fabs(ds)));
    accelerates = accelerates || run_next_[next].accelerates();
    ++next;
  }
  if (!accelerates) run_next_.clear();
  const double pace = task_.goals[way_point_].pace;
  if (pace <= 0) return duration;
  // The tool works no faster than what it lays comes.
  const math::Vec3 from = robot::tool_pose(*model_, task_.mounting, q_).translation();
  const math::Vec3 to = robot::tool_pose(*model_, task_.mounting, q_next_).translation();
  return std::max(duration, ticks_from_seconds((to - from).norm() / pace));
}

/// Whether the planned step begins another run than the one that goes on, and would be accepted: a
/// refused try ends no run.
bool Machine::must_stop(const World& world, Ticks duration) const {
  if (run_.empty() || goes_on_) return false;
  return world.would_accept({q_, q_next_, time_, duration, goal_.q});
}

/// Forms the key of LANGUAGE 9.2 and 9.3 before an attempt; false ends the motion.
bool Machine::may_attempt(std::int32_t index, const World& world) {
  const std::uint64_t version = world.version();
  if (version != world_version_) {
    world_version_ = version;
    seen_.clear();
    visited_.clear();
  }
  const Node& node = node_at(index);
  std::uint64_t situations = 0;
  for (std::size_t i = 0; i < program_->situations.size(); ++i) {
    situations = situations * 2 + (situation_on(static_cast<std::int32_t>(i), world) ? 1 : 0);
    if (i % 63 == 62) situations *= 0x9e3779b97f4a7c15ull;
  }
  StateHasher exact;
  StateHasher coarse;
  hash_stack(exact, index);
  exact.add(situations);
  coarse.add(static_cast<std::uint64_t>(index));
  for (const Frame& frame : stack_) {
    if (frame.kind == Frame::Kind::loop) coarse.add(static_cast<std::uint64_t>(frame.index));
  }
  if (guide_) {
    // A way may lead twice over the same place.
    exact.add(static_cast<std::uint64_t>(guide_point_));
    coarse.add(static_cast<std::uint64_t>(guide_point_));
    for (const double value : target_.q) exact.add(value), coarse.add(value);
  }
  for (std::size_t i = 0; i < q_.size(); ++i) {
    const double quantum = model_->parameters[i].quantum;
    exact.add(std::floor(q_[i] / (kEpsilon * quantum) + 0.5));
    coarse.add(std::floor(q_[i] / (0.5 * quantum) + 0.5));
  }
  hash_variables(exact, coarse);
  if (program_->uses_time) exact.add(static_cast<std::uint64_t>(time_));

  bool inserted = false;
  const std::uint32_t before =
      seen_.find_or_insert(exact.finish(), static_cast<std::uint32_t>(accepted_), inserted);
  if (!inserted) {
    const int period = accepted_ - static_cast<int>(before);
    finish(
        MotionStatus::livelock,
        fmt::format("livelock: after {} steps the robot is back in the state it had after {} steps "
                    "(period {}) at {}",
                    accepted_, before, period, describe_next(index)),
        node.span);
    end_->period = period;
    return false;
  }
  if (node.kind != Node::Kind::wait) {
    std::uint32_t& visits = visited_.find_or_insert(coarse.finish(), 0, inserted);
    if (++visits > kMaxVisits) {
      finish(MotionStatus::circling,
             fmt::format(
                 "circling: after {} steps the robot comes for the {}st time to the same place, "
                 "within half a step, at {}",
                 accepted_, visits, describe_next(index)),
             node.span);
      return false;
    }
  }
  if (tries_ >= task_.budget) {
    finish(
        MotionStatus::budget,
        fmt::format("budget: {:g} attempts are used up before {}",
                    task_.full_budget > 0 ? task_.full_budget : task_.budget, describe_next(index)),
        node.span);
    return false;
  }
  return true;
}

/// The command about to be tried, and who was last in the way.
std::string Machine::describe_next(std::int32_t index) const {
  std::string text = program_->command_texts[static_cast<std::size_t>(index)];
  if (last_hit_) text += fmt::format("; last hit: {} meets {}", last_hit_->moved, last_hit_->met);
  return text;
}

/// Of a place on the way counts where it is and what was gone since, not how many steps lie before
/// it: else no state would ever come again.
void Machine::hash_variables(StateHasher& exact, StateHasher& coarse) const {
  for (const Variable& variable : variables_) {
    exact.add(static_cast<std::uint64_t>(variable.set));
    coarse.add(static_cast<std::uint64_t>(variable.set));
    if (variable.set && variable.value.is_place) {
      const int place = static_cast<int>(variable.value.number);
      exact.add(way_.hash_since(*model_, place));
      coarse.add(way_.hash_of(*model_, place));
      continue;
    }
    const double value = variable.set ? variable.value.number : 0;
    exact.add(value);
    coarse.add(value);
  }
}

void Machine::hash_stack(StateHasher& hasher, std::int32_t command) const {
  hasher.add(static_cast<std::uint64_t>(command));
  for (const Frame& frame : stack_) {
    hasher.add(static_cast<std::uint64_t>(frame.node) << 32 |
               static_cast<std::uint32_t>(frame.index));
    if (frame.kind == Frame::Kind::each) continue;
    hasher.add(static_cast<std::uint64_t>(frame.failures) << 1 | (frame.moved ? 1u : 0u));
  }
  for (const std::int16_t active : actives_) hasher.add(static_cast<std::uint64_t>(active));
}

Hash128 Machine::state_hash(const World& world) const {
  StateHasher hasher;
  hash_stack(hasher, pending_);
  hasher.add(static_cast<std::uint64_t>(result_));
  for (const double q : q_) hasher.add(q);
  for (const Variable& variable : variables_) {
    hasher.add(static_cast<std::uint64_t>(variable.set));
    hasher.add(variable.value.number);
    hasher.add(static_cast<std::uint64_t>(variable.value.direction_of));
    hasher.add(static_cast<std::uint64_t>(variable.value.negated));
    if (variable.set && variable.value.is_place) {
      hasher.add(way_.hash_since(*model_, static_cast<int>(variable.value.number)));
    }
  }
  hasher.add(static_cast<std::uint64_t>(time_));
  for (const MotionRun& part : run_) hasher.add(static_cast<std::uint64_t>(part.rest()));
  hasher.add(static_cast<std::uint64_t>(stopped_));
  hasher.add(static_cast<std::uint64_t>(way_point_));
  if (guide_) {
    for (const double value : target_.q) hasher.add(value);
  }
  hasher.add(static_cast<std::uint64_t>(tries_));
  hasher.add(world.version());
  return hasher.finish();
}

Refusal Machine::plan_part(const Node& part, const World& world, std::vector<double>& steps,
                           std::int32_t& limit) {
  const double value = number(part.value, world);
  return part.kind == Node::Kind::move_to ? plan_move_to(part.target, value, steps, limit)
                                          : plan_direction(part.target, value, steps, limit);
}

Refusal Machine::plan_move_to(int index, double value, std::vector<double>& steps,
                              std::int32_t& limit) const {
  if (at(index, value)) return Refusal::at_goal;
  const double off = delta(index, value);
  const Refusal refusal = plan_direction(index, off, steps, limit);
  if (refusal != Refusal::none) return refusal;
  // The last step is shortened to land on the value.
  double& ds = steps[static_cast<std::size_t>(index)];
  if (std::fabs(off) < std::fabs(ds)) ds = off;
  return Refusal::none;
}

/// Only the sign of a direction counts. Steps are shortened at the range limit.
Refusal Machine::plan_direction(int index, double direction, std::vector<double>& steps,
                                std::int32_t& limit) const {
  if (direction == 0) return Refusal::no_direction;
  const robot::Parameter& p = parameter(index);
  const double left = room(index, direction > 0);
  if (left <= kEpsilon * p.quantum) {
    limit = index;
    return Refusal::limit;
  }
  const double length = std::min(p.step, left);
  steps[static_cast<std::size_t>(index)] = direction > 0 ? length : -length;
  return Refusal::none;
}

/// How far the parameter may still go; without bound for local and cyclic ones (5.2), whose rules
/// decide.
double Machine::room(int index, bool upwards) const {
  const robot::Parameter& p = parameter(index);
  if (!p.direct || p.cyclic) return std::numeric_limits<double>::infinity();
  const double q = q_[static_cast<std::size_t>(index)];
  return upwards ? p.upper - q : q - p.lower;
}

int Machine::first_out_of_range(std::span<const double> q) const {
  for (std::size_t i = 0; i < q.size(); ++i) {
    const robot::Parameter& p = model_->parameters[i];
    if (p.cyclic) continue;
    const double slack = kEpsilon * p.quantum;
    if (q[i] < p.lower - slack || q[i] > p.upper + slack) return static_cast<int>(i);
  }
  return -1;
}

/// The first locked parameter that another value is meant for.
int Machine::first_locked(std::span<const double> q) const {
  for (const int i : task_.clauses.locked) {
    const auto index = static_cast<std::size_t>(i);
    if (q[index] != q_[index]) return i;
  }
  return -1;
}

/// Whether move_dir(p, direction) would be accepted now.
bool Machine::would_accept(int index, double direction, const World& world) {
  std::fill(asked_steps_.begin(), asked_steps_.end(), 0.0);
  std::int32_t limit = -1;
  if (plan_direction(index, direction, asked_steps_, limit) != Refusal::none) return false;
  robot::apply_rules(*model_, task_.mounting, q_, asked_steps_, asked_q_);
  if (first_out_of_range(asked_q_) >= 0 || first_locked(asked_q_) >= 0) return false;
  return world.would_accept({q_, asked_q_, time_, 0});
}

}  // namespace rubicon::interpreter
