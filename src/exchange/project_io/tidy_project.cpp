#include "src/exchange/project_io/tidy_project.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <tuple>
#include <unordered_map>

#include "src/exchange/project_io/link_rings.hpp"

namespace rubicon::project_io {

namespace {

/// Deepest outline; its numbers would grow with the square of it.
constexpr int kMaxLevel = 100;

/// Most calendars: a large company has some thousands, one a person.
constexpr std::size_t kMaxCalendars = 10000;

/// Longest chain of base calendars; Project itself allows one.
constexpr int kMaxBases = 16;

interpreter::Span place(const std::vector<interpreter::Span>& places, std::size_t i) {
  return i < places.size() ? places[i] : interpreter::Span{};
}

class Tidier {
 public:
  Tidier(Project& project, const ProjectPlaces& places, Listing& listing)
      : project_(project), places_(places), listing_(listing) {}

  void run() {
    if (project_.calendars.size() > kMaxCalendars) {
      listing_.add("I07", "calendars", place(places_.calendars, kMaxCalendars),
                   fmt::format("{} calendars are too many; those from here on are left out",
                               project_.calendars.size()));
      project_.calendars.resize(kMaxCalendars);
    }
    calendars_ = number(project_.calendars, places_.calendars, "calendar");
    tasks_ = number(project_.tasks, places_.tasks, "task");
    resources_ = number(project_.resources, places_.resources, "resource");
    number(project_.assignments, places_.assignments, "assignment");
    check_calendars();
    check_outline();
    check_tasks();
    check_resources();
    check_assignments();
    check_rings();
  }

 private:
  using Index = std::unordered_map<std::int64_t, std::size_t>;

  template <typename Element>
  Index number(std::vector<Element>& elements, const std::vector<interpreter::Span>& places,
               const char* what) {
    Index index;
    std::vector<std::size_t> without;
    std::int64_t largest = 0;
    for (std::size_t i = 0; i < elements.size(); ++i) {
      const std::int64_t uid = elements[i].uid;
      largest = std::max(largest, uid);
      if (uid < 0 || !index.emplace(uid, i).second) without.push_back(i);
    }
    for (const std::size_t i : without) {
      const std::int64_t uid = ++largest;
      const std::string found =
          elements[i].uid == kNone
              ? "has no number"
              : fmt::format("has the number {}, which is taken or no number", elements[i].uid);
      listing_.add("I04", fmt::format("uid {}", what), place(places, i),
                   fmt::format("this {} {}; it gets {}", what, found, uid),
                   "what refers to that number means the first that has it");
      elements[i].uid = uid;
      index.emplace(uid, i);
    }
    return index;
  }

  void require(std::int64_t& uid, const Index& index, const char* what, const char* of,
               interpreter::Span span) {
    if (uid < 0) uid = kNone;
    if (uid == kNone || index.contains(uid)) return;
    listing_.add(
        "I05", fmt::format("reference {} {}", what, of), span,
        fmt::format("there is no {} {}, which this {} names; taken as none", what, uid, of));
    uid = kNone;
  }

  void check_calendars() {
    for (std::size_t i = 0; i < project_.calendars.size(); ++i) {
      Calendar& calendar = project_.calendars[i];
      const interpreter::Span span = place(places_.calendars, i);
      require(calendar.base, calendars_, "calendar", "calendar", span);
      if (has_ring_of_bases(calendar)) {
        listing_.add("I06", "base ring", span,
                     fmt::format("calendar '{}' is based on itself, or on too many others; taken "
                                 "as based on none",
                                 calendar.name));
        calendar.base = kNone;
      }
      if (calendar.base == kNone) {
        for (std::optional<DayTimes>& day : calendar.week) day = day.value_or(DayTimes{});
      }
      tidy_exceptions(calendar.exceptions);
    }
    require(project_.calendar, calendars_, "calendar", "project", {});
  }

  bool has_ring_of_bases(const Calendar& calendar) const {
    std::int64_t uid = calendar.base;
    for (int steps = 0; uid != kNone && steps < kMaxBases; ++steps) {
      if (uid == calendar.uid) return true;
      const auto found = calendars_.find(uid);
      if (found == calendars_.end()) return false;
      uid = project_.calendars[found->second].base;
    }
    return uid != kNone;
  }

  /// Project 2007 and later write every exception twice, once with its name.
  static void tidy_exceptions(std::vector<CalendarException>& exceptions) {
    const auto key = [](const CalendarException& e) { return std::tie(e.first, e.last); };
    std::stable_sort(exceptions.begin(), exceptions.end(),
                     [&](const CalendarException& a, const CalendarException& b) {
                       if (key(a) != key(b)) return key(a) < key(b);
                       if (a.times != b.times) return text_less(a.times, b.times);
                       return a.name > b.name;
                     });
    const auto same = [&](const CalendarException& a, const CalendarException& b) {
      return key(a) == key(b) && a.times == b.times && (b.name.empty() || a.name == b.name);
    };
    exceptions.erase(std::unique(exceptions.begin(), exceptions.end(), same), exceptions.end());
  }

