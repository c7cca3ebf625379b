#pragma once

#include <cstddef>
#include <vector>

#include "src/exchange/project_io/project.hpp"

namespace rubicon::project_io {

/// A link by where it stands: the i-th of `tasks[task].after`.
struct LinkPlace {
  std::size_t task = 0;
  std::size_t link = 0;
};

/// Links to leave out so that none of the tasks waits for itself; empty if none does. Starts and
/// finishes are the events of a graph: a task starts before it finishes, a heading starts before
/// and finishes after all that is below it, a link puts one event before another. In every strongly
/// connected set of events (Tarjan 1972) the links that go against the order of the outline are
/// taken: what stays goes forwards, so it makes no ring. Linear in tasks and links.
std::vector<LinkPlace> links_in_rings(const Project& project);

}  // namespace rubicon::project_io
