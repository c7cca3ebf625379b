#include "src/exchange/ifc/shape_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "src/exchange/ifc/body_items.hpp"
#include "src/exchange/ifc/ifc_curve.hpp"
#include "src/exchange/ifc/ifc_placement.hpp"
#include "src/exchange/ifc/ifc_profile.hpp"

namespace rubicon::ifc {

namespace {

/// Classes of geometry that are taken over as they stand: known to IFC 2x3 and to the library.
/// Sorted.
constexpr auto kPlain =
    std::to_array<std::string_view>({"IFCARBITRARYCLOSEDPROFILEDEF",
                                     "IFCARBITRARYOPENPROFILEDEF",
                                     "IFCARBITRARYPROFILEDEFWITHVOIDS",
                                     "IFCAXIS1PLACEMENT",
                                     "IFCAXIS2PLACEMENT2D",
                                     "IFCAXIS2PLACEMENT3D",
                                     "IFCBOOLEANCLIPPINGRESULT",
                                     "IFCBOOLEANRESULT",
                                     "IFCBOUNDEDCURVE",
                                     "IFCCARTESIANPOINT",
                                     "IFCCARTESIANTRANSFORMATIONOPERATOR3D",
                                     "IFCCARTESIANTRANSFORMATIONOPERATOR3DNONUNIFORM",
                                     "IFCCENTERLINEPROFILEDEF",
                                     "IFCCIRCLE",
                                     "IFCCIRCLEHOLLOWPROFILEDEF",
                                     "IFCCIRCLEPROFILEDEF",
                                     "IFCCLOSEDSHELL",
                                     "IFCCOMPOSITECURVE",
                                     "IFCCOMPOSITECURVESEGMENT",
                                     "IFCCONNECTEDFACESET",
                                     "IFCDIRECTION",
                                     "IFCELLIPSE",
                                     "IFCEXTRUDEDAREASOLID",
                                     "IFCFACE",
                                     "IFCFACEBASEDSURFACEMODEL",
                                     "IFCFACEBOUND",
                                     "IFCFACEOUTERBOUND",
                                     "IFCFACETEDBREP",
                                     "IFCFACETEDBREPWITHVOIDS",
                                     "IFCHALFSPACESOLID",
                                     "IFCISHAPEPROFILEDEF",
                                     "IFCLINE",
                                     "IFCMAPPEDITEM",
                                     "IFCOPENSHELL",
                                     "IFCPLANE",
                                     "IFCPOLYGONALBOUNDEDHALFSPACE",
                                     "IFCPOLYLINE",
                                     "IFCPOLYLOOP",
                                     "IFCRECTANGLEHOLLOWPROFILEDEF",
                                     "IFCRECTANGLEPROFILEDEF",
                                     "IFCREPRESENTATIONMAP",
                                     "IFCREVOLVEDAREASOLID",
                                     "IFCROUNDEDRECTANGLEPROFILEDEF",
                                     "IFCSHELLBASEDSURFACEMODEL",
                                     "IFCSWEPTDISKSOLID",
                                     "IFCTRIMMEDCURVE",
                                     "IFCVECTOR"});
static_assert(std::is_sorted(kPlain.begin(), kPlain.end()));

bool is_real(std::string_view number) { return number.find('.') != std::string_view::npos; }

bool is_plain(std::string_view keyword) {
  return std::binary_search(kPlain.begin(), kPlain.end(), keyword);
}

bool is_coordinates(std::string_view keyword) {
  return keyword == "IFCCARTESIANPOINT" || keyword == "IFCDIRECTION";
}

}  // namespace

ShapeWriter::ShapeWriter(const StepFile& file, double metres_per_unit, const FarPoints& far,
                         RecordWriter& out)
    : file_(file), metres_per_unit_(metres_per_unit), far_(far), out_(out), faces_(file, far, out) {
  origin_ = out_.add_placement(math::Pose::Identity());
  const auto point = out_.add_point(math::Vec3::Zero(), true);
  flat_origin_ = out_.add(fmt::format("IFCAXIS2PLACEMENT2D(#{},$)", point));
  context_ =
      out_.add(fmt::format("IFCGEOMETRICREPRESENTATIONCONTEXT($,'Model',3,1.E-5,#{},$)", origin_));
}

std::uint64_t ShapeWriter::write(std::uint64_t shape) {
  for (const std::uint64_t each : body_representations(file_, shape)) {
    if (keep(each)) return out_.add(fmt::format("IFCPRODUCTDEFINITIONSHAPE($,$,(#{}))", each));
  }
  return 0;
}

/// Writes a record of geometry with all below it; whether that could be done. No recursion: the
/// file chooses how deep it is.
bool ShapeWriter::keep(std::uint64_t root) {
  std::vector<std::pair<std::uint64_t, bool>> stack{{root, false}};
  while (!stack.empty()) {
    const auto [id, children_done] = stack.back();
    stack.pop_back();
    const StepRecord* record = file_.find(id);
    if (children_done) {
      state_[id] = write_record(*record) ? State::kept : State::dropped;
      continue;
    }
    if (state_.contains(id)) continue;
    if (record == nullptr) {
      state_[id] = State::dropped;
      continue;
    }
    state_[id] = State::open;
    stack.emplace_back(id, true);
    for (const std::uint64_t child : needs(*record)) stack.emplace_back(child, false);
  }
  return state_[root] == State::kept;
}

/// What must be written before a record can be.
std::vector<std::uint64_t> ShapeWriter::needs(const StepRecord& record) const {
  const bool representation = record.keyword == "IFCSHAPEREPRESENTATION";
  if (!representation && !is_plain(record.keyword)) return {};
  if (representation) return representation_items(file_, record.id);
  const auto values = StepValues::read(record.arguments);
  if (!values) return {};
  return values->references();
}

bool ShapeWriter::is_kept(std::uint64_t id) const {
  const auto found = state_.find(id);
  return found != state_.end() && found->second == State::kept;
}

bool ShapeWriter::write_record(const StepRecord& record) {
  if (FaceWriter::takes(record)) return faces_.write(record);
  if (record.keyword == "IFCINDEXEDPOLYCURVE") return write_curve(record);
  if (record.keyword == "IFCSHAPEREPRESENTATION") return write_representation(record);
  if (is_plain(record.keyword)) return write_plain(record);
  return write_profile(record);
}

bool ShapeWriter::write_representation(const StepRecord& record) {
  std::vector<std::uint64_t> items;
  for (const std::uint64_t id : representation_items(file_, record.id)) {
    if (is_kept(id)) {
      items.push_back(id);
    } else if (may_be_body(file_, id)) {
      return false;  // a part of a thing is not the thing
    }
  }
  if (items.empty()) return false;
  out_.put(record.id, fmt::format("IFCSHAPEREPRESENTATION(#{},'Body','Body',({}))", context_,
                                  references_text(items)));
  return true;
}

bool ShapeWriter::write_curve(const StepRecord& record) {
  const std::optional<PointLine> line = indexed_curve(file_, record, metres_per_unit_);
  if (!line) return false;
  std::vector<std::uint64_t> points;
  for (const math::Vec3& p : line->points) {
    const bool move = !line->flat && far_.moved(p);
    points.push_back(out_.add_point(move ? *far_.moved(p) : p, line->flat));
  }
  out_.put(record.id, fmt::format("IFCPOLYLINE(({}))", references_text(points)));
  return true;
}

bool ShapeWriter::write_profile(const StepRecord& record) {
  const std::optional<Region> region = measured_profile(file_, record, metres_per_unit_);
  if (!region) return false;
  std::vector<std::uint64_t> points;
  for (const math::Vec3& p : region->outline) points.push_back(out_.add_point(p, true));
  points.push_back(points.front());
  const auto line = out_.add(fmt::format("IFCPOLYLINE(({}))", references_text(points)));
  out_.put(record.id, fmt::format("IFCARBITRARYCLOSEDPROFILEDEF(.AREA.,$,#{})", line));
  return true;
}

bool ShapeWriter::write_plain(const StepRecord& record) {
  const auto values = StepValues::read(record.arguments);
  if (!values) return false;
  if (record.keyword == "IFCCARTESIANPOINT" && write_far_point(record.id, (*values)[0])) {
    return true;
  }
  std::string body(record.keyword);
  body += '(';
  std::size_t index = 0;
  for (const StepItem item : values->all()) {
    if (index > 0) body += ',';
    if (!item.is_set() && stand_in(record.keyword, index) != 0) {
      body += fmt::format("#{}", stand_in(record.keyword, index));
    } else if (!write_value(item, is_coordinates(record.keyword), body)) {
      return false;
    }
    ++index;
  }
  out_.put(record.id, body + ")");
  return true;
}

/// Writes a point that is moved because it lies far out; false if it is not one.
bool ShapeWriter::write_far_point(std::uint64_t id, const StepItem& coordinates) {
  const auto p = cartesian_point(file_, id);
  if (!p || coordinates.size() != 3 || !far_.moved(*p)) return false;
  const math::Vec3 q = *far_.moved(*p);
  out_.put(id, fmt::format("IFCCARTESIANPOINT(({},{},{}))", real_text(q.x()), real_text(q.y()),
                           real_text(q.z())));
  return true;
}

/// What stands for a position that IFC 4 lets one leave out; 0: nothing does.
std::uint64_t ShapeWriter::stand_in(std::string_view keyword, std::size_t index) const {
  if (index == 1 && keyword.ends_with("AREASOLID")) return origin_;
  const bool outline = keyword.starts_with("IFCARBITRARY") ||
                       keyword == "IFCCENTERLINEPROFILEDEF" || !keyword.ends_with("PROFILEDEF");
  return index == 2 && !outline ? flat_origin_ : 0;
}

/// Adds a value as it stands; false if it names a record that is not written.
bool ShapeWriter::write_value(const StepItem& item, bool reals, std::string& out) const {
  switch (item.kind()) {
    case StepKind::unset:
    case StepKind::derived:
      out += item.kind() == StepKind::unset ? '$' : '*';
      return true;
    case StepKind::number:
      if (!item.number()) return false;
      // The library takes a number without a point for a whole one, and where it wants none for
      // a mistake.
      out += reals && !is_real(item.text()) ? real_text(*item.number()) : std::string(item.text());
      return true;
    case StepKind::enumeration:
      out += fmt::format(".{}.", item.text());
      return true;
    case StepKind::text:
    case StepKind::binary:
      out += "''";  // names of profiles: nobody asks for them
      return true;
    case StepKind::reference:
      out += fmt::format("#{}", item.reference());
      return is_kept(item.reference());
    case StepKind::list:
    case StepKind::typed:
      break;
  }
  out += item.text();
  out += '(';
  bool first = true;
  for (const StepItem each : item) {
    if (!first) out += ',';
    first = false;
    if (!write_value(each, reals, out)) return false;
  }
  out += ')';
  return true;
}

}  // namespace rubicon::ifc
