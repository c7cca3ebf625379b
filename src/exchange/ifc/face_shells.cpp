#include "src/exchange/ifc/face_shells.hpp"

#include <algorithm>
#include <map>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "src/exchange/ifc/face_lists.hpp"
#include "src/exchange/ifc/ifc_placement.hpp"
#include "src/exchange/ifc/step_values.hpp"

namespace rubicon::ifc {

namespace {

using math::Vec3;

constexpr std::string_view kBrep = "IFCFACETEDBREP";
constexpr std::string_view kHollowBrep = "IFCFACETEDBREPWITHVOIDS";

/// Reads shells of IfcFace records.
class ShellReader {
 public:
  explicit ShellReader(const ShapeTerms& terms) : terms_(terms) {}

  std::optional<Solid> read(const StepRecord& record) {
    const auto values = StepValues::read(record.arguments);
    if (!values) return std::nullopt;
    if (record.keyword == kBrep || record.keyword == kHollowBrep) return brep(*values);
    bool whole = true;
    for (const StepItem each : (*values)[0]) whole = whole && add_shell(each.reference());
    if (!whole) return std::nullopt;
    return std::move(solid_);
  }

 private:
  std::optional<Solid> brep(const StepValues& values) {
    if (!add_shell(values[0].reference())) return std::nullopt;
    turn(0, true);
    for (const StepItem each : values[1]) {
      const std::size_t first = solid_.triangles.size();
      if (!add_shell(each.reference())) return std::nullopt;
      turn(first, false);
    }
    return std::move(solid_);
  }

  /// Files disagree about which way the faces of voids look, and some about others.
  void turn(std::size_t first, bool outwards) {
    Solid part{solid_.points, {}};
    part.triangles.assign(solid_.triangles.begin() + static_cast<std::ptrdiff_t>(first),
                          solid_.triangles.end());
    if (!is_closed(part) || (volume_of(part) > 0) == outwards) return;
    for (std::size_t i = first; i < solid_.triangles.size(); ++i) {
      std::swap(solid_.triangles[i][1], solid_.triangles[i][2]);
    }
  }

  bool add_shell(std::uint64_t id) {
    const StepRecord* record = terms_.file.find(id);
    if (record == nullptr) return false;
    const bool shell = record->keyword == "IFCCLOSEDSHELL" || record->keyword == "IFCOPENSHELL" ||
                       record->keyword == "IFCCONNECTEDFACESET";
    const auto values = StepValues::read(record->arguments);
    if (!shell || !values) return false;
    for (const StepItem face : (*values)[0]) {
      if (!add_face(face.reference())) return false;
    }
    return !solid_.triangles.empty();
  }

  bool add_face(std::uint64_t id) {
    const StepRecord* record = terms_.file.find(id);
    if (record == nullptr || record->keyword != "IFCFACE") return false;
    const auto values = StepValues::read(record->arguments);
    if (!values) return false;
    std::vector<Loop> loops;
    for (const StepItem each : (*values)[0]) {
      auto loop = bound(each.reference());
      if (!loop) return false;
      if (loop->size() >= 3) loops.push_back(std::move(*loop));
    }
    return put_face(loops, solid_, terms_.budget);
  }

  std::optional<Loop> bound(std::uint64_t id) {
    const StepRecord* record = terms_.file.find(id);
    if (record == nullptr || !terms_.budget.spend(1)) return std::nullopt;
    const bool known = record->keyword == "IFCFACEOUTERBOUND" || record->keyword == "IFCFACEBOUND";
    const auto values = known ? StepValues::read(record->arguments) : std::nullopt;
    const StepRecord* line = values ? terms_.file.find((*values)[0].reference()) : nullptr;
    if (line == nullptr || line->keyword != "IFCPOLYLOOP") return std::nullopt;
    const auto corners = StepValues::read(line->arguments);
    if (!corners) return std::nullopt;
    Loop loop;
    for (const StepItem each : (*corners)[0]) {
      const auto index = corner(each.reference());
      if (!index) return std::nullopt;
      if (loop.empty() || loop.back() != *index) loop.push_back(*index);
    }
    while (loop.size() > 1 && loop.back() == loop.front()) loop.pop_back();
    if ((*values)[1].is_enumeration("F")) std::reverse(loop.begin(), loop.end());
    return loop;
  }

  /// Points at the same place are one, whatever records they have.
  std::optional<int> corner(std::uint64_t id) {
    const auto [found, is_new] = by_record_.try_emplace(id, -1);
    if (!is_new) return found->second < 0 ? std::nullopt : std::optional(found->second);
    const auto p = cartesian_point(terms_.file, id);
    if (!p || !terms_.budget.spend(1)) return std::nullopt;
    const auto [place, is_first] = by_place_.try_emplace({p->x() + 0.0, p->y() + 0.0, p->z() + 0.0},
                                                         static_cast<int>(solid_.points.size()));
    if (is_first) solid_.points.push_back(*p);
    found->second = place->second;
    return place->second;
  }

  const ShapeTerms& terms_;
  Solid solid_;
  std::map<std::uint64_t, int> by_record_;
  std::map<std::tuple<double, double, double>, int> by_place_;
};

}  // namespace

bool is_faces(const StepRecord& record) {
  return record.keyword == kBrep || record.keyword == kHollowBrep ||
         record.keyword == "IFCSHELLBASEDSURFACEMODEL" ||
         record.keyword == "IFCFACEBASEDSURFACEMODEL" || is_face_list(record);
}

std::optional<Solid> solid_of_faces(const ShapeTerms& terms, const StepRecord& record) {
  if (is_face_list(record)) return solid_of_face_list(terms, record);
  return ShellReader(terms).read(record);
}

}  // namespace rubicon::ifc
