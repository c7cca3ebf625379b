#pragma once

#include <memory>
#include <string>
#include <utility>

#include "src/simulation/taskplan/resource_allocator.hpp"
#include "src/simulation/taskplan/wait_graph.hpp"

namespace rubicon::taskplan {

struct ActiveTask;
struct Phase;
class Stage;

/// Something happened that others may wait for: a machine moved or stands still for good, people
/// left a zone, something with a timetable stopped or goes on, a truck came or is full.
struct SiteEvent {
  int robot = -1;        ///< the machine
  int zone_task = -1;    ///< the task whose people left
  int moving = -1;       ///< the thing with a timetable
  bool haulage = false;  ///< those who dig and haul for each other came further
};

/// How an activity stands when it has begun or resumed.
enum class Step {
  over,     ///< the next phase begins
  pending,  ///< its next event is set, it waits for others, or its task is rejected
  restart   ///< what it found is gone: the task begins again with its first phase
};

/// What a task does in one of its phases. It belongs to one task; all that is shared comes with the
/// `Stage`. A value in disguise: `snapshot` is a moment to go back to.
class Activity {
 public:
  virtual ~Activity() = default;

  virtual Step begin(ActiveTask& task, Stage& stage) = 0;
  /// Its event has come.
  virtual Step resume(ActiveTask& task, Stage& stage) = 0;
  /// It is given what it asked the allocator for.
  virtual Step granted(ActiveTask&, Stage&, const ResourceAllocator::Grant&) {
    return Step::pending;
  }

  /// What it waits for that only other tasks can bring about.
  virtual WaitSet waits(const ActiveTask&, const Stage&) const { return {}; }
  /// What it waits for, in words: "left (go_right) waits for right: ...", without what is said of
  /// idle machines.
  virtual std::string text_of(const ActiveTask&, const Stage&, const WaitTarget&) const {
    return {};
  }
  /// Why it never goes on, where nobody will bring it about.
  virtual std::string standstill_reason(const ActiveTask&, const Stage&) const { return {}; }
  /// Whether it is to resume since this happened.
  virtual bool wakes_at(const ActiveTask&, const Stage&, const SiteEvent&) const { return false; }
  /// The machines it waits for to move, in the order in which it met them.
  virtual std::vector<int> robots_in_the_way(const Stage&) const { return {}; }
  /// Where what it waits for never comes: whether what it has reached is enough. If so it is over.
  virtual bool settle(ActiveTask&, Stage&) { return false; }

  virtual std::unique_ptr<Activity> snapshot() const = 0;

 protected:
  Activity() = default;
  Activity(const Activity&) = default;
  Activity& operator=(const Activity&) = default;
};

/// A pointer that copies what it points to.
template <typename T>
class Snapshot {
 public:
  Snapshot() = default;
  explicit Snapshot(std::unique_ptr<T> value) : value_(std::move(value)) {}
  Snapshot(const Snapshot& other) : value_(other.value_ ? other.value_->snapshot() : nullptr) {}
  Snapshot(Snapshot&&) noexcept = default;
  Snapshot& operator=(Snapshot other) noexcept {
    value_ = std::move(other.value_);
    return *this;
  }
  T* operator->() const { return value_.get(); }
  T& operator*() const { return *value_; }
  explicit operator bool() const { return value_ != nullptr; }

 private:
  std::unique_ptr<T> value_;
};

}  // namespace rubicon::taskplan
