#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "src/simulation/schedule/link.hpp"
#include "src/simulation/schedule/ticks.hpp"
#include "src/simulation/schedule/work_calendar.hpp"

namespace rubicon::schedule {

/// A task whose work is known before it begins: crew work.
struct NetworkTask {
  std::string name;
  Ticks work = 0;              ///< 0: a milestone, which holds nobody and needs no shift
  double priority = 0;         ///< the higher goes first
  std::vector<int> resources;  ///< all are held from its start to its finish
  std::vector<Link> after;
  std::vector<int> units = {};  ///< of each of `resources`; empty: all of each
  Ticks not_before = 0;         ///< it starts then or later, whatever links allow
};

/// A crew or a machine; it does one task at a time, or as many as share its units.
struct NetworkResource {
  std::string name;
  int calendar = -1;  ///< index into the calendars; -1: day and night
  int size = 1;       ///< units: people of a crew
};

/// Tasks in file order, who does them and when these work.
struct Network {
  std::vector<WorkCalendar> calendars;
  std::vector<NetworkResource> resources;
  std::vector<NetworkTask> tasks;
};

/// What a task waited for last before it started, shifts aside, or on its way. `date`: it starts
/// not before one; `machine`: for one in its way; `asked`: a machine moves out of the way of
/// another task; `timetable`: for something that keeps one; `shift`: for the next one.
enum class Held { plan_start, date, link, resource, machine, asked, timetable, shift };

/// Why a machine went out of the way when it did: it was asked, or came free then. It may do so
/// several times in a plan.
struct Parking {
  Held held = Held::asked;  ///< asked or resource
  int resource = -1;        ///< itself
  int task_before = -1;     ///< who asked, or who had it
  bool midway = true;       ///< at a moment before that task's finish
  bool repaired = false;    ///< it was repaired after that task
  Ticks wanted = 0;
};

/// Why a task waited for a shift: it would have waited in the one before until another task gave a
/// resource back, and would not have been done in time.
struct MissedShift {
  Ticks until = 0;  ///< the other gave it back
  int resource = -1;
  int task_before = -1;  ///< who had it
  Ticks gain = 0;        ///< given back so much sooner, it would have been done in time
};

/// A wait of a task after its start: for a resource that another task had, until a machine that
/// another task moved was out of the way, for something with a timetable, or for the next shift.
struct MidWait {
  Ticks until = 0;
  Held held = Held::resource;              ///< resource, machine, timetable or shift
  int resource = -1;                       ///< what was waited for
  int task_before = -1;                    ///< who had it
  std::optional<Parking> parking = {};     ///< of `task_before`
  std::string thing = {};                  ///< with a timetable: its name
  bool delayed = false;                    ///< it came later than its timetable says
  Ticks since = 0;                         ///< for a shift
  Ticks first_gain = 0;                    ///< for a shift: less than this sooner gains nothing
  std::optional<MissedShift> missed = {};  ///< for a shift: why not the one before
};

/// A task that could start, but for a machine in its zone.
struct StartWait {
  Ticks since = 0;
  MidWait wait;  ///< for the machine, and who moved it out of the way; -1: nobody did
};

/// When a task is done, and why not sooner.
struct TaskTimes {
  Ticks ready = 0;   ///< links let it start; in or out of shift
  Ticks wanted = 0;  ///< links let it start and what it needs is free; in or out of shift
  Ticks start = 0;   ///< `wanted`, or the begin of the next shift of all it needs
  Ticks finish = 0;
  Ticks first_gain = 0;  ///< with `wanted` less than this sooner, `start` is not sooner
  Held held = Held::plan_start;
  int link = -1;                        ///< held by a link: index into `after`
  bool known_late = false;              ///< that link allows it sooner than it was known to
  int resource = -1;                    ///< held by a resource: index
  int task_before = -1;                 ///< held by a resource: the task that had it
  bool given_back_midway = false;       ///< that task gave it back before its own finish
  bool kept = false;                    ///< it was kept for others after that
  bool repaired = false;                ///< it was repaired after that
  std::optional<StartWait> start_wait;  ///< after what held it
  std::vector<MidWait> mid_waits;       ///< in order; only of tasks that are simulated
  int finish_link = -1;  ///< the link that holds the finish, if the task's own work does not
};

struct NetworkTimes {
  std::vector<TaskTimes> tasks;  ///< as in the network
  Ticks finish = 0;              ///< the latest of all
};

/// Why there are no times, each in a sentence for the user.
struct NetworkMistakes {
  std::vector<std::string> messages;
};

/// When each task starts and finishes, nothing before 0.
///
/// A task can start when its links let it (`earliest_start`), all its resources are free and all
/// work. Of all tasks that wait, the one that can start first is given its resources first; of
/// several that can at the same moment the one of the higher priority, then the one that stands
/// first in the file. What is given is not taken back: a link with a negative lag that becomes
/// known later than the moment it allows does not push a task aside. Tasks tied at both ends
/// (`LinkOrder`) start by what holds their start; their finish, and what they need, is held.
///
/// Tasks that wait for each other, by links or for what others hold, calendars without common
/// hours, and what is later than kEndOfTime are mistakes. O((tasks + links) log tasks), and for
/// each task the different sets of resources that share one with it.
std::variant<NetworkTimes, NetworkMistakes> times_of(const Network& network);

}  // namespace rubicon::schedule
