#include "src/simulation/schedule/link_state.hpp"

#include <algorithm>

#include "src/simulation/schedule/link_order.hpp"

namespace rubicon::schedule {

LinkState::LinkState(Network network, std::vector<Ticks> work,
                     const std::vector<std::optional<TaskTimes>>& precomputed,
                     CalendarOf calendar_of)
    : network_(std::move(network)),
      work_(std::move(work)),
      calendar_of_(std::move(calendar_of)),
      mutually_constrained_(link_order(network_.tasks).tied_both_ways),
      precomputed_(network_.tasks.size(), false),
      left_out_(network_.tasks.size(), false),
      followers_(network_.tasks.size()),
      times_(network_.tasks.size()),
      known_(network_.tasks.size(), 0) {
  for (std::size_t i = 0; i < precomputed.size(); ++i) {
    if (!precomputed[i]) continue;
    precomputed_[i] = true;
    times_[i] = *precomputed[i];
  }
  for (int task = 0; task < size(); ++task) {
    for (const Link& link : links_of(task)) {
      followers_[at(link.task)].push_back({task, link.type});
    }
  }
  count_links();
}

void LinkState::count_links() {
  to_start_.assign(times_.size(), 0);
  to_finish_.assign(times_.size(), 0);
  for (int task = 0; task < size(); ++task) {
    for (const Link& link : links_of(task)) {
      if (left_out_[at(link.task)]) continue;
      if (waits_to_start(task, link.task, link.type)) ++to_start_[at(task)];
      if (end_after(link.type) == TaskEnd::finish) ++to_finish_[at(task)];
    }
  }
}

bool LinkState::waits_to_start(int task, int before, LinkType type) const {
  return end_after(type) == TaskEnd::start ||
         (!mutually_constrained_[at(task)] && (known_work(task) || take_turns(task, before)));
}

/// Whether two tasks hold from start to finish what is not enough for both.
bool LinkState::take_turns(int task, int other) const {
  if (is_milestone(task) || is_milestone(other)) return false;
  const NetworkTask& a = network_.tasks[at(task)];
  const NetworkTask& b = network_.tasks[at(other)];
  const auto units = [&](const NetworkTask& each, std::size_t i) {
    return each.units.empty() ? network_.resources[at(each.resources[i])].size : each.units[i];
  };
  for (std::size_t i = 0; i < a.resources.size(); ++i) {
    const auto same = std::find(b.resources.begin(), b.resources.end(), a.resources[i]);
    if (same == b.resources.end()) continue;
    const auto place = static_cast<std::size_t>(same - b.resources.begin());
    if (units(a, i) + units(b, place) > network_.resources[at(a.resources[i])].size) return true;
  }
  return false;
}

LinkBounds LinkState::bounds_of(int task, bool with_finish) const {
  LinkBounds bounds;
  const std::vector<Link>& links = links_of(task);
  for (std::size_t i = 0; i < links.size(); ++i) {
    const TaskEnd end = end_after(links[i].type);
    if ((end == TaskEnd::finish && !with_finish) || left_out_[at(links[i].task)]) continue;
    const TaskTimes& before = times(links[i].task);
    const bool from_start = end_before(links[i].type) == TaskEnd::start;
    bounds.hold(end,
                bound_of(links[i], from_start ? before.start : before.finish, calendar_of_(task)),
                static_cast<int>(i));
  }
  return bounds;
}

std::vector<int> LinkState::open_links(int task, TaskEnd end) const {
  std::vector<int> open;
  const std::vector<Link>& links = links_of(task);
  for (std::size_t i = 0; i < links.size(); ++i) {
    const bool holds = end == TaskEnd::start ? waits_to_start(task, links[i].task, links[i].type)
                                             : end_after(links[i].type) == TaskEnd::finish;
    if (holds && !is_known(links[i].task, end_before(links[i].type))) {
      open.push_back(static_cast<int>(i));
    }
  }
  return open;
}

TaskTimes LinkState::ready_times(int task, int before, Ticks now) const {
  const bool known = known_work(task);
  const LinkBounds bounds = bounds_of(task, known && !mutually_constrained_[at(task)]);
  const WorkCalendar& calendar = calendar_of_(task);
  const Ticks date = network_.tasks[at(task)].not_before;
  const EarliestStart earliest = known ? earliest_start(bounds, date, work(task), calendar)
                                       : earliest_start_of_unknown(bounds, date, calendar);
  TaskTimes times;
  // What a negative lag allows may be over when it becomes known.
  times.ready = times.wanted = std::max(earliest.wanted, now);
  if (earliest.hold == StartHold::not_before) {
    if (date > 0) times.held = Held::date;
  } else {
    times.held = Held::link;
    times.link = earliest.hold == StartHold::start_link ? bounds.start_link : bounds.finish_link;
  }
  if (before >= 0 && earliest.wanted < now) {
    const std::vector<Link>& links = links_of(task);
    // Of several links from it the one that became known now.
    const bool by_finish = is_known(before, TaskEnd::finish) && times_[at(before)].finish == now;
    const auto leads = [&](const Link& link) {
      return link.task == before && waits_to_start(task, before, link.type);
    };
    auto last = std::find_if(links.begin(), links.end(), [&](const Link& link) {
      return leads(link) && (end_before(link.type) == TaskEnd::finish) == by_finish;
    });
    if (last == links.end()) last = std::find_if(links.begin(), links.end(), leads);
    times.held = Held::link;
    times.link = static_cast<int>(last - links.begin());
    times.known_late = true;
  }
  times.start = std::max(earliest.start, now);
  return times;
}

bool LinkState::started_for_finish(const TaskTimes& times, int task) const {
  // Where the moment to start had passed when it became known, its own work makes it finish later.
  if (times.known_late || times.start_wait) return false;
  return times.held == Held::link &&
         end_after(links_of(task)[at(times.link)].type) == TaskEnd::finish;
}

void LinkState::set_times(int task, TaskTimes times) {
  journal_.assign(times_[at(task)], std::move(times));
}

void LinkState::add_mid_wait(int task, MidWait wait) {
  std::vector<MidWait>& waits = times_[at(task)].mid_waits;
  waits.push_back(wait);
  journal_.on_undo([&waits] { waits.pop_back(); });
}

void LinkState::forget_known(int task) { journal_.assign(known_[at(task)], std::uint8_t{0}); }

void LinkState::publish(int task, TaskEnd end, Ticks time) {
  TaskTimes times = times_[at(task)];
  (end == TaskEnd::start ? times.start : times.finish) = time;
  set_times(task, std::move(times));
  journal_.assign(known_[at(task)], static_cast<std::uint8_t>(known_[at(task)] | bit(end)));
  pending_.emplace_back(task, end);
}

void LinkState::count_down(int& counter) {
  --counter;
  journal_.on_undo([&counter] { ++counter; });
}

void LinkState::propagate(Listener& listener) {
  while (!pending_.empty()) {
    const auto [task, end] = pending_.back();
    pending_.pop_back();
    if (left_out_[at(task)]) continue;
    for (const auto& [follower, type] : followers_of(task)) {
      if (end_before(type) != end || left_out_[at(follower)]) continue;
      if (end_after(type) == TaskEnd::finish) {
        count_down(to_finish_[at(follower)]);
        if (may_finish(follower)) listener.may_finish(follower);
      }
      if (waits_to_start(follower, task, type)) {
        count_down(to_start_[at(follower)]);
        if (may_start(follower)) listener.may_start(follower, task);
      }
    }
  }
}

bool LinkState::let_go(int task, int before, LinkType type) {
  if (end_after(type) != TaskEnd::finish || is_known(before, end_before(type))) return false;
  return --to_finish_[at(task)] == 0;
}

}  // namespace rubicon::schedule
