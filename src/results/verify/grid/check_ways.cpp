#include "src/results/verify/grid/check_ways.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <deque>
#include <map>

#include "src/results/verify/input/json_fields.hpp"

namespace rubicon::verify {

namespace {

constexpr std::size_t kListed = 20;

struct Place {
  int x = 0, y = 0;
};

struct Walker {
  std::string name;
  Place from, to, now;
  std::string way;
};

class WaysCheck {
 public:
  explicit WaysCheck(const Json& json) : fields_(json, "the result of a grid") {}

  WaysVerdict run() {
    read_map();
    read_walkers();
    check_least_cost();
    verdict_.agents = static_cast<int>(walkers_.size());
    const std::string outcome = fields_.text("outcome");
    if (outcome != "solved") {
      if (outcome != "no_solution" && outcome != "out_of_expansions") {
        throw UnreadableInput("the outcome is none that a grid has");
      }
      for (const Walker& walker : walkers_) {
        if (!walker.way.empty()) {
          fault("agent '" + walker.name + "' has a way, though nothing was solved");
        }
      }
      return std::move(verdict_);
    }
    verdict_.solved = true;
    walk();
    for (const Walker& walker : walkers_) {
      std::size_t ticks = walker.way.size();
      while (ticks > 0 && walker.way[ticks - 1] == 'w') --ticks;
      verdict_.cost += static_cast<long long>(ticks);
      verdict_.makespan = std::max(verdict_.makespan, static_cast<int>(ticks));
    }
    compare("cost", verdict_.cost);
    compare("makespan", verdict_.makespan);
    return std::move(verdict_);
  }

 private:
  void fault(std::string text) {
    ++faults_;
    if (faults_ <= kListed) verdict_.faults.push_back(std::move(text));
  }

  void compare(const char* what, long long found) {
    const double said = fields_.number(what);
    if (said != static_cast<double>(found)) {
      fault(fmt::format("{} is said to be {:.0f}, and is {}", what, said, found));
    }
  }

  void read_map() {
    const JsonFields map = fields_.object("map");
    for (const Json& row : map.array("rows")) {
      if (!row.is_string()) throw UnreadableInput("a row of the map is not a text");
      rows_.push_back(row.get<std::string>());
      if (rows_.back().size() != rows_.front().size()) {
        throw UnreadableInput("the rows of the map are not alike in length");
      }
    }
    width_ = rows_.empty() ? 0 : rows_.front().size();
  }

  bool is_open(Place at) const {
    return at.x >= 0 && at.y >= 0 && static_cast<std::size_t>(at.y) < rows_.size() &&
           static_cast<std::size_t>(at.x) < width_ &&
           rows_[static_cast<std::size_t>(at.y)][static_cast<std::size_t>(at.x)] == '.';
  }
  std::size_t number(Place at) const {
    return static_cast<std::size_t>(at.y) * width_ + static_cast<std::size_t>(at.x);
  }

  static Place place_of(const Json& value) {
    if (!value.is_array() || value.size() != 2 || !value[0].is_number_integer() ||
        !value[1].is_number_integer()) {
      throw UnreadableInput("a cell is not two whole numbers");
    }
    const auto x = value[0].get<std::int64_t>(), y = value[1].get<std::int64_t>();
    if (std::min(x, y) < 0 || std::max(x, y) > 1'000'000'000) {
      throw UnreadableInput("a cell is not on any map");
    }
    return {static_cast<int>(x), static_cast<int>(y)};
  }

  void read_walkers() {
    for (const Json& each : fields_.array("agents")) {
      const JsonFields agent(each, "an agent");
      Walker walker;
      walker.name = agent.text("name");
      walker.from = walker.now = place_of(agent.any("from"));
      walker.to = place_of(agent.any("to"));
      walker.way = agent.text_or("way", "");
      shortest_.push_back(agent.integer("shortest"));
      if (!is_open(walker.from)) fault("agent '" + walker.name + "' begins on a wall");
      if (!is_open(walker.to)) fault("agent '" + walker.name + "' ends on a wall");
      walkers_.push_back(std::move(walker));
    }
    if (faults_ > 0) throw UnreadableInput(verdict_.faults.front());
  }

