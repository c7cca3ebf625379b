#include "src/simulation/schedule/link.hpp"

#include <algorithm>

namespace rubicon::schedule {

const char* name_of(LinkType type) {
  switch (type) {
    case LinkType::FS:
      return "FS";
    case LinkType::SS:
      return "SS";
    case LinkType::FF:
      return "FF";
    case LinkType::SF:
      return "SF";
  }
  return "";
}

std::optional<LinkType> parse_link_type(std::string_view text) {
  for (const LinkType type : {LinkType::FS, LinkType::SS, LinkType::FF, LinkType::SF}) {
    if (text == name_of(type)) return type;
  }
  return std::nullopt;
}

TaskEnd end_before(LinkType type) {
  return type == LinkType::FS || type == LinkType::FF ? TaskEnd::finish : TaskEnd::start;
}

TaskEnd end_after(LinkType type) {
  return type == LinkType::FF || type == LinkType::SF ? TaskEnd::finish : TaskEnd::start;
}

Ticks bound_of(const Link& link, Ticks event, const WorkCalendar& calendar) {
  event = within_time(event);
  if (link.clock == LagClock::working) return calendar.shifted(event, link.lag);
  return within_time(event + within_time(link.lag));
}

void LinkBounds::hold(TaskEnd end, Ticks bound, int index) {
  Ticks& latest = end == TaskEnd::start ? start : finish;
  int& link = end == TaskEnd::start ? start_link : finish_link;
  if (link >= 0 && bound <= latest) return;
  latest = bound;
  link = index;
}

EarliestStart earliest_start(const LinkBounds& bounds, Ticks not_before, Ticks work,
                             const WorkCalendar& calendar) {
  EarliestStart result = earliest_start_of_unknown(bounds, not_before, calendar);
  if (bounds.finish_link >= 0) {
    const Ticks for_finish = calendar.latest_start(bounds.finish, work);
    if (for_finish > result.wanted) {
      result = {for_finish, calendar.next_working(for_finish), StartHold::finish_link};
    }
  }
  if (work <= 0) result.start = result.wanted;
  return result;
}

EarliestStart earliest_start_of_unknown(const LinkBounds& bounds, Ticks not_before,
                                        const WorkCalendar& calendar) {
  EarliestStart result;
  result.wanted = std::max(bounds.start, not_before);
  const bool by_link = bounds.start_link >= 0 && bounds.start >= not_before;
  result.hold = by_link ? StartHold::start_link : StartHold::not_before;
  result.start = calendar.next_working(result.wanted);
  return result;
}

Ticks held_finish(const LinkBounds& bounds, Ticks done) {
  return bounds.finish_link >= 0 ? std::max(done, bounds.finish) : done;
}

}  // namespace rubicon::schedule
