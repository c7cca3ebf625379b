#include "src/simulation/schedule/resource_sets.hpp"

#include <algorithm>

namespace rubicon::schedule {

namespace {

void sort_unique(std::vector<int>& list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

}  // namespace

ResourceSets::ResourceSets(std::vector<int> calendar_of, std::vector<WorkCalendar> calendars)
    : calendar_of_(std::move(calendar_of)), calendars_(std::move(calendars)) {
  for (int i = 0; i < static_cast<int>(calendars_.size()); ++i) common_[{i}] = i;
  common_[{}] = static_cast<int>(calendars_.size());
  calendars_.emplace_back();
}

std::variant<int, std::string> ResourceSets::common_calendar(const std::vector<int>& hours_of) {
  std::vector<int> set;
  for (const int resource : hours_of) {
    if (calendar_of_[at(resource)] >= 0) set.push_back(calendar_of_[at(resource)]);
  }
  sort_unique(set);
  const auto found = common_.find(set);
  if (found != common_.end()) return found->second;
  WorkCalendar common = calendars_[at(set.front())];
  for (std::size_t i = 1; i < set.size(); ++i) {
    auto both = intersection(common, calendars_[at(set[i])]);
    if (auto* mistake = std::get_if<CalendarMistake>(&both)) return mistake->message;
    common = std::get<WorkCalendar>(std::move(both));
  }
  calendars_.push_back(std::move(common));
  const int index = static_cast<int>(calendars_.size()) - 1;
  common_.emplace(std::move(set), index);
  return index;
}

std::variant<int, std::string> ResourceSets::set_of(std::vector<Share> shares,
                                                    std::vector<int> hours_of) {
  std::sort(shares.begin(), shares.end());
  sort_unique(hours_of);
  auto key = std::make_pair(std::move(shares), std::move(hours_of));
  const auto found = set_of_.find(key);
  if (found != set_of_.end()) return found->second;
  const auto calendar = common_calendar(key.second);
  if (const auto* message = std::get_if<std::string>(&calendar)) return *message;
  Set& set = sets_.emplace_back();
  set.shares = key.first;
  for (const Share& share : set.shares) set.resources.push_back(share.resource);
  set.calendar = std::get<int>(calendar);
  const int index = size() - 1;
  set_of_.emplace(std::move(key), index);
  return index;
}

const WorkCalendar& ResourceSets::hours(int resource) const {
  const int calendar = calendar_of_[at(resource)];
  return calendars_[at(calendar >= 0 ? calendar : common_.at({}))];
}

}  // namespace rubicon::schedule
