#include "src/exchange/project_io/crew_lanes.hpp"

#include <algorithm>
#include <set>

namespace rubicon::project_io {

namespace {

/// Events looked at for one task; what lies farther back is taken for unlinked, which costs a crew
/// more and delays nobody.
constexpr std::size_t kMostEvents = 2'000;

/// The start (false) or the finish of a node.
using Event = std::pair<std::size_t, bool>;

}  // namespace

CrewLanes::CrewLanes(const PlanNetwork& network) {
  const std::size_t lines = network.tasks.size();
  before_.resize(lines + network.milestones.size());
  for (std::size_t i = 0; i < lines; ++i) {
    if (network.tasks[i].planned) nodes_.emplace(network.tasks[i].name, i);
  }
  for (std::size_t i = 0; i < network.milestones.size(); ++i) {
    nodes_.emplace(network.milestones[i].name, lines + i);
  }
  for (std::size_t i = 0; i < lines; ++i) add_links(i, network.tasks[i].after);
  for (std::size_t i = 0; i < network.milestones.size(); ++i) {
    add_links(lines + i, network.milestones[i].after);
  }
}

void CrewLanes::add_links(std::size_t node, const std::vector<PlanLink>& links) {
  for (const PlanLink& link : links) {
    const auto found = nodes_.find(link.predecessor);
    if (found != nodes_.end() && link.lag >= 0) before_[node].push_back({found->second, link.type});
  }
}

std::vector<std::size_t> CrewLanes::lanes_of(const std::vector<std::size_t>& lines) const {
  std::vector<std::size_t> lanes;
  std::unordered_map<std::size_t, std::size_t> last;  // lane by its last line
  for (const std::size_t line : lines) {
    const std::size_t before = lane_behind(line, last);
    std::size_t lane = last.size();
    if (before < before_.size()) {
      lane = last.at(before);
      last.erase(before);
    }
    last.emplace(line, lane);
    lanes.push_back(lane);
  }
  return lanes;
}

/// The last line of a lane that has finished whenever this one starts; the count of nodes: none.
/// Goes back from event to event, each not later than the one before.
std::size_t CrewLanes::lane_behind(std::size_t line,
                                   const std::unordered_map<std::size_t, std::size_t>& last) const {
  std::vector<Event> events{{line, false}};
  std::set<Event> seen(events.begin(), events.end());
  for (std::size_t at = 0; at < events.size() && events.size() < kMostEvents; ++at) {
    const auto [node, finish] = events[at];
    if (finish && last.contains(node)) return node;
    const auto add = [&](const Event& event) {
      if (seen.insert(event).second) events.push_back(event);
    };
    if (finish) add({node, false});
    for (const Before& before : before_[node]) {
      const bool of_finish = before.type == LinkType::FF || before.type == LinkType::SF;
      if (of_finish != finish) continue;
      add({before.node, before.type == LinkType::FS || before.type == LinkType::FF});
    }
  }
  return before_.size();
}

}  // namespace rubicon::project_io