  /// Each shortest way by a search of its own.
  void check_least_cost() {
    long long sum = 0;
    std::vector<int> steps;
    std::deque<Place> open;
    for (std::size_t i = 0; i < walkers_.size(); ++i) {
      const Walker& walker = walkers_[i];
      steps.assign(rows_.size() * width_, -1);
      open.assign(1, walker.from);
      steps[number(walker.from)] = 0;
      while (!open.empty() && steps[number(walker.to)] < 0) {
        const Place at = open.front();
        open.pop_front();
        for (const Place next : {Place{at.x + 1, at.y}, Place{at.x - 1, at.y},
                                 Place{at.x, at.y + 1}, Place{at.x, at.y - 1}}) {
          if (!is_open(next) || steps[number(next)] >= 0) continue;
          steps[number(next)] = steps[number(at)] + 1;
          open.push_back(next);
        }
      }
      const int found = steps[number(walker.to)];
      if (found != shortest_[i]) {
        fault(fmt::format("the shortest way of agent '{}' is said to have {} ticks, and has {}",
                          walker.name, shortest_[i], found));
      }
      sum += found;
    }
    compare("least_cost", sum);
  }

  /// All at once, one tick after the other. Who has come to the end of its way stays there.
  void walk() {
    std::vector<int> here(rows_.size() * width_, -1);  // by cell: who is there, at this tick
    std::vector<std::size_t> walking;
    for (std::size_t i = 0; i < walkers_.size(); ++i) {
      walking.push_back(i);
      enter(i, 0, here);
    }
    std::vector<Place> before(walkers_.size());
    for (std::size_t tick = 1; !walking.empty(); ++tick) {
      std::erase_if(walking, [&](std::size_t i) {
        const Walker& walker = walkers_[i];
        if (walker.way.size() >= tick) return false;
        if (walker.now.x != walker.to.x || walker.now.y != walker.to.y) {
          fault(fmt::format("agent '{}' ends at ({}, {}), not at its goal ({}, {})", walker.name,
                            walker.now.x, walker.now.y, walker.to.x, walker.to.y));
        }
        return true;
      });
      for (const std::size_t i : walking) {
        before[i] = walkers_[i].now;
        if (here[number(before[i])] == static_cast<int>(i)) here[number(before[i])] = -1;
        step(walkers_[i], tick);
      }
      std::map<std::pair<std::size_t, std::size_t>, std::size_t> moves;
      for (const std::size_t i : walking) {
        enter(i, tick, here);
        const std::size_t from = number(before[i]), to = number(walkers_[i].now);
        if (from == to) continue;
        const auto other = moves.find({to, from});
        if (other != moves.end()) {
          fault(fmt::format("tick {}: agents '{}' and '{}' pass through each other", tick,
                            walkers_[other->second].name, walkers_[i].name));
        }
        moves[{from, to}] = i;
      }
    }
  }

  void enter(std::size_t i, std::size_t tick, std::vector<int>& here) {
    int& there = here[number(walkers_[i].now)];
    if (there >= 0) {
      fault(fmt::format("tick {}: agents '{}' and '{}' are both in ({}, {})", tick,
                        walkers_[static_cast<std::size_t>(there)].name, walkers_[i].name,
                        walkers_[i].now.x, walkers_[i].now.y));
    }
    there = static_cast<int>(i);
  }

  void step(Walker& walker, std::size_t tick) {
    Place next = walker.now;
    const char move = walker.way[tick - 1];
    if (move == 'r') ++next.x;
    if (move == 'l') --next.x;
    if (move == 'd') ++next.y;
    if (move == 'u') --next.y;
    if (std::string_view("rlduw").find(move) == std::string_view::npos) {
      fault(fmt::format("tick {}: agent '{}' has an unknown move", tick, walker.name));
    } else if (!is_open(next)) {
      fault(fmt::format("tick {}: agent '{}' goes from ({}, {}) into a wall", tick, walker.name,
                        walker.now.x, walker.now.y));
    } else {
      walker.now = next;
    }
  }

  JsonFields fields_;
  std::vector<std::string> rows_;
  std::size_t width_ = 0;
  std::vector<Walker> walkers_;
  std::vector<int> shortest_;
  std::size_t faults_ = 0;
  WaysVerdict verdict_;
};

}  // namespace

bool is_grid_result(const std::string& text) { return has_format(text, "rubicon-grid"); }

WaysVerdict check_ways(const std::string& text) {
  const Json json = parse_json(text);
  return WaysCheck(json).run();
}

std::string ways_text(const WaysVerdict& verdict, const std::string& name) {
  std::string text;
  for (const std::string& fault : verdict.faults) text += name + ": " + fault + "\n";
  if (!verdict.faults.empty()) return text;
  if (!verdict.solved)
    return "nothing to walk: it was not solved; the bound on its cost is right\n";
  return fmt::format(
      "verified: {} agents, {} ticks, cost {}: nobody on a wall, no two in one cell, no two "
      "through "
      "each other, all at their goals\n",
      verdict.agents, verdict.makespan, verdict.cost);
}

std::string ways_json(const WaysVerdict& verdict) {
  const Json json = {{"faults", verdict.faults},
                     {"agents", verdict.agents},
                     {"makespan", verdict.makespan},
                     {"cost", verdict.cost}};
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace rubicon::verify
