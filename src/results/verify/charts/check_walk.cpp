#include "src/results/verify/charts/check_walk.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "src/results/verify/input/json_fields.hpp"

namespace rubicon::verify {

namespace {

constexpr std::size_t kMostWalkFaults = 20;

class WalkCheck {
 public:
  explicit WalkCheck(const Json& json) : fields_(json, "the result of an exploration") {}

  WalkVerdict run() {
    rule_ = fields_.text("rule");
    if (rule_ != "tarry" && rule_ != "fraenkel") fields_.fail("tarry or fraenkel");
    for (const Json& each : fields_.array("nodes")) nodes_.push_back(text_of(each, "a node"));
    const int last_node = static_cast<int>(nodes_.size()) - 1;
    read_ways(last_node);
    for (const Json& each : fields_.array("robots")) check(JsonFields(each, "a robot"));
    return std::move(verdict_);
  }

 private:
  struct Way {
    int a = 0, b = 0;
    double length = 0, speed = 0;
  };

  /// A way for each two nodes that lanes join, that of the first lane.
  void read_ways(int last_node) {
    std::vector<int> first_lanes;
    std::set<std::pair<int, int>> joined;
    int count = 0;
    for (const Json& each : fields_.array("lanes")) {
      const JsonFields fields(each, "a lane");
      Way way;
      way.a = integer_of(fields.any("from"), "the begin of a lane", 0, last_node);
      way.b = integer_of(fields.any("to"), "the end of a lane", 0, last_node);
      way.length = fields.number("length");
      way.speed = fields.number("speed");
      if (!(way.speed > 0) || !(way.length > 0)) fields.fail("a length and a speed above 0");
      if (joined.insert(std::minmax(way.a, way.b)).second) {
        first_lanes.push_back(count);
        ways_.push_back(way);
      }
      ++count;
    }
    if (fields_.array("ways") != Json(first_lanes)) {
      fault("the ways are not those that lanes make");
    }
    ways_at_.resize(nodes_.size());
    for (const Way& way : ways_) {
      ways_at_[static_cast<std::size_t>(way.a)].push_back(way.b);
      ways_at_[static_cast<std::size_t>(way.b)].push_back(way.a);
    }
  }

  void fault(std::string text) {
    if (verdict_.faults.size() < kMostWalkFaults) verdict_.faults.push_back(std::move(text));
  }

  /// Nodes that can be reached.
  std::set<int> reached(int from) const {
    std::set<int> seen = {from};
    std::vector<int> open = {from};
    while (!open.empty()) {
      const int at = open.back();
      open.pop_back();
      for (const int next : ways_at_[static_cast<std::size_t>(at)]) {
        if (seen.insert(next).second) open.push_back(next);
      }
    }
    return seen;
  }

  void check(const JsonFields& fields) {
    const std::string& name = fields.text("name");
    ++verdict_.robots;
    const int from =
        integer_of(fields.any("from"), "a start", 0, static_cast<int>(nodes_.size()) - 1);
    const double fastest =
        fields.has("speed") ? fields.number("speed") : std::numeric_limits<double>::infinity();
    if (!(fastest > 0)) fields.fail("a speed above 0");
    std::vector<int> from_a(ways_.size(), 0), from_b(ways_.size(), 0);
    int at = from;
    Ticks now = 0;
    double length = 0;
    for (const Json& each : fields.array("steps")) {
      const JsonFields step(each, "a step");
      const int way_index =
          integer_of(step.any("way"), "a way", 0, static_cast<int>(ways_.size()) - 1);
      const int to = integer_of(step.any("to"), "a node", 0, static_cast<int>(nodes_.size()) - 1);
      const auto index = static_cast<std::size_t>(way_index);
      const Way& way = ways_[index];
      ++verdict_.steps;
      const bool is_forth = way.a == at && way.b == to;
      const bool is_back = way.b == at && way.a == to;
      if (!is_forth && !is_back) {
        fault(fmt::format("{} goes from {} to {} by a way that does not lead there", name, node(at),
                          node(to)));
        return;
      }
      // A loop has no direction: it counts once each.
      ++(is_forth && !(is_back && from_a[index] > from_b[index]) ? from_a : from_b)[index];
      now += std::max<Ticks>(1, std::llround(way.length / std::min(way.speed, fastest) * 1e9));
      length += way.length;
      const Json& arrival = step.any("arrival_ns");
      if (!arrival.is_number_integer()) step.fail("a whole number of nanoseconds");
      // Each step is rounded once by either.
      if (std::abs(arrival.get<Ticks>() - now) > verdict_.steps) {
        fault(fmt::format("{} is not at {} at the time that is said", name, node(to)));
        return;
      }
      at = to;
    }
    if (at != from) fault(fmt::format("{} does not come back to {}", name, node(from)));
    const std::set<int> seen = reached(from);
    check_uses(name, seen, from_a, from_b);
    int used = 0;
    for (std::size_t i = 0; i < ways_.size(); ++i) used += from_a[i] + from_b[i] > 0 ? 1 : 0;
    std::vector<int> unseen;
    for (int i = 0; i < static_cast<int>(nodes_.size()); ++i) {
      if (!seen.contains(i)) unseen.push_back(i);
    }
    if (fields.integer("ways") != used || fields.array("unseen") != Json(unseen) ||
        std::abs(fields.number("length") - length) > 1e-6 * (1 + length)) {
      fault(fmt::format("the sums of {} are not those of its walk", name));
    }
  }

  void check_uses(const std::string& name, const std::set<int>& seen,
                  const std::vector<int>& from_a, const std::vector<int>& from_b) {
    for (std::size_t i = 0; i < ways_.size(); ++i) {
      if (!seen.contains(ways_[i].a)) continue;
      const int uses = from_a[i] + from_b[i];
      const std::string way = node(ways_[i].a) + " - " + node(ways_[i].b);
      if (uses == 0) fault(fmt::format("{} never goes along {}", name, way));
      if (rule_ == "tarry" && (from_a[i] != 1 || from_b[i] != 1)) {
        fault(fmt::format("{} goes along {} {} and {} times, not once in each direction", name, way,
                          from_a[i], from_b[i]));
      }
      if (uses > 2) fault(fmt::format("{} goes along {} {} times", name, way, uses));
    }
  }

  const std::string& node(int i) const { return nodes_[static_cast<std::size_t>(i)]; }

  JsonFields fields_;
  std::string rule_;
  std::vector<std::string> nodes_;
  std::vector<Way> ways_;
  std::vector<std::vector<int>> ways_at_;  ///< by node: where ways lead
  WalkVerdict verdict_;
};

}  // namespace

bool is_walk_result(const std::string& text) { return has_format(text, "rubicon-walk"); }

WalkVerdict check_walk(const std::string& text) {
  const Json json = parse_json(text);
  return WalkCheck(json).run();
}

std::string walk_verdict_text(const WalkVerdict& verdict, const std::string& name) {
  std::string text;
  for (const std::string& fault : verdict.faults) text += name + ": " + fault + "\n";
  if (!verdict.faults.empty()) return text;
  return fmt::format(
      "verified: {} robots, {} steps: each way that can be reached, as often as the rule has it, "
      "and back to the start\n",
      verdict.robots, verdict.steps);
}

std::string walk_verdict_json(const WalkVerdict& verdict) {
  const Json json = {
      {"faults", verdict.faults}, {"robots", verdict.robots}, {"steps", verdict.steps}};
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace rubicon::verify
