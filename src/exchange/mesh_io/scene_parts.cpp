#include "src/exchange/mesh_io/scene_parts.hpp"

#include <algorithm>

namespace rubicon::mesh_io {

std::string_view global_id(std::string_view name) {
  constexpr std::size_t kLength = 22;
  if (name.size() <= kLength || name[name.size() - kLength - 1] != '_') return {};
  return name.substr(name.size() - kLength);
}

SceneParts::SceneParts(const FileScene& scene)
    : scene_(scene),
      first_child_(scene.nodes.size(), scene.nodes.size()),
      next_child_(scene.nodes.size(), scene.nodes.size()) {
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    const std::string_view name = scene.nodes[i].name;
    by_name_[name].push_back(i);
    if (const std::string_view id = global_id(name); !id.empty()) by_name_[id].push_back(i);
  }
  for (std::size_t i = scene.nodes.size(); i-- > 0;) {
    if (scene.nodes[i].parent < 0) continue;
    const auto parent = static_cast<std::size_t>(scene.nodes[i].parent);
    next_child_[i] = first_child_[parent];
    first_child_[parent] = i;
  }
}

const std::vector<std::size_t>& SceneParts::meant_by(std::string_view part) const {
  const auto found = by_name_.find(part);
  return found == by_name_.end() ? none_ : found->second;
}

std::vector<std::size_t> SceneParts::with_all_below(std::size_t node) const {
  std::vector<std::size_t> nodes{node};
  for (std::size_t at = 0; at < nodes.size(); ++at) {
    for (std::size_t child = first_child_[nodes[at]]; child < scene_.nodes.size();
         child = next_child_[child]) {
      nodes.push_back(child);
    }
  }
  std::sort(nodes.begin(), nodes.end());
  return nodes;
}

std::vector<std::size_t> SceneParts::outermost(const std::vector<std::size_t>& nodes) const {
  std::vector<std::size_t> result;
  for (const std::size_t node : nodes) {
    int above = scene_.nodes[node].parent;
    while (above >= 0 &&
           !std::binary_search(nodes.begin(), nodes.end(), static_cast<std::size_t>(above))) {
      above = scene_.nodes[static_cast<std::size_t>(above)].parent;
    }
    if (above < 0) result.push_back(node);
  }
  return result;
}

}  // namespace rubicon::mesh_io
