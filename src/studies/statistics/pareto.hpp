#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace rubicon::statistics {

/// Two things of which less is better.
struct Costs {
  double first = 0;
  double second = 0;
};

/// Those that nothing else is as good as in both and better in one, by `first`, then as given. What
/// is infinite in one belongs to none.
std::vector<std::size_t> pareto_front(std::span<const Costs> points);

}  // namespace rubicon::statistics
