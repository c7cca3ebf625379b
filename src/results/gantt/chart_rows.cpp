#include "src/results/gantt/chart_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "src/results/gantt/chart_labels.hpp"

namespace rubicon::gantt {

namespace {

/// Rows that still fit on one large sheet of paper.
constexpr std::size_t kMostRows = 80;

/// Fewer tasks make no group.
constexpr std::size_t kLeastGroup = 2;

std::string place_of(const std::string& task) {
  const std::size_t point = task.rfind('.');
  return point == std::string::npos ? std::string() : task.substr(0, point);
}

Lane group_row(const std::string& place, const std::vector<const Bar*>& tasks) {
  Lane row;
  row.name = place;
  row.brief = fmt::format("{} tasks", tasks.size());
  for (const Bar* task : tasks) row.bars.push_back(*task);
  return row;
}

}  // namespace

std::vector<Lane> chart_rows(const std::vector<Bar>& tasks, std::string& title) {
  std::vector<Lane> rows;
  title = "Tasks";
  if (tasks.size() <= kMostRows) {
    for (const Bar& task : tasks) {
      rows.push_back({task.name, {}, duration_label(task.span.to - task.span.from), {task}, {}});
    }
    return rows;
  }
  title = "Places";
  std::map<std::string, std::vector<const Bar*>> groups;
  std::vector<std::string> order;
  for (const Bar& task : tasks) {
    auto& group = groups[place_of(task.name)];
    group.push_back(&task);
    if (group.size() == kLeastGroup) order.push_back(place_of(task.name));
  }
  for (const std::string& place : order) {
    if (!place.empty()) rows.push_back(group_row(place, groups[place]));
  }
  if (rows.size() > kMostRows) rows.clear();
  std::stable_sort(rows.begin(), rows.end(), [](const Lane& a, const Lane& b) {
    return a.bars.front().span.from < b.bars.front().span.from;
  });
  return rows;
}

}  // namespace rubicon::gantt
