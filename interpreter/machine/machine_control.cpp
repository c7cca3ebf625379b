#include <fmt/format.h>

#include <algorithm>

#include "interpreter/machine/machine.hpp"
#include "interpreter/machine/run_time_error.hpp"

namespace rubicon::interpreter {

bool Machine::run_to_attempt(World& world, EventSink* events) {
  for (int quiet = 0; !end_; ++quiet) {
    if (quiet > kMaxQuietSteps) {
      throw RunTimeError{
          "the behaviour goes on without proposing any motion step; behaviours that use each other "
          "many times over do this",
          stack_.empty() ? Span{} : node_at(stack_.back().node).span};
    }
    if (pending_ >= 0) {
      if (run(pending_, world, events)) return true;
    } else {
      if (stack_.empty()) return false;
      give_back(world, events);
    }
  }
  return false;
}

/// Runs one node; true if it was an attempt.
bool Machine::run(std::int32_t index, World& world, EventSink* events) {
  const Node& node = node_at(index);
  switch (node.kind) {
    case Node::Kind::assignment:
    case Node::Kind::stop:
      pass(index, world, events);
      pending_ = -1;
      result_ = false;
      return false;
    case Node::Kind::move_to:
    case Node::Kind::move_dir:
    case Node::Kind::together:
    case Node::Kind::follow:
    case Node::Kind::line:
    case Node::Kind::wait:
      return attempt(index, world, events);
    case Node::Kind::loop:
      enter_loop(index, world, events);
      return false;
    case Node::Kind::each: {
      const std::int16_t* active = active_of(index);
      Frame frame;
      frame.kind = Frame::Kind::each;
      frame.node = index;
      frame.index = active ? *active : 0;
      stack_.push_back(frame);
      pending_ = child_at(node, frame.index);
      return false;
    }
    case Node::Kind::which:
      choose_module(index, world, events);
      return false;
    case Node::Kind::use:
      push_sequence(node.target);
      return false;
    case Node::Kind::sequence:
      push_sequence(index);
      return false;
  }
  return false;
}

/// Hands result_ to the frame on top of the stack.
void Machine::give_back(World& world, EventSink* events) {
  Frame& top = stack_.back();
  switch (top.kind) {
    case Frame::Kind::sequence:
      top.moved = top.moved || result_;
      next_of_sequence();
      return;
    case Frame::Kind::each: {
      const Node& node = node_at(top.node);
      const std::int32_t node_index = top.node;
      if (result_) {
        const std::int32_t active = top.index;
        stack_.pop_back();
        if (std::int16_t* slot = active_of(node_index)) *slot = static_cast<std::int16_t>(active);
      } else if (top.index + 1 < node.count) {
        ++top.index;
        pending_ = child_at(node, top.index);
      } else {
        stack_.pop_back();
        if (std::int16_t* slot = active_of(node_index)) *slot = 0;
      }
      return;
    }
    case Frame::Kind::loop:
      if (result_) {
        loop_succeeded(world, events);
      } else {
        loop_failed(world, events);
      }
      return;
  }
}

void Machine::push_sequence(std::int32_t node) {
  Frame frame;
  frame.kind = Frame::Kind::sequence;
  frame.node = node;
  stack_.push_back(frame);
  next_of_sequence();
}

/// Sets the next statement of the sequence on top pending, or ends the sequence.
void Machine::next_of_sequence() {
  Frame& top = stack_.back();
  const Node& node = node_at(top.node);
  if (top.index < node.count) {
    pending_ = child_at(node, top.index++);
    return;
  }
  result_ = top.moved;
  pending_ = -1;
  stack_.pop_back();
}

void Machine::enter_loop(std::int32_t index, World& world, EventSink* events) {
  const Node& loop = node_at(index);
  if (events) events->enter(loop.loop, loop.span);
  Frame frame;
  frame.kind = Frame::Kind::loop;
  frame.node = index;
  frame.actives = static_cast<std::int32_t>(actives_.size());
  // Leading assignments run once, at entry; a following cycle's `until` usually holds where it
  // starts.
  frame.index = forward(loop, 0, world, events);
  stack_.push_back(frame);
  actives_.resize(actives_.size() + static_cast<std::size_t>(program_->each_count), 0);
  if (frame.index < 0) {
    leave_loop(false, false, events);
  } else if (goal_or_until_holds(loop, loop.loop != LoopKind::cycle, world)) {
    leave_loop(true, false, events);
  } else {
    pending_ = child_at(loop, frame.index);
  }
}

void Machine::loop_succeeded(World& world, EventSink* events) {
  const Node& loop = node_at(stack_.back().node);
  stack_.back().moved = true;
  stack_.back().failures = 0;
  ++stack_.back().successes;
  if (goal_or_until_holds(loop, true, world)) {
    leave_loop(true, true, events);
    return;
  }
  Frame& top = stack_.back();
  top.index = backward(loop, top.index);
  pending_ = child_at(loop, top.index);
}

void Machine::loop_failed(World& world, EventSink* events) {
  const Node& loop = node_at(stack_.back().node);
  const bool has_goal = loop.goals_count > 0 || !loop.value.empty();
  const bool round = loop.loop == LoopKind::cycle && stack_.back().failures + 1 >= loop.commands;
  const std::int32_t next = round ? -1 : forward(loop, stack_.back().index + 1, world, events);
  if (next < 0) {
    leave_loop(false, stack_.back().moved && !has_goal, events);
    return;
  }
  Frame& top = stack_.back();
  top.index = next;
  // Only a cycle asks how many failed in a row; elsewhere the count must not make equal states
  // differ.
  if (loop.loop == LoopKind::cycle) ++top.failures;
  pending_ = child_at(loop, next);
}

void Machine::leave_loop(bool reached, bool result, EventSink* events) {
  const Frame& top = stack_.back();
  const Node& loop = node_at(top.node);
  if (events) events->exit(loop.loop, loop.span, reached, top.successes);
  actives_.resize(static_cast<std::size_t>(top.actives));
  stack_.pop_back();
  result_ = result;
  pending_ = -1;
}

void Machine::choose_module(std::int32_t index, const World& world, EventSink* events) {
  const Node& node = node_at(index);
  for (std::int32_t i = 0; i < node.count; ++i) {
    const ModuleLabels& module = program_->modules[static_cast<std::size_t>(node.target + i)];
    for (std::int32_t l = 0; l < module.count; ++l) {
      const Label& label = program_->labels[static_cast<std::size_t>(module.first + l)];
      const bool holds =
          label.kind == Label::Kind::otherwise ||
          (label.kind == Label::Kind::situation ? situation_on(label.situation, world)
                                                : number(label.condition, world) != 0);
      if (!holds) continue;
      if (events) {
        events->which(label.kind == Label::Kind::otherwise ? "default"
                      : label.kind == Label::Kind::when
                          ? "when"
                          : program_->situations[static_cast<std::size_t>(label.situation)],
                      node.span);
      }
      push_sequence(child_at(node, i));
      return;
    }
  }
  result_ = false;
  pending_ = -1;
}

/// What is no command: done on the way to the next one.
void Machine::pass(std::int32_t index, const World& world, EventSink* events) {
  const Node& node = node_at(index);
  if (node.kind == Node::Kind::assignment) {
    assign(index, world, events);
    return;
  }
  finish(MotionStatus::no_way,
         fmt::format("the script stops: unreachable, as far as it was seen, after {} steps",
                     accepted_),
         node.span);
}

void Machine::assign(std::int32_t index, const World& world, EventSink* events) {
  const Node& node = node_at(index);
  Variable& variable = variables_[static_cast<std::size_t>(node.target)];
  const Value value = stored(evaluate(node.value, world));
  variable.value = value;
  variable.set = true;
  if (events) {
    events->set(program_->variables[static_cast<std::size_t>(node.target)], value.number,
                node.span);
  }
}

/// First element at or after `from` that is a command, doing what is passed; -1
/// past the end.
std::int32_t Machine::forward(const Node& loop, std::int32_t from, const World& world,
                              EventSink* events) {
  const bool ring = loop.loop == LoopKind::cycle;
  for (std::int32_t passed = 0; passed < loop.count; ++passed) {
    std::int32_t i = from + passed;
    if (i >= loop.count) {
      if (!ring) return -1;
      i -= loop.count;
    }
    const std::int32_t element = child_at(loop, i);
    if (!is_passed(node_at(element).kind)) return i;
    pass(element, world, events);
    if (end_) return -1;
  }
  return -1;
}

/// Last element before `element` that is a command; chain: stays if there is none; cycle:
/// goes on from the end; first: the first command.
std::int32_t Machine::backward(const Node& loop, std::int32_t element) const {
  const auto is_command = [&](std::int32_t i) {
    return !is_passed(node_at(child_at(loop, i)).kind);
  };
  if (loop.loop == LoopKind::first) {
    std::int32_t i = 0;
    while (!is_command(i)) ++i;
    return i;
  }
  for (std::int32_t i = element - 1; i >= 0; --i) {
    if (is_command(i)) return i;
  }
  if (loop.loop == LoopKind::chain) return element;
  for (std::int32_t i = loop.count - 1; i > element; --i) {
    if (is_command(i)) return i;
  }
  return element;
}

bool Machine::goal_or_until_holds(const Node& loop, bool until_too, const World& world) {
  if (loop.goals_count > 0) {
    bool all = true;
    for (std::int32_t i = 0; i < loop.goals_count && all; ++i) {
      const Node& move =
          node_at(program_->children[static_cast<std::size_t>(loop.goals_first + i)]);
      all = move.kind == Node::Kind::follow ? leg().is_there(q_, target_.q)
            : move.kind == Node::Kind::line ? line().is_there(q_, target_.q, named_beside_frame())
                                            : at(move.target, number(move.value, world));
    }
    if (all) return true;
  }
  return until_too && !loop.value.empty() && number(loop.value, world) != 0;
}

bool Machine::situation_on(std::int32_t situation, const World& world) const {
  const std::string& name = program_->situations[static_cast<std::size_t>(situation)];
  if (target_.via && name == "via") return true;
  if (guide_ && name == "guided") return true;
  const GoalSpec::Work work = task_.goals[way_point_].work;
  if (work == GoalSpec::Work::working && name == "working") return true;
  if (work == GoalSpec::Work::travelling && name == "travelling") return true;
  return std::find(task_.situations.begin(), task_.situations.end(), name) !=
             task_.situations.end() ||
         world.situation(name, q_, target_.q);
}

/// The slot of an `each` in the nearest loop frame; null outside any loop.
std::int16_t* Machine::active_of(std::int32_t each_node) {
  for (auto frame = stack_.rbegin(); frame != stack_.rend(); ++frame) {
    if (frame->kind == Frame::Kind::loop) {
      return &actives_[static_cast<std::size_t>(frame->actives + node_at(each_node).each_index)];
    }
  }
  return nullptr;
}

}  // namespace rubicon::interpreter
