#pragma once

#include <string>
#include <vector>

#include "src/simulation/schedule/network.hpp"

namespace rubicon::schedule {

/// What the links of all tasks say about their order.
struct LinkOrder {
  /// Rings of tasks none of which can be first, each in the order "a after b after a", once a ring
  /// of tasks that hang together. The events of tasks count: "a SS" and back "b FF" is no ring.
  std::vector<std::vector<int>> rings;

  /// To each task, whether links lead from it through others back to it without being a ring: two
  /// tasks that run side by side, tied at both ends. The start of such a task cannot wait for what
  /// holds its finish.
  std::vector<bool> tied_both_ways;
};

/// Linear in tasks and links. Links lead to tasks that are there.
LinkOrder link_order(const std::vector<NetworkTask>& tasks);

/// "these tasks wait for each other: a after b after a", with a few names of a long ring.
std::string ring_text(const std::vector<NetworkTask>& tasks, const std::vector<int>& ring);

}  // namespace rubicon::schedule