  static bool text_less(const DayTimes& a, const DayTimes& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(),
                                        [](const Interval& x, const Interval& y) {
                                          return std::tie(x.from, x.to) < std::tie(y.from, y.to);
                                        });
  }

  void check_outline() {
    int before = 0;
    for (std::size_t i = 0; i < project_.tasks.size(); ++i) {
      Task& task = project_.tasks[i];
      const int lowest = i == 0 ? 0 : 1;
      const int level = std::clamp(task.level, lowest, std::min(before + 1, kMaxLevel));
      if (level != task.level) {
        listing_.add("I03", "outline", place(places_.tasks, i),
                     fmt::format("outline level {} cannot follow level {}; taken as {}", task.level,
                                 before, level));
        task.level = level;
      }
      before = level;
    }
    // Called a heading and being one say the same thing.
    for (std::size_t i = 0; i < project_.tasks.size(); ++i) {
      if (project_.is_heading(i)) project_.tasks[i].summary = false;
    }
  }

  void check_tasks() {
    for (std::size_t i = 0; i < project_.tasks.size(); ++i) {
      Task& task = project_.tasks[i];
      require(task.calendar, calendars_, "calendar", "task", place(places_.tasks, i));
      std::vector<Link> kept;
      std::set<std::pair<std::size_t, LinkType>> known;
      for (std::size_t k = 0; k < task.after.size(); ++k) {
        const interpreter::Span span =
            i < places_.links.size() ? place(places_.links[i], k) : interpreter::Span{};
        const auto found = tasks_.find(task.after[k].predecessor);
        if (found == tasks_.end()) {
          listing_.add("I05", "link", span,
                       fmt::format("task '{}' waits for task {}, which is not there; the link is "
                                   "left out",
                                   task.name, task.after[k].predecessor));
        } else if (found->second == i) {
          listing_.add("I06", "self link", span,
                       fmt::format("task '{}' waits for itself; the link is left out", task.name));
        } else if (!known.emplace(found->second, task.after[k].type).second) {
          listing_.add(
              "I05", "link twice", span,
              fmt::format("task '{}' has the same link twice; the second is left out", task.name));
        } else {
          kept.push_back(task.after[k]);
        }
      }
      std::sort(kept.begin(), kept.end(), [&](const Link& a, const Link& b) {
        const std::size_t first = tasks_.at(a.predecessor), second = tasks_.at(b.predecessor);
        return first != second ? first < second : a.type < b.type;
      });
      task.after = std::move(kept);
    }
  }

  void check_resources() {
    for (std::size_t i = 0; i < project_.resources.size(); ++i) {
      require(project_.resources[i].calendar, calendars_, "calendar", "resource",
              place(places_.resources, i));
    }
  }

  void check_assignments() {
    std::vector<Assignment> kept;
    for (std::size_t i = 0; i < project_.assignments.size(); ++i) {
      Assignment& assignment = project_.assignments[i];
      if (!tasks_.contains(assignment.task)) {
        listing_.add("I05", "assignment", place(places_.assignments, i),
                     fmt::format("there is no task {} for this assignment; it is left out",
                                 assignment.task));
        continue;
      }
      if (assignment.resource >= 0) {
        require(assignment.resource, resources_, "resource", "assignment",
                place(places_.assignments, i));
      } else {
        assignment.resource = kNone;
      }
      kept.push_back(assignment);
    }
    project_.assignments = std::move(kept);
  }

  void check_rings() {
    const std::vector<LinkPlace> rings = links_in_rings(project_);
    for (auto at = rings.rbegin(); at != rings.rend(); ++at) {
      std::vector<Link>& links = project_.tasks[at->task].after;
      const auto link = links.begin() + static_cast<std::ptrdiff_t>(at->link);
      listing_.add("I06", "ring", place(places_.tasks, at->task),
                   fmt::format("tasks wait for each other in a ring; the link '{}' {} '{}' is left "
                               "out",
                               project_.tasks[tasks_.at(link->predecessor)].name,
                               schedule::name_of(link->type), project_.tasks[at->task].name));
      links.erase(link);
    }
  }

  Project& project_;
  const ProjectPlaces& places_;
  Listing& listing_;
  Index calendars_, tasks_, resources_;
};

}  // namespace

void tidy_project(Project& project, const ProjectPlaces& places, Listing& listing) {
  Tidier(project, places, listing).run();
}

}  // namespace rubicon::project_io
