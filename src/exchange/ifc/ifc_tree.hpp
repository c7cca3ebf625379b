#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "src/exchange/ifc/ifc_model.hpp"
#include "src/exchange/ifc/step_file.hpp"

namespace rubicon::ifc {

/// What belongs to what in a file: elements to storeys, parts to wholes, holes to walls.
class IfcTree {
 public:
  /// `file` must outlive this object.
  explicit IfcTree(const StepFile& file);

  /// The way from the top down to a record, ending with it. Rings and ways of more than
  /// kDeepestTree steps are cut at the top.
  std::vector<std::uint64_t> way_to(std::uint64_t id) const;

  /// The node of a record in `tree`, made with those above it if they are not there.
  int node_of(std::uint64_t id, std::vector<IfcNode>& tree);

  const std::vector<IfcOpening>& openings() const { return openings_; }
  const std::vector<IfcOpening>& projections() const { return projections_; }

 private:
  void relate(const StepRecord& record);
  void put(std::uint64_t child, std::uint64_t parent, int rank);

  struct Parent {
    std::uint64_t id = 0;
    int rank = 0;  ///< the lowest counts
  };
  const StepFile* file_;
  std::unordered_map<std::uint64_t, Parent> parent_;
  std::unordered_map<std::uint64_t, int> node_;
  std::vector<IfcOpening> openings_, projections_;
};

/// Site, building, storey, assembly, part: real files have ten steps.
inline constexpr std::size_t kDeepestTree = 64;

}  // namespace rubicon::ifc
