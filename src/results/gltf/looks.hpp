#pragma once

#include <cstddef>
#include <vector>

#include "src/results/gltf/meshes.hpp"
#include "src/simulation/trace/header.hpp"

namespace rubicon::gltf {

/// The looks of what stands on a site, in the colours of the report page: machines in turn, placed
/// components by their kind.
class Looks {
 public:
  explicit Looks(const std::vector<trace::HeaderComponent>& components);

  Look ground() const;
  /// Bodies of one machine differ a little.
  Look body(std::size_t robot, std::size_t body) const;
  /// Room that a machine keeps for itself.
  Look envelope(std::size_t robot) const;
  Look rope() const;
  Look waiting() const;
  Look carried() const;
  Look placed(std::size_t component) const;
  /// Of people.
  Look zone() const;
  /// What keeps a timetable; people.
  Look moving(bool people) const;

 private:
  std::vector<std::size_t> kinds_;  ///< by component
};

/// The kind of a component by its name: "wall" of "u_1_2.wall_3".
std::string kind_of(const std::string& name);

}  // namespace rubicon::gltf
