#include "src/results/verify/input/fault.hpp"

namespace rubicon::verify {

const char* name_of(FaultKind kind) {
  switch (kind) {
    case FaultKind::order:
      return "order";
    case FaultKind::clock:
      return "clock";
    case FaultKind::motion:
      return "motion";
    case FaultKind::contact:
      return "contact";
    case FaultKind::load:
      return "load";
    case FaultKind::resource:
      return "resource";
    case FaultKind::shift:
      return "shift";
    case FaultKind::link:
      return "link";
    case FaultKind::support:
      return "support";
    case FaultKind::joint:
      return "joint";
    case FaultKind::schedule:
      return "schedule";
    case FaultKind::report:
      return "report";
  }
  return "";
}

const char* name_of(ResultFile file) {
  switch (file) {
    case ResultFile::trace:
      return "trace.jsonl";
    case ResultFile::schedule_json:
      return "schedule.json";
    case ResultFile::schedule_csv:
      return "schedule.csv";
    case ResultFile::loads_csv:
      return "loads.csv";
    case ResultFile::report:
      return "report.html";
  }
  return "";
}

}  // namespace rubicon::verify
