#include "src/exchange/area_io/storey_floor.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "src/exchange/building_io/component_text.hpp"
#include "src/exchange/building_io/glob.hpp"
#include "src/exchange/building_io/names.hpp"
#include "src/motion/math/angles.hpp"
#include "src/motion/math/index.hpp"

namespace rubicon::area_io {

namespace {

using building_io::counted;
using building_io::Element;
using building_io::number_text;
using math::at;
using math::Vec3;

/// m: tops of slabs that differ by less belong to one floor.
constexpr double kSameHeight = 0.02;
/// m: a column whose foot is no higher over the floor stands on it, through bedding and plates; one
/// whose head is no higher only reaches it.
constexpr double kStands = 0.1;
/// m: a wall whose foot is this much below the surface goes through it.
constexpr double kThrough = 0.02;
/// m: a beam whose top is no farther below the surface carries the floor.
constexpr double kBelow = 0.6;
/// Triangles of all slabs and of what stands.
constexpr std::size_t kMostTriangles = 500'000;

double top_of(const Element& element) { return element.frame.origin.z() + element.frame.size.z(); }

class StoreyReader {
 public:
  StoreyReader(const building_io::Elements& elements, const StoreyTerms& terms,
               std::vector<std::string>& notes, interpreter::Diagnostics& diagnostics)
      : elements_(elements), terms_(terms), notes_(notes), diagnostics_(diagnostics) {}

  std::vector<ImportedArea> run() {
    if (!find_storey()) return {};
    std::vector<const Element*> slabs;
    for (const Element& each : elements_.all) {
      if (each.storey == storey_ && each.type.starts_with("IfcSlab")) slabs.push_back(&each);
    }
    if (slabs.empty()) {
      error(fmt::format("the storey '{}' has no IfcSlab", storey_),
            "give the model of its floor too: rubicon import FLOORS.ifc WALLS.ifc --area STOREY");
      return {};
    }
    std::stable_sort(slabs.begin(), slabs.end(),
                     [](const Element* a, const Element* b) { return top_of(*a) < top_of(*b); });
    std::vector<ImportedArea> areas;
    for (std::size_t first = 0; first < slabs.size();) {
      std::size_t last = first + 1;
      while (last < slabs.size() && top_of(*slabs[last]) - top_of(*slabs[last - 1]) < kSameHeight) {
        ++last;
      }
      add_floors({slabs.begin() + static_cast<std::ptrdiff_t>(first),
                  slabs.begin() + static_cast<std::ptrdiff_t>(last)},
                 areas);
      first = last;
    }
    for (const Element& each : elements_.all) {
      const auto found = outside_.find(&each);
      if (found == outside_.end() || inside_.contains(&each)) continue;
      if (told_.insert(found->second).second) notes_.push_back(found->second);
    }
    std::stable_sort(areas.begin(), areas.end(),
                     [](const auto& a, const auto& b) { return a.slab > b.slab; });
    if (areas.empty() && !diagnostics_.has_errors()) {
      error(fmt::format("the slabs of the storey '{}' cover no floor", storey_), "");
    }
    return areas;
  }

 private:
  void error(const std::string& message, const std::string& hint) {
    diagnostics_.error("I19", {}, message, hint);
  }

  bool find_storey() {
    std::set<std::string> all;
    for (const Element& each : elements_.all) {
      if (!each.storey.empty()) all.insert(each.storey);
    }
    if (all.empty()) {
      error("the model knows no storeys; --area needs an IFC model", "");
      return false;
    }
    std::vector<std::string> matching;
    for (const std::string& each : all) {
      if (each == terms_.storey) matching = {each};
      if (each == terms_.storey) break;
      if (building_io::matches_glob(terms_.storey, each)) matching.push_back(each);
    }
    if (matching.size() == 1) {
      storey_ = matching.front();
      return true;
    }
    error(fmt::format("{} '{}'; the model has '{}'",
                      matching.empty() ? "there is no storey" : "there are several storeys",
                      building_io::clean(terms_.storey), fmt::join(all, "', '")),
          "name it, or a part of it with *: --area \"01*\"");
    return false;
  }

  /// What of an element is seen from above.
  std::vector<Ring> shadow(const Element& element) {
    std::vector<Ring> rings;
    if (element.world == nullptr) return rings;
    const auto flat = [&](int vertex) {
      const Vec3 p = element.world->vertices[at(vertex)] - elements_.origin;
      return coverage::snap({p.x(), p.y()});
    };
    for (const auto& triangle : element.world->triangles) {
      Ring ring = {flat(triangle[0]), flat(triangle[1]), flat(triangle[2])};
      const std::int64_t area = coverage::twice_area(ring);
      if (area == 0) continue;
      if (area < 0) std::reverse(ring.begin(), ring.end());
      rings.push_back(std::move(ring));
    }
    triangles_ += rings.size();
    return rings;
  }

