#include "src/exchange/ifc/face_lists.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "src/exchange/ifc/step_values.hpp"

namespace rubicon::ifc {

namespace {

using math::Vec3;

/// Counts from 1 on; nothing if there is anything else.
std::optional<std::vector<std::uint64_t>> counts(const StepItem& list) {
  std::vector<std::uint64_t> found;
  for (const StepItem each : list) {
    const auto number = each.kind() == StepKind::number ? whole_number(each.text()) : std::nullopt;
    if (!number || *number == 0) return std::nullopt;
    found.push_back(*number);
  }
  return found;
}

class ListReader {
 public:
  explicit ListReader(const ShapeTerms& terms) : terms_(terms) {}

  std::optional<Solid> read(const StepRecord& record) {
    const auto values = StepValues::read(record.arguments);
    if (!values || !read_points((*values)[0].reference())) return std::nullopt;
    const bool triangles = record.keyword == "IFCTRIANGULATEDFACESET";
    // The order of the arguments is not the same in IFC 4 and 4.3; what each is can be told.
    StepItem faces;
    for (const StepItem item : values->all()) {
      if (item.kind() != StepKind::list || item.size() == 0) continue;
      const StepItem first = *item.begin();
      if (faces.kind() != StepKind::list) {
        const bool found = triangles ? holds_counts(first) : first.kind() == StepKind::reference;
        if (found) faces = item;
      } else if (first.kind() == StepKind::number) {
        const auto order = counts(item);
        if (!order) return std::nullopt;
        through_ = *order;
      }
    }
    if (faces.kind() != StepKind::list) return std::nullopt;
    for (const StepItem face : faces) {
      if (!(triangles ? add_face(face, {}) : add_polygon(face.reference()))) return std::nullopt;
    }
    return std::move(solid_);
  }

 private:
  static bool holds_counts(const StepItem& item) {
    if (item.kind() != StepKind::list || item.size() == 0) return false;
    const StepItem first = *item.begin();
    return first.kind() == StepKind::number && whole_number(first.text()).has_value();
  }

  bool read_points(std::uint64_t id) {
    const StepRecord* record = terms_.file.find(id);
    if (record == nullptr || record->keyword != "IFCCARTESIANPOINTLIST3D") return false;
    const auto values = StepValues::read(record->arguments);
    if (!values) return false;
    for (const StepItem each : (*values)[0]) {
      Vec3 p;
      int count = 0;
      for (const StepItem value : each) {
        const auto number = value.number();
        if (!number || count == 3) return false;
        p[count++] = *number;
      }
      if (count != 3 || !terms_.budget.spend(1)) return false;
      solid_.points.push_back(p);
    }
    return true;
  }

  bool add_polygon(std::uint64_t id) {
    const StepRecord* record = terms_.file.find(id);
    if (record == nullptr || !record->keyword.starts_with("IFCINDEXEDPOLYGONALFACE")) return false;
    const auto values = StepValues::read(record->arguments);
    return values && add_face((*values)[0], (*values)[1]);
  }

  bool add_face(const StepItem& outline, const StepItem& holes) {
    std::vector<Loop> loops;
    if (!add_loop(outline, loops)) return false;
    for (const StepItem hole : holes) {
      if (!add_loop(hole, loops)) return false;
    }
    return put_face(std::move(loops), solid_, terms_.budget);
  }

  bool add_loop(const StepItem& list, std::vector<Loop>& loops) const {
    const auto numbers = counts(list);
    if (!numbers || numbers->size() < 3) return false;
    Loop loop;
    for (std::uint64_t number : *numbers) {
      if (!through_.empty()) {
        if (number > through_.size()) return false;
        number = through_[static_cast<std::size_t>(number - 1)];
      }
      if (number > solid_.points.size()) return false;
      loop.push_back(static_cast<int>(number - 1));
    }
    loops.push_back(std::move(loop));
    return true;
  }

  const ShapeTerms& terms_;
  std::vector<std::uint64_t> through_;  ///< another order of the points, if there is one
  Solid solid_;
};

}  // namespace

bool is_face_list(const StepRecord& record) {
  return record.keyword == "IFCTRIANGULATEDFACESET" || record.keyword == "IFCPOLYGONALFACESET";
}

std::optional<Solid> solid_of_face_list(const ShapeTerms& terms, const StepRecord& record) {
  return ListReader(terms).read(record);
}

bool put_face(std::vector<Loop> loops, Solid& solid, WorkBudget& budget) {
  if (loops.size() == 1 && loops[0].size() == 3) {
    solid.triangles.push_back({loops[0][0], loops[0][1], loops[0][2]});
    return true;
  }
  Vec3 normal = Vec3::Zero();
  std::size_t outer = 0;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if (!budget.spend(loops[i].size())) return false;
    const Vec3 n = loop_normal(solid.points, loops[i]);
    if (n.norm() > normal.norm()) {
      normal = n;
      outer = i;
    }
  }
  if (!(normal.norm() > 0)) return true;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const bool same = loop_normal(solid.points, loops[i]).dot(normal) > 0;
    if (same != (i == outer)) std::reverse(loops[i].begin(), loops[i].end());
  }
  const auto triangles = triangulate(solid.points, loops, normal, budget);
  if (!triangles) return false;
  solid.triangles.insert(solid.triangles.end(), triangles->begin(), triangles->end());
  return true;
}

}  // namespace rubicon::ifc
