#include "interpreter/program/events.hpp"

namespace rubicon::interpreter {

const char* name_of(LoopKind kind) {
  switch (kind) {
    case LoopKind::chain:
      return "chain";
    case LoopKind::cycle:
      return "cycle";
    case LoopKind::first:
      return "first";
  }
  return "";
}

std::string reason_text(const Attempt& attempt) {
  switch (attempt.refusal) {
    case Refusal::none:
      return "";
    case Refusal::at_goal:
      return "at goal";
    case Refusal::no_direction:
      return "no direction";
    case Refusal::limit:
      return "limit " + attempt.limit;
    case Refusal::hit:
      return "hit";
  }
  return "";
}

}  // namespace rubicon::interpreter
