#pragma once

#include <cstdint>

#include "src/results/debug/string_table.hpp"
#include "src/simulation/trace/record_kind.hpp"

namespace rubicon::debug {

using EventKind = trace::RecordKind;

/// One record of a trace (docs/trace.md), 40 bytes: a trace has millions. What `text`, `other`,
/// `value`, `n` and `row` are depends on the kind.
struct Event {
  double t = 0;      ///< time after it, s
  double value = 0;  ///< set: the value; work, pause: `from`; exit: successes; end: accepted;
                     ///< cold_joint: the age, s
  std::uint32_t place = kNone;  ///< in Recording::places
  std::uint32_t text = kNone;  ///< attempt: in Recording::commands; set: the variable; enter, exit:
                               ///< the kind; which: the label; work, pause: what; attach, detach,
                               ///< remove: the component; end: the status; task_start: because;
                               ///< task_end: the result
  std::uint32_t other = kNone;  ///< attempt: in Recording::refusals, kNone if accepted; work: the
                                ///< crew; pause: for whom; end: the message; task_end: the reason
  std::uint32_t row = kNone;    ///< the configuration after it; enter: the event that ends the loop
  std::int32_t n = 0;           ///< attempt, wait: its number; goal: k; end: tries
  EventKind kind = EventKind::task_start;
  bool ok = false;  ///< attempt: accepted; exit, end: reached
};

}  // namespace rubicon::debug
