#include "src/fleets/grid/improve.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "src/fleets/grid/earliest_way.hpp"
#include "src/fleets/grid/random_bits.hpp"

namespace rubicon::grid {

namespace {

int cost_of(const CellWay& way) { return static_cast<int>(way.size()) - 1; }

/// Which agents plan anew together.
enum class Group { behind_late, of_cell, any };
constexpr std::array<Group, 3> kGroups = {Group::behind_late, Group::of_cell, Group::any};
constexpr std::array<int, 5> kSizes = {2, 4, 8, 16, 32};
/// Walks from a late agent that look for those in its way, at most.
constexpr int kWalks = 10;
/// Share of the old in what is known of a kind of group, once it was tried again.
constexpr double kMemory = 0.95;
/// Least weight of a kind of group, as a share of the largest, so that each is tried now and then.
constexpr double kLeastShare = 0.02;
/// Gain for work below which all kinds are alike.
constexpr double kLeastRate = 1e-9;

/// What is believed of each kind at first, for each agent of the group.
constexpr double kFirstGain = 1;
constexpr double kFirstWork = 100;

/// A kind of group. It is chosen by what it gained (ticks of cost) for its work (expansions),
/// lately; at first the small ones are.
struct Choice {
  Group group = Group::any;
  int size = 0;
  double gain = 0;
  double work = 1;
};

class Improver {
 public:
  Improver(const CellGraph& graph, Distances& distances, std::vector<CellWay>& ways,
           std::uint64_t seed)
      : graph_(graph),
        distances_(distances),
        ways_(ways),
        stays_(graph.size()),
        finder_(graph, distances, stays_),
        random_(seed),
        in_group_(ways.size(), 0),
        was_late_(ways.size(), 0) {
    for (std::size_t i = 0; i < ways.size(); ++i) {
      stays_.add(static_cast<int>(i), ways[i]);
      cost_ += cost_of(ways[i]);
    }
    for (const Group group : kGroups) {
      for (const int size : kSizes) {
        if (at(size) <= ways.size() || size == kSizes[0]) {
          choices_.push_back({group, size, kFirstGain, static_cast<double>(size) * kFirstWork});
        }
      }
    }
  }

  std::int64_t run(std::int64_t bound, std::int64_t limit) {
    if (ways_.empty()) return 0;
    while (cost_ > bound && spent() < limit) {
      Choice& choice = choose();
      gather(choice);
      const std::int64_t before = cost_, spent_before = spent();
      plan_again();
      ++looks_;
      choice.gain = kMemory * choice.gain + static_cast<double>(before - cost_);
      choice.work = kMemory * choice.work + static_cast<double>(spent() - spent_before);
    }
    return spent();
  }

 private:
  std::int64_t spent() const { return finder_.expansions() + looks_; }

  Choice& choose() {
    // What decays to 0 would be chosen for ever.
    double best = kLeastRate, all = 0;
    for (const Choice& each : choices_) best = std::max(best, each.gain / each.work);
    const auto weight = [&](const Choice& each) {
      return std::max(each.gain / each.work, kLeastShare * best);
    };
    for (const Choice& each : choices_) all += weight(each);
    double left = static_cast<double>(random_.next() >> 11U) * 0x1p-53 * all;
    for (Choice& each : choices_) {
      left -= weight(each);
      if (left < 0) return each;
    }
    return choices_.front();
  }

  void put(int agent) {
    if (agent < 0 || in_group_[at(agent)] != 0) return;
    in_group_[at(agent)] = 1;
    group_.push_back(agent);
  }
  int any_agent() { return static_cast<int>(random_.below(ways_.size())); }
  int delay_of(int agent) {
    return cost_of(ways_[at(agent)]) - distances_.of(agent, ways_[at(agent)].front());
  }

  void gather(const Choice& choice) {
    for (const int agent : group_) in_group_[at(agent)] = 0;
    group_.clear();
    const std::size_t size = std::min(at(choice.size), ways_.size());
    if (choice.group == Group::behind_late) gather_behind_late(size);
    if (choice.group == Group::of_cell) gather_of_cell(size);
    while (group_.size() < size && (choice.group == Group::any || group_.empty())) put(any_agent());
    for (std::size_t i = group_.size(); i > 1; --i) {
      std::swap(group_[i - 1], group_[random_.below(i)]);
    }
  }

