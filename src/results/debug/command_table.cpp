#include "src/results/debug/command_words.hpp"

namespace rubicon::debug {

const std::vector<CommandWord>& command_words() {
  static const std::vector<CommandWord> words = {
      {"step", "s", "[N]", "to the next try or wait, N of them",
       "What the script did on the way (loops, labels, variables, crew work) is told before it.\n"
       "The beginning and the end of a task are stops too."},
      {"back", "k", "[N]", "to the try or wait before, N of them", ""},
      {"next", "n", "", "to the end of the innermost loop; outside loops, of the motion",
       "Stops at breakpoints on its way."},
      {"out", "o", "", "to the end of the loop around the innermost one",
       "Stops at breakpoints on its way."},
      {"record", "r", "[N]", "one record of the trace on, N of them; back if N is negative",
       "The finest step: every loop that begins or ends, every label and assignment."},
      {"continue", "c", "", "to the next breakpoint, or to the end", ""},
      {"reverse", "v", "", "back to the breakpoint before, or to the beginning", ""},
      {"run", "g", "to N", "to try number N of this task, forward or back", ""},
      {"until", "u", "T", "to the first moment at or after T of this task, forward or back",
       "T is seconds from the beginning of the plan, or h:mm:ss."},
      {"break", "b", "LINE | FILE:LINE | refused | hit | pair A [B] | task NAME",
       "stop there, forward and back",
       "LINE, FILE:LINE  what is tried or begins at that line; without FILE of the script one is "
       "in\n"
       "refused          every refused try\n"
       "hit              every try that something is in the way of\n"
       "pair A [B]       a try in which A meets B, in either order (A meets anything); names as a\n"
       "                 trace has them: robot.body, a component, site\n"
       "task NAME        where that task begins\n"
       "Names with blanks stand in \"...\"."},
      {"breaks", "", "", "lists the breakpoints", ""},
      {"delete", "d", "[N]", "takes away breakpoint N, or all", ""},
      {"print", "p", "[NAME]", "the value of a variable or parameter; all variables", ""},
      {"where", "w", "", "the loops that run, innermost first: how often round, what was made",
       "A round begins when what was tried first in the loop is tried again. How a loop ends is "
       "known\n"
       "from the recording."},
      {"config", "x", "", "the configuration before and after", ""},
      {"list", "l", "[LINE | FILE:LINE]", "the script around the place, or around a line",
       "-> is where one is, * a breakpoint."},
      {"tasks", "", "[TEXT]", "lists the tasks, or those with TEXT in their name", ""},
      {"task", "t", "NAME | NUMBER", "goes to the beginning of a task", ""},
      {"info", "i", "", "where one is: the task, the motion, the load, the time", ""},
      {"help", "h", "[COMMAND]", "this page, or the page of a command", ""},
      {"quit", "q", "", "ends; so does the end of the input", ""},
  };
  return words;
}

}  // namespace rubicon::debug
