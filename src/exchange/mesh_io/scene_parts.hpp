#pragma once

#include <cstddef>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "src/exchange/mesh_io/file_scene.hpp"

namespace rubicon::mesh_io {

/// The GlobalId of IFC that the name of a node ends with, empty: none. It stays when a model is
/// renamed.
std::string_view global_id(std::string_view name);

/// Which nodes of a scene a name means, looked up rather than searched for: a plan names thousands
/// of parts of one model. Made in one pass; holds views into the scene, which must outlive it.
class SceneParts {
 public:
  explicit SceneParts(const FileScene& scene);

  /// Nodes of that name, and those whose GlobalId it is; in the order of the file.
  const std::vector<std::size_t>& meant_by(std::string_view part) const;

  /// The node and all below it, in the order of the file.
  std::vector<std::size_t> with_all_below(std::size_t node) const;

  /// Of several nodes in the order of the file, those that lie below none of the others.
  std::vector<std::size_t> outermost(const std::vector<std::size_t>& nodes) const;

 private:
  const FileScene& scene_;
  std::unordered_map<std::string_view, std::vector<std::size_t>> by_name_;
  std::vector<std::size_t> none_;
  std::vector<std::size_t> first_child_;  ///< by node; the count of nodes: none
  std::vector<std::size_t> next_child_;   ///< of the same parent
};

}  // namespace rubicon::mesh_io
