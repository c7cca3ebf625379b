#include "src/taskplan/schedule.hpp"

namespace rubicon::taskplan {

const char* name_of(TaskResult result) {
  switch (result) {
    case TaskResult::done:
      return "done";
    case TaskResult::rejected:
      return "rejected";
    case TaskResult::not_reached:
      return "not reached";
  }
  return "";
}

}  // namespace rubicon::taskplan
