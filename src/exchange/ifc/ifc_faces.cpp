#include "src/exchange/ifc/ifc_faces.hpp"

#include <fmt/format.h>

namespace rubicon::ifc {

namespace {

/// A count from 1 on; nothing for any other number.
std::optional<std::size_t> index_of(const StepItem& item) {
  const auto number = item.kind() == StepKind::number ? whole_number(item.text()) : std::nullopt;
  if (!number || *number == 0) return std::nullopt;
  return static_cast<std::size_t>(*number);
}

/// Whether this is a list of lists of whole numbers.
bool holds_indices(const StepItem& list) {
  for (const StepItem inner : list) {
    for (const StepItem value : inner) return index_of(value).has_value();
    return false;
  }
  return false;
}

/// Another order of the points, if the record has one: PnIndex, which stands last.
std::optional<std::vector<std::size_t>> way_through(const StepItem& item) {
  std::vector<std::size_t> order;
  for (const StepItem value : item) {
    const auto index = index_of(value);
    if (!index) return std::nullopt;
    order.push_back(*index);
  }
  return order;
}

}  // namespace

bool FaceWriter::takes(const StepRecord& record) {
  return record.keyword == "IFCTRIANGULATEDFACESET" || record.keyword == "IFCPOLYGONALFACESET";
}

bool FaceWriter::write(const StepRecord& record) {
  const auto values = StepValues::read(record.arguments);
  if (!values) return false;
  const Points* points = points_of((*values)[0].reference());
  if (points == nullptr) return false;
  const bool triangulated = record.keyword == "IFCTRIANGULATEDFACESET";
  bool closed = false;
  StepItem faces_item;
  std::vector<std::size_t> through;
  // The order of the arguments is not the same in IFC 4 and 4.3; what each is can be told.
  bool found = false;
  for (const StepItem item : values->all()) {
    if (item.is_enumeration("T")) closed = true;
    const bool has_faces =
        triangulated ? holds_indices(item) : (*item.begin()).kind() == StepKind::reference;
    if (!found && item.kind() == StepKind::list && item.size() > 0 && has_faces) {
      faces_item = item;
      found = true;
    } else if (found && item.kind() == StepKind::list && item.size() > 0 &&
               item[0].kind() == StepKind::number) {
      const auto order = way_through(item);
      if (!order) return false;
      through = *order;
    }
  }
  Points faces;
  if (!found || !(triangulated ? triangles(faces_item, *points, through, faces)
                               : polygons(faces_item, *points, through, faces))) {
    return false;
  }
  const std::uint64_t shell = out_.add(
      fmt::format("{}(({}))", closed ? "IFCCLOSEDSHELL" : "IFCOPENSHELL", references_text(faces)));
  out_.put(record.id, closed ? fmt::format("IFCFACETEDBREP(#{})", shell)
                             : fmt::format("IFCSHELLBASEDSURFACEMODEL((#{}))", shell));
  return true;
}

const FaceWriter::Points* FaceWriter::points_of(std::uint64_t list) {
  const auto known = lists_.find(list);
  if (known != lists_.end()) return known->second.empty() ? nullptr : &known->second;
  Points& points = lists_[list];
  const StepRecord* record = file_.find(list);
  if (record == nullptr || record->keyword != "IFCCARTESIANPOINTLIST3D") return nullptr;
  const auto values = StepValues::read(record->arguments);
  if (!values) return nullptr;
  Points written;
  for (const StepItem each : (*values)[0]) {
    math::Vec3 p;
    int count = 0;
    for (const StepItem value : each) {
      const auto number = value.number();
      if (!number || count == 3) return nullptr;
      p[count++] = *number;
    }
    if (count != 3) return nullptr;
    written.push_back(out_.add_point(far_.moved(p).value_or(p), false));
  }
  points = std::move(written);
  return points.empty() ? nullptr : &points;
}

std::optional<std::uint64_t> FaceWriter::loop(const StepItem& indices, const Points& points,
                                              const std::vector<std::size_t>& through) {
  Points corners;
  for (const StepItem each : indices) {
    std::optional<std::size_t> index = index_of(each);
    if (index && !through.empty()) {
      index = *index <= through.size() ? std::optional(through[*index - 1]) : std::nullopt;
    }
    if (!index || *index > points.size()) return std::nullopt;
    corners.push_back(points[*index - 1]);
  }
  if (corners.size() < 3) return std::nullopt;
  return out_.add(fmt::format("IFCPOLYLOOP(({}))", references_text(corners)));
}

bool FaceWriter::triangles(const StepItem& list, const Points& points,
                           const std::vector<std::size_t>& through, Points& faces) {
  for (const StepItem each : list) {
    const auto outline = loop(each, points, through);
    if (!outline) return false;
    const std::uint64_t bound = out_.add(fmt::format("IFCFACEOUTERBOUND(#{},.T.)", *outline));
    faces.push_back(out_.add(fmt::format("IFCFACE((#{}))", bound)));
  }
  return true;
}

bool FaceWriter::polygons(const StepItem& list, const Points& points,
                          const std::vector<std::size_t>& through, Points& faces) {
  for (const StepItem each : list) {
    const StepRecord* face = file_.find(each.reference());
    if (face == nullptr || !face->keyword.starts_with("IFCINDEXEDPOLYGONALFACE")) return false;
    const auto values = StepValues::read(face->arguments);
    const auto outline = values ? loop((*values)[0], points, through) : std::nullopt;
    if (!outline) return false;
    std::string bounds =
        fmt::format("#{}", out_.add(fmt::format("IFCFACEOUTERBOUND(#{},.T.)", *outline)));
    for (const StepItem hole : (*values)[1]) {
      const auto inner = loop(hole, points, through);
      if (!inner) return false;
      bounds += fmt::format(",#{}", out_.add(fmt::format("IFCFACEBOUND(#{},.T.)", *inner)));
    }
    faces.push_back(out_.add(fmt::format("IFCFACE(({}))", bounds)));
  }
  return true;
}

}  // namespace rubicon::ifc