  /// The latest agent that was not yet looked at, and those whom it meets when it goes on from
  /// somewhere on its way, as it could if they were not there.
  void gather_behind_late(std::size_t size) {
    int late = -1;
    for (std::size_t i = 0; i < ways_.size(); ++i) {
      const int agent = static_cast<int>(i);
      if (was_late_[i] == 0 && delay_of(agent) > 0 &&
          (late < 0 || delay_of(agent) > delay_of(late))) {
        late = agent;
      }
    }
    if (late < 0) {
      std::fill(was_late_.begin(), was_late_.end(), 0);
      return;
    }
    was_late_[at(late)] = 1;
    put(late);
    for (int walk = 0; walk < kWalks && group_.size() < size; ++walk) {
      const int from = walk % 2 == 0 ? late : group_[random_.below(group_.size())];
      walk_from(from, size);
    }
  }

  void walk_from(int agent, std::size_t size) {
    const CellWay& way = ways_[at(agent)];
    int tick = static_cast<int>(random_.below(way.size()));
    CellId here = way[at(tick)];
    while (group_.size() < size) {
      std::array<CellId, 5> possible = {};
      std::size_t count = 0;
      const auto add = [&](CellId cell) {
        if (tick + 1 + distances_.of(agent, cell) < cost_of(way)) possible[count++] = cell;
      };
      add(here);
      for (const CellId beside : graph_.beside(here)) add(beside);
      if (count == 0) return;
      const CellId next = possible[random_.below(count)];
      put(stays_.agent_at(next, tick + 1));
      const int other = stays_.agent_at(next, tick);
      if (other >= 0 && other == stays_.agent_at(here, tick + 1)) put(other);
      here = next;
      ++tick;
    }
  }

  /// Those who come through a cell, and through cells near to it, at about the same time.
  void gather_of_cell(std::size_t size) {
    const CellWay& way = ways_[at(any_agent())];
    const int tick = static_cast<int>(random_.below(way.size()));
    near_.assign(1, way[at(tick)]);
    if (seen_.empty()) seen_.assign(at(graph_.size()), 0);
    ++looked_;
    seen_[at(near_.front())] = looked_;
    for (std::size_t i = 0; i < near_.size() && i < 8 * size && group_.size() < size; ++i) {
      const auto& stays = stays_.in(near_[i]);
      const int middle = stays_.first_until(near_[i], tick);
      // From the one who is there, in both directions of time.
      for (int reach = 0; reach <= 4 && group_.size() < size; ++reach) {
        for (const int index : {middle + reach, middle - reach - 1}) {
          if (index < 0 || at(index) >= stays.size() || group_.size() >= size) continue;
          put(stays[at(index)].agent);
        }
      }
      for (const CellId beside : graph_.beside(near_[i])) {
        if (std::exchange(seen_[at(beside)], looked_) != looked_) near_.push_back(beside);
      }
    }
  }

  /// The group plans, one after the other. Its old ways come back where that is no better.
  void plan_again() {
    std::int64_t old_cost = 0, least_rest = 0;
    for (const int agent : group_) {
      stays_.remove(ways_[at(agent)]);
      old_cost += cost_of(ways_[at(agent)]);
      least_rest += distances_.of(agent, ways_[at(agent)].front());
    }
    if (new_ways_.size() < group_.size()) new_ways_.resize(group_.size());
    std::size_t planned = 0;
    std::int64_t cost = 0;
    for (; planned < group_.size(); ++planned) {
      const int agent = group_[planned];
      const CellWay& old = ways_[at(agent)];
      least_rest -= distances_.of(agent, old.front());
      const std::int64_t latest = old_cost - cost - least_rest;
      CellWay& way = new_ways_[planned];
      if (!finder_.find(agent, old.front(), old.back(), static_cast<int>(latest), way)) break;
      stays_.add(agent, way);
      cost += cost_of(way);
    }
    if (planned == group_.size()) {
      for (std::size_t i = 0; i < planned; ++i) ways_[at(group_[i])].swap(new_ways_[i]);
      cost_ += cost - old_cost;
      return;
    }
    for (std::size_t i = 0; i < planned; ++i) stays_.remove(new_ways_[i]);
    for (const int agent : group_) stays_.add(agent, ways_[at(agent)]);
  }

  const CellGraph& graph_;
  Distances& distances_;
  std::vector<CellWay>& ways_;
  StayTable stays_;
  EarliestWay finder_;
  RandomBits random_;
  std::vector<Choice> choices_;
  std::vector<int> group_;
  std::vector<char> in_group_, was_late_;
  std::vector<CellWay> new_ways_;
  std::vector<CellId> near_;
  std::vector<std::uint32_t> seen_;
  std::uint32_t looked_ = 0;
  std::int64_t cost_ = 0, looks_ = 0;
};

}  // namespace

std::int64_t improve(const CellGraph& graph, Distances& distances, std::vector<CellWay>& ways,
                     std::int64_t bound, std::uint64_t seed, std::int64_t limit) {
  return Improver(graph, distances, ways, seed).run(bound, limit);
}

}  // namespace rubicon::grid
