#include "src/exchange/ifc/shape_reader.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "src/exchange/ifc/body_items.hpp"
#include "src/exchange/ifc/chords.hpp"
#include "src/exchange/ifc/face_shells.hpp"
#include "src/exchange/ifc/ifc_placement.hpp"
#include "src/exchange/ifc/primitive_solids.hpp"
#include "src/exchange/ifc/profile_regions.hpp"
#include "src/exchange/ifc/step_values.hpp"
#include "src/exchange/ifc/swept_solids.hpp"
#include "src/motion/math/angles.hpp"

namespace rubicon::ifc {

namespace {

using math::Pose;
using math::Vec3;

/// One of two operands of a chain of booleans: the rest hangs on the first.
constexpr std::size_t kFirstOperand = 1;
constexpr std::size_t kSecondOperand = 2;

bool is_boolean(const StepRecord& record) {
  return record.keyword == "IFCBOOLEANRESULT" || record.keyword == "IFCBOOLEANCLIPPINGRESULT";
}

/// IfcAxis1Placement.
std::optional<Axis> axis_of(const StepFile& file, std::uint64_t id) {
  const StepRecord* record = file.find(id);
  if (record == nullptr || record->keyword != "IFCAXIS1PLACEMENT") return std::nullopt;
  const auto values = StepValues::read(record->arguments);
  const auto point = values ? cartesian_point(file, (*values)[0].reference()) : std::nullopt;
  if (!point) return std::nullopt;
  return Axis{*point, unit_direction(file, (*values)[1].reference()).value_or(Vec3(Vec3::UnitZ()))};
}

/// A body with as many of the cuts as could be made.
struct CutBody {
  Solid solid;
  std::vector<std::size_t> missing;  ///< cuts
};

/// Nothing if not even what is left can be made a surface of. That has a budget of its own, `rest`:
/// what could be cut is used, also where the budget was not enough for all.
std::optional<CutBody> try_cuts(const Solid& body, const std::vector<BodyCut>& cuts, bool apart,
                                bool fill_now, WorkBudget& budget, WorkBudget& rest) {
  std::optional<FaceSolid> faces = FaceSolid::of(body, apart, budget);
  if (!faces) return std::nullopt;
  CutBody result;
  for (std::size_t i = 0; i < cuts.size() && !faces->is_empty(); ++i) {
    const std::vector<Cell>& cells = cuts[i].cells;
    std::optional<FaceSolid> before;
    // One cell that fails changes nothing.
    if (cells.size() > 1 && budget.spend(faces->corners())) before = faces;
    const bool done = std::all_of(cells.begin(), cells.end(), [&](const Cell& cell) {
      return faces->is_empty() || faces->subtract(cell, fill_now, budget);
    });
    if (done) continue;
    result.missing.push_back(i);
    if (before) faces = std::move(before);
  }
  if (!faces->is_changed()) {
    result.solid = body;
    return result;
  }
  auto solid = faces->triangles(rest);
  if (!solid) return std::nullopt;
  result.solid = std::move(*solid);
  return result;
}

/// Cuts that leave borders which cross are found when triangles are made: then it is done again,
/// and each cut looked at by itself; and again with triangles for faces.
CutBody cut_body(const Solid& body, const std::vector<BodyCut>& cuts, WorkBudget& budget) {
  CutBody best{body, {}};
  for (std::size_t i = 0; i < cuts.size(); ++i) best.missing.push_back(i);
  if (best.missing.empty()) return best;
  const Solid whole = welded(body);
  if (!is_closed(whole)) return best;
  constexpr std::array<std::array<bool, 2>, 3> kWays{{{false, false}, {false, true}, {true, true}}};
  for (const auto& [apart, fill_now] : kWays) {
    WorkBudget share = budget.share(kMostCutSteps);
    WorkBudget rest = share;
    auto cut = try_cuts(whole, cuts, apart, fill_now, share, rest);
    budget.spend(share.used() + rest.used());
    if (cut && cut->missing.size() < best.missing.size()) best = std::move(*cut);
    if (best.missing.empty() || share.is_spent() || rest.is_spent()) break;
  }
  return best;
}

/// The cells of intersections: bodies that touch.
bool keep_common(Bodies& bodies, const std::vector<Cell>& cells, WorkBudget& budget) {
  std::vector<Solid> common;
  for (const Solid& body : bodies.solids) {
    if (!is_closed(body)) return false;
    WorkBudget share = budget.share(kMostCutSteps);
    for (const Cell& cell : cells) {
      auto part = intersect(body, cell, share);
      budget.spend(part ? 0 : share.used());
      if (!part) return false;
      if (!part->triangles.empty()) common.push_back(std::move(*part));
    }
    budget.spend(share.used());
  }
  bodies.solids = std::move(common);
  return true;
}

}  // namespace

void transform(const math::Mat3& linear, const Vec3& translation, std::vector<Solid>& solids) {
  const bool mirrored = linear.determinant() < 0;
  for (Solid& solid : solids) {
    for (Vec3& p : solid.points) p = linear * p + translation;
    if (!mirrored) continue;
    for (auto& t : solid.triangles) std::swap(t[1], t[2]);
  }
}

void cut_bodies(Bodies& bodies, const std::vector<BodyCut>& cuts, WorkBudget& budget) {
  std::vector<Solid> left;
  std::set<std::size_t> missing;
  for (Solid& body : bodies.solids) {
    CutBody cut = cut_body(body, cuts, budget);
    missing.insert(cut.missing.begin(), cut.missing.end());
    if (!cut.solid.triangles.empty()) left.push_back(std::move(cut.solid));
  }
  bodies.solids = std::move(left);
  for (const std::size_t i : missing) bodies.notes.push_back(cuts[i].what + " is not cut out");
}

std::optional<std::vector<Cell>> cells_of(const Bodies& bodies, WorkBudget& budget) {
  std::vector<Cell> all;
  for (const Solid& each : bodies.solids) {
    const Solid body = welded(each);
    if (!is_closed(body)) return std::nullopt;
    WorkBudget share = budget.share(kMostCutSteps);
    const auto cells = convex_cells(body, share);
    budget.spend(share.used());
    if (!cells) return std::nullopt;
    all.insert(all.end(), cells->begin(), cells->end());
  }
  return all;
}

std::optional<Bodies> ShapeReader::read(std::uint64_t shape) {
  for (const std::uint64_t id : body_representations(terms_.file, shape)) {
    Bodies bodies;
    if (read_representation(id, 0, bodies)) return bodies;
  }
  return std::nullopt;
}

bool ShapeReader::read_representation(std::uint64_t id, int depth, Bodies& out) {
  bool any = false;
  for (const std::uint64_t item : representation_items(terms_.file, id)) {
    if (!may_be_body(terms_.file, item)) continue;
    // A part of a thing is not the thing.
    if (!read_item(item, depth, out)) return false;
    any = true;
  }
  return any;
}

bool ShapeReader::read_item(std::uint64_t id, int depth, Bodies& out) {
  const StepRecord* record = terms_.file.find(id);
  // What leads in a ring, or branches without end, comes to the end of its budget. The records of
  // an item are read anew each time it is used: that costs about as much as twenty triangles.
  constexpr std::uint64_t kStepsPerItem = 4'000;
  if (record == nullptr || depth > kDeepestShape || !terms_.budget.spend(kStepsPerItem)) {
    return false;
  }
  if (is_faces(*record)) return put(solid_of_faces(terms_, *record), out);
  if (is_boolean(*record)) return read_boolean(*record, depth, out);
  if (record->keyword == "IFCMAPPEDITEM") return read_mapped(*record, depth, out);
  if (record->keyword == "IFCCSGSOLID") {
    const auto values = StepValues::read(record->arguments);
    return values && read_item((*values)[0].reference(), depth + 1, out);
  }
  if (record->keyword.ends_with("AREASOLID")) return read_swept(*record, out);
  if (record->keyword.starts_with("IFCSWEPTDISKSOLID")) return read_disk(*record, out);
  return put(primitive_solid(terms_.file, *record, terms_.metres_per_unit, terms_.budget), out);
}

/// Adds a solid in the units of the file.
bool ShapeReader::put(std::optional<Solid> solid, Bodies& out) const {
  // Bodies cost memory: this bounds how many there can be.
  constexpr std::uint64_t kStepsPerTriangle = 200;
  if (!solid || solid->triangles.empty() ||
      !terms_.budget.spend(kStepsPerTriangle * solid->triangles.size())) {
    return false;
  }
  for (Vec3& p : solid->points) {
    p *= terms_.metres_per_unit;
    if (!p.allFinite()) return false;
  }
  out.solids.push_back(std::move(*solid));
  return true;
}

bool ShapeReader::read_mapped(const StepRecord& record, int depth, Bodies& out) {
  const auto values = StepValues::read(record.arguments);
  const StepRecord* map = values ? terms_.file.find((*values)[0].reference()) : nullptr;
  if (map == nullptr || map->keyword != "IFCREPRESENTATIONMAP") return false;
  const auto source = StepValues::read(map->arguments);
  if (!source) return false;
  const auto origin = axis_placement(terms_.file, (*source)[0].reference());
  const auto target = transformation(terms_.file, (*values)[1].reference());
  if (!origin || !target) return false;
  Bodies mapped;
  if (!read_representation((*source)[1].reference(), depth + 1, mapped)) return false;
  const Transformation all = *target * *origin;
  transform(all.linear(), all.translation() * terms_.metres_per_unit, mapped.solids);
  for (Solid& solid : mapped.solids) out.solids.push_back(std::move(solid));
  out.notes.insert(out.notes.end(), mapped.notes.begin(), mapped.notes.end());
  return true;
}

/// A chain of booleans hangs on the first operand, step below step: no recursion along it.
bool ShapeReader::read_boolean(const StepRecord& record, int depth, Bodies& out) {
  std::vector<StepValues> chain;
  const StepRecord* at = &record;
  while (at != nullptr && is_boolean(*at)) {
    auto values = StepValues::read(at->arguments);
    if (!values || !terms_.budget.spend(10)) return false;
    chain.push_back(std::move(*values));
    if (chain.size() > kLongestChain) return false;
    at = terms_.file.find(chain.back()[kFirstOperand].reference());
  }
  Bodies bodies;
  std::vector<BodyCut> cuts;
  const auto cut = [&] {
    cut_bodies(bodies, cuts, terms_.budget);
    cuts.clear();
  };
  const int below = depth + 1;
  if (at == nullptr || !read_item(at->id, below, bodies)) return false;
  for (; !chain.empty(); chain.pop_back()) {
    const StepItem kind = chain.back()[0];
    const std::uint64_t second = chain.back()[kSecondOperand].reference();
    if (kind.is_enumeration("UNION")) {
      cut();
      if (!read_item(second, below, bodies)) return false;
      continue;
    }
    const auto cells = cutter(second, below, bodies, bodies);
    const bool common = kind.is_enumeration("INTERSECTION");
    if (common) cut();
    if (common && (!cells || !keep_common(bodies, *cells, terms_.budget))) return false;
    if (!common && !cells) {
      bodies.notes.emplace_back("what is to be cut off cannot be read: nothing is cut off");
    } else if (!common) {
      cuts.push_back({*cells, "what a boolean result takes away"});
    }
  }
  cut();
  for (Solid& solid : bodies.solids) out.solids.push_back(std::move(solid));
  out.notes.insert(out.notes.end(), bodies.notes.begin(), bodies.notes.end());
  return true;
}

/// What the second operand of a boolean fills; `first` is what it is combined with.
std::optional<std::vector<Cell>> ShapeReader::cutter(std::uint64_t id, int depth,
                                                     const Bodies& first, Bodies& notes) {
  const StepRecord* record = terms_.file.find(id);
  if (record == nullptr) return std::nullopt;
  if (record->keyword == "IFCHALFSPACESOLID" || record->keyword == "IFCBOXEDHALFSPACE" ||
      record->keyword == "IFCPOLYGONALBOUNDEDHALFSPACE") {
    return half_space(*record, first);
  }
  Bodies second;
  if (!read_item(id, depth + 1, second)) return std::nullopt;
  notes.notes.insert(notes.notes.end(), second.notes.begin(), second.notes.end());
  return cells_of(second, terms_.budget);
}

std::optional<std::vector<Cell>> ShapeReader::half_space(const StepRecord& record,
                                                         const Bodies& first) {
  const auto values = StepValues::read(record.arguments);
  const StepRecord* surface = values ? terms_.file.find((*values)[0].reference()) : nullptr;
  if (surface == nullptr || surface->keyword != "IFCPLANE") return std::nullopt;
  const auto plane = StepValues::read(surface->arguments);
  auto X = plane ? axis_placement(terms_.file, (*plane)[0].reference()) : std::nullopt;
  if (!X) return std::nullopt;
  X->translation() *= terms_.metres_per_unit;
  const Vec3 z = X->linear().col(2);
  const Vec3 n = (*values)[1].is_enumeration("F") ? Vec3(-z) : z;
  const HalfSpace half{n, n.dot(X->translation())};
  if (record.keyword != "IFCPOLYGONALBOUNDEDHALFSPACE") return std::vector<Cell>{{half}};

  // A prism along z of its own position that reaches past all there is to cut.
  auto X_bound = axis_placement(terms_.file, (*values)[2].reference());
  const auto line = curve_points(terms_, (*values)[3].reference());
  if (!X_bound || !line) return std::nullopt;
  X_bound->translation() *= terms_.metres_per_unit;
  double reach = 1;
  for (const Solid& solid : first.solids) {
    for (const Vec3& p : solid.points) {
      reach = std::max(reach, 1 + (p - X_bound->translation()).norm());
    }
  }
  Region region;
  for (const Vec3& p : line->points) {
    const Vec3 q(p.x() * terms_.metres_per_unit, p.y() * terms_.metres_per_unit, -reach);
    if (region.outline.empty() || (q - region.outline.back()).norm() > kOnPlane) {
      region.outline.push_back(q);
    }
  }
  while (region.outline.size() > 1 &&
         (region.outline.back() - region.outline.front()).norm() <= kOnPlane) {
    region.outline.pop_back();
  }
  auto prism = extruded(region, {0, 0, 2 * reach}, terms_.budget);
  if (!prism) return std::nullopt;
  for (Vec3& p : prism->points) p = *X_bound * p;
  auto cells = convex_cells(*prism, terms_.budget);
  if (!cells) return std::nullopt;
  for (Cell& cell : *cells) cell.push_back(half);
  return cells;
}

bool ShapeReader::read_swept(const StepRecord& record, Bodies& out) {
  const auto values = StepValues::read(record.arguments);
  if (!values) return false;
  const bool turned = record.keyword == "IFCREVOLVEDAREASOLID";
  if (!turned && record.keyword != "IFCEXTRUDEDAREASOLID") return false;
  const auto regions = profile_regions(terms_, (*values)[0].reference());
  const auto X = (*values)[1].is_set() ? axis_placement(terms_.file, (*values)[1].reference())
                                       : std::optional<Pose>(Pose::Identity());
  const auto measure = (*values)[3].number();
  if (!regions || !X || !measure) return false;
  const auto way = unit_direction(terms_.file, (*values)[2].reference());
  const auto axis = axis_of(terms_.file, (*values)[2].reference());
  if (turned ? !axis.has_value() : !way.has_value()) return false;
  for (const Region& region : *regions) {
    auto solid = turned ? revolved(region, *axis, math::degrees(*measure * terms_.radians_per_unit),
                                   terms_.metres_per_unit, terms_.budget)
                        : extruded(region, *measure * *way, terms_.budget);
    if (!solid) return false;
    for (Vec3& p : solid->points) p = *X * p;
    if (!put(std::move(solid), out)) return false;
  }
  return !regions->empty();
}

bool ShapeReader::read_disk(const StepRecord& record, Bodies& out) {
  const auto values = StepValues::read(record.arguments);
  if (!values) return false;
  const auto line = curve_points(terms_, (*values)[0].reference());
  const auto radius = (*values)[1].number();
  if (!line || !radius) return false;
  std::vector<Vec3> path = line->points;
  // IfcSweptDiskSolidPolygonal rounds the corners of its line.
  constexpr std::size_t kFillet = 5;
  if (record.keyword.ends_with("POLYGONAL") && (*values)[kFillet].number()) {
    path = rounded_line(path, *(*values)[kFillet].number(), terms_.metres_per_unit);
  }
  return put(swept_disk(path, *radius, (*values)[2].number().value_or(0), terms_.metres_per_unit,
                        terms_.budget),
             out);
}

}  // namespace rubicon::ifc
