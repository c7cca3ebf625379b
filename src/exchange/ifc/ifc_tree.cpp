#include "src/exchange/ifc/ifc_tree.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "src/exchange/ifc/ifc_class_names.hpp"
#include "src/exchange/ifc/step_values.hpp"

namespace rubicon::ifc {

namespace {

/// A class of relation: which argument is the whole and which are the parts, and which relation
/// counts where a record has several.
struct Relation {
  std::string_view keyword;
  std::size_t whole;
  std::size_t parts;
  int rank;
};

constexpr std::array<Relation, 6> kRelations = {{
    {"IFCRELAGGREGATES", 4, 5, 0},
    {"IFCRELCONTAINEDINSPATIALSTRUCTURE", 5, 4, 1},
    {"IFCRELNESTS", 4, 5, 2},
    {"IFCRELVOIDSELEMENT", 4, 5, 3},
    {"IFCRELPROJECTSELEMENT", 4, 5, 3},
    {"IFCRELFILLSELEMENT", 4, 5, 4},
}};

}  // namespace

IfcTree::IfcTree(const StepFile& file) : file_(&file) {
  for (const StepRecord& record : file.records()) relate(record);
}

void IfcTree::relate(const StepRecord& record) {
  if (!record.keyword.starts_with("IFCREL")) return;
  const auto relation =
      std::find_if(kRelations.begin(), kRelations.end(),
                   [&](const Relation& each) { return each.keyword == record.keyword; });
  if (relation == kRelations.end()) return;
  const auto values = StepValues::read(record.arguments);
  if (!values) return;
  const std::uint64_t whole = (*values)[relation->whole].reference();
  const StepItem parts = (*values)[relation->parts];
  if (parts.kind() == StepKind::reference) put(parts.reference(), whole, relation->rank);
  for (const StepItem part : parts) put(part.reference(), whole, relation->rank);
  if (whole == 0 || parts.reference() == 0) return;
  if (record.keyword == "IFCRELVOIDSELEMENT") openings_.push_back({parts.reference(), whole});
  if (record.keyword == "IFCRELPROJECTSELEMENT") {
    projections_.push_back({parts.reference(), whole});
  }
}

void IfcTree::put(std::uint64_t child, std::uint64_t parent, int rank) {
  if (child == 0 || parent == 0) return;
  const auto [place, is_new] = parent_.try_emplace(child, Parent{parent, rank});
  if (!is_new && rank < place->second.rank) place->second = {parent, rank};
}

std::vector<std::uint64_t> IfcTree::way_to(std::uint64_t id) const {
  std::vector<std::uint64_t> way;
  while (way.size() < kDeepestTree && std::find(way.begin(), way.end(), id) == way.end()) {
    way.push_back(id);
    const auto above = parent_.find(id);
    if (above == parent_.end()) break;
    id = above->second.id;
  }
  std::reverse(way.begin(), way.end());
  return way;
}

int IfcTree::node_of(std::uint64_t id, std::vector<IfcNode>& tree) {
  int parent = -1;
  for (const std::uint64_t each : way_to(id)) {
    const auto known = node_.find(each);
    if (known != node_.end()) {
      parent = known->second;
      continue;
    }
    const StepRecord* record = file_->find(each);
    // The project itself heads everything and says nothing.
    if (record == nullptr || record->keyword == "IFCPROJECT") continue;
    const auto values = StepValues::read(record->arguments);
    if (!values) continue;
    constexpr std::size_t kGlobalId = 0;
    constexpr std::size_t kName = 2;
    const std::string name = (*values)[kName].decoded();
    tree.push_back({class_name(record->keyword) + "_" + (name.empty() ? "Unnamed" : name) + "_" +
                        (*values)[kGlobalId].decoded(),
                    parent});
    parent = static_cast<int>(tree.size()) - 1;
    node_.emplace(each, parent);
  }
  return parent;
}

}  // namespace rubicon::ifc
