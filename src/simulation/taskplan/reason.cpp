#include "src/simulation/taskplan/reason.hpp"

#include <fmt/format.h>

namespace rubicon::taskplan {

std::string reason_of(const interpreter::MotionEnd& end, const RecordedHit* hit,
                      const interpreter::SourceMap& sources) {
  if (end.status == interpreter::MotionStatus::done) {
    if (!hit) return end.message;
    std::string line;
    if (hit->span.file != interpreter::kNoFile) {
      line = fmt::format(", line {}", sources.position(hit->span).line);
    }
    return fmt::format("blocked by {} at step {} ({}{}): {} meets {}; {}", hit->pair.met, hit->n,
                       fmt::join(hit->parameters, ", "), line, hit->pair.moved, hit->pair.met,
                       end.message);
  }
  if (end.span.file == interpreter::kNoFile) return end.message;
  return fmt::format("{} ({}:{})", end.message, sources.file(end.span.file).path,
                     sources.position(end.span).line);
}

std::string task_reason(const MotionOutcome& motion, const RecordedHit* hit,
                        const std::string& component, const interpreter::SourceMap& sources) {
  const std::string reason = reason_of(motion.end, hit, sources);
  switch (motion.purpose) {
    case MotionPurpose::grip:
      return fmt::format("{}, on the way to {}", reason, component);
    case MotionPurpose::carry:
      return fmt::format("{}, while carrying {}", reason, component);
    case MotionPurpose::place:
      return fmt::format("{}, while placing {}", reason, component);
    case MotionPurpose::go:
    case MotionPurpose::dig:
    case MotionPurpose::haul:
      break;
  }
  return reason;
}

}  // namespace rubicon::taskplan
