#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "src/fleets/lanes/lane_network.hpp"
#include "src/fleets/lanes/shortest_way.hpp"

namespace rubicon::lanes {

/// Random numbers that are the same everywhere (SplitMix64).
class TestRandom {
 public:
  explicit TestRandom(std::uint64_t seed) : state_(seed) {}
  std::uint64_t bits() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15U);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31);
  }
  /// In [low, high], both included.
  int whole(int low, int high) {
    return low + static_cast<int>(bits() % static_cast<std::uint64_t>(high - low + 1));
  }

 private:
  std::uint64_t state_;
};

/// The node of a name, which has to be there.
inline NodeIndex node(const LaneNetwork& network, const std::string& name) {
  const NodeIndex found = network.find_node(name);
  if (found == kNone) throw std::invalid_argument("test: no node " + name);
  return found;
}

/// The lane between two nodes, by their names, which has to be there.
inline LaneIndex lane(const LaneNetwork& network, const std::string& from, const std::string& to) {
  const LaneIndex found = network.find_lane(node(network, from), node(network, to));
  if (found == kNone) throw std::invalid_argument("test: no lane " + from + " to " + to);
  return found;
}

/// "A B BB1 B1"
inline std::string told(const LaneNetwork& network, const std::vector<NodeIndex>& nodes) {
  std::string text;
  for (const NodeIndex i : nodes) text += (text.empty() ? "" : " ") + network.node(i).name;
  return text;
}

inline std::string told(const LaneNetwork& network, const std::optional<Way>& way) {
  return way ? told(network, way->nodes) : "no way";
}

}  // namespace rubicon::lanes
