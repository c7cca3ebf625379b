#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "src/results/debug/breakpoint.hpp"
#include "src/results/debug/paint.hpp"
#include "src/results/debug/recording.hpp"

namespace rubicon::debug {

/// A walk through a recording, forward and back, as a user asks for it in words.
///
/// A stop is the beginning of a run, each try and wait, and the end of the run. Without a task the
/// runs of all tasks follow one another in the order in which they begin.
class Session {
 public:
  /// `task` is empty for all tasks; else `why_not` must have been empty for it.
  Session(Recording recording, const std::string& task, Paint paint);

  /// Why there is nothing to step through; empty if there is something.
  static std::string why_not(const Recording& recording, const std::string& task);

  /// What is shown before the first command.
  std::string opening() const;
  /// Does one command; an empty one does the last step again. What is to be shown.
  std::string execute(std::string_view command);
  /// Whether `quit` was asked for.
  bool ended() const { return ended_; }

  const Recording& recording() const { return recording_; }
  /// Where it stands.
  const TaskRun& run() const { return recording_.runs[scope_[at_.run]]; }
  const TaskState& state() const { return state_; }

 private:
  using Words = std::vector<std::string>;
  /// A place in the scope.
  struct Cursor {
    std::size_t run = 0;       ///< in scope_
    std::size_t position = 0;  ///< so many events are behind it
    bool operator==(const Cursor&) const = default;
  };

  void set_scope(const std::string& task);
  std::string dispatch(const std::string& name, const Words& words);

  // session_steps.cpp
  std::string step(const Words& words);
  std::string back(const Words& words);
  std::string record(const Words& words);
  std::string to_end_of_loop(std::size_t loops_out);
  std::string go_on();
  std::string go_back();
  std::string run_to(const Words& words);
  std::string until(const Words& words);
  std::string go_to_task(const Words& words);
  bool next_stop(Cursor& cursor) const;
  bool stop_before(Cursor& cursor) const;
  bool next_record(Cursor& cursor) const;
  bool record_before(Cursor& cursor) const;
  /// Runs on to a breakpoint, at most to `last`; the breakpoint.
  const Breakpoint* run_on(Cursor& cursor, const Cursor& last) const;
  const Breakpoint* run_back(Cursor& cursor) const;
  const Breakpoint* stopped_by(const Cursor& cursor) const;
  Cursor end_of_scope() const;
  std::size_t end_of_motion() const;
  std::string passed(const Cursor& from, const Cursor& to) const;
  std::string go(const Cursor& to, const Breakpoint* why = nullptr);
  const TaskRun& run_at(const Cursor& cursor) const { return recording_.runs[scope_[cursor.run]]; }

  // session_breaks.cpp
  std::string add_break(const Words& words);
  std::string list_breaks() const;
  std::string delete_break(const Words& words);

  // session_show.cpp
  std::string print(const Words& words) const;
  std::string where() const;
  std::string config() const;
  std::string list(const Words& words);
  std::string tasks(const Words& words) const;
  std::string info() const;
  std::string help(const Words& words) const;
  std::string loop_text(const LoopState& loop) const;
  /// The script that one is in: of this record, or of the last before it that names one.
  std::optional<Place> here() const;

  Recording recording_;
  Paint paint_;
  std::vector<std::size_t> scope_;  ///< the runs that are stepped through, in Recording::runs
  std::string only_;                ///< the task that they are of, "" for all
  Cursor at_;
  TaskState state_;
  std::vector<Breakpoint> breakpoints_;
  int last_breakpoint_ = 0;
  std::string again_ = "step";  ///< what an empty line does
  bool ended_ = false;
};

}  // namespace rubicon::debug