  bool is_in_reach(const Element& element) const {
    const Vec3 p = element.frame.origin - elements_.origin;
    const double size = element.frame.size.norm();
    return std::abs(p.x()) + size < coverage::kReach && std::abs(p.y()) + size < coverage::kReach;
  }

  void add_floors(const std::vector<const Element*>& slabs, std::vector<ImportedArea>& areas) {
    coverage::FloorParts parts;
    std::vector<const Element*> owners;  // of columns
    std::vector<Ring> rings;
    for (const Element* slab : slabs) {
      if (!is_in_reach(*slab)) {
        return error(fmt::format("IfcSlab {} lies more than {} m from the first element",
                                 building_io::remark_name(slab->name), coverage::kReach),
                     "");
      }
      for (Ring& ring : shadow(*slab)) rings.push_back(std::move(ring));
    }
    if (is_too_large()) return;
    const double top = top_of(*slabs.back());
    const double height = top - elements_.origin.z();
    parts.slabs = coverage::united(rings, coverage::in_units(terms_.tolerance));
    for (const Element& each : elements_.all) {
      if (!is_in_reach(each)) continue;
      const double foot = each.frame.origin.z();
      const bool column = each.type.starts_with("IfcColumn") && foot <= top + kStands;
      const bool wall = each.type.starts_with("IfcWall") && foot <= top - kThrough;
      if ((column || wall) && top_of(each) >= top + kStands) add_standing(each, parts);
      owners.resize(parts.columns.size(), &each);
      if (each.type.starts_with("IfcBeam") && top_of(each) <= top + kThrough &&
          top_of(each) >= top - kBelow) {
        add_beam(each, parts);
      }
    }
    if (is_too_large()) return;
    std::vector<std::string> notes;
    std::vector<std::size_t> outside;
    std::vector<coverage::MadeFloor> made = make_floors(parts, notes, outside);
    std::size_t next = 0;
    for (std::size_t i = 0; i < parts.columns.size(); ++i) {
      const bool is_outside = next < outside.size() && outside[next] == i;
      if (is_outside) ++next;
      // A storey of several floors: it is outside where it stands in none of them.
      const std::string text = text_of_outside(parts.columns[i]);
      (is_outside ? outside_ : inside_).emplace(owners[i], text);
    }
    for (const std::string& note : notes) {
      if (told_.insert(note).second) notes_.push_back(note);
    }
    notes_.push_back(fmt::format("{} of the storey '{}' at {} m: {}", counted(slabs.size(), "slab"),
                                 storey_, number_text(height), counted(made.size(), "area")));
    for (coverage::MadeFloor& each : made) {
      areas.push_back({height, std::move(each.floor), each.slab});
    }
  }

  bool is_too_large() {
    if (triangles_ <= kMostTriangles) return false;
    if (!diagnostics_.has_errors()) {
      error(fmt::format("the floor and what stands on it have more than {} triangles",
                        kMostTriangles),
            "");
    }
    return true;
  }

  void add_standing(const Element& element, coverage::FloorParts& parts) {
    // The hollows of a profile fill with it: what is enclosed is not floor.
    std::string name = element.name.empty() ? element.type : element.name;
    for (Region& region : coverage::united(shadow(element))) {
      parts.columns.push_back(coverage::standing_of(name, std::move(region.outline)));
      if (element.type.starts_with("IfcWall")) parts.columns.back().kind = "wall";
    }
  }

  /// The middle line along the longer side.
  void add_beam(const Element& element, coverage::FloorParts& parts) const {
    const Vec3 p = element.frame.origin - elements_.origin;
    const double half = element.frame.size.x() / 2;
    const double x = half * math::cos_deg(element.frame.turn_deg);
    const double y = half * math::sin_deg(element.frame.turn_deg);
    parts.beams.push_back({element.name, {p.x() - x, p.y() - y}, {p.x() + x, p.y() + y}});
  }

  const building_io::Elements& elements_;
  const StoreyTerms& terms_;
  std::vector<std::string>& notes_;
  interpreter::Diagnostics& diagnostics_;
  std::string storey_;
  std::set<std::string> told_;
  std::map<const Element*, std::string> outside_, inside_;  ///< of a floor
  std::size_t triangles_ = 0;
};

}  // namespace

std::vector<ImportedArea> floors_of_storey(const building_io::Elements& elements,
                                           const StoreyTerms& terms,
                                           std::vector<std::string>& notes,
                                           interpreter::Diagnostics& diagnostics) {
  return StoreyReader(elements, terms, notes, diagnostics).run();
}

}  // namespace rubicon::area_io
