#include "src/exchange/ifc/element_bodies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include "src/exchange/ifc/ifc_placement.hpp"
#include "src/exchange/ifc/ifc_units.hpp"
#include "src/exchange/ifc/shape_reader.hpp"
#include "src/exchange/ifc/step_values.hpp"

namespace rubicon::ifc {

namespace {

/// Elements in which more bodies than these meet others, such as cages of bars, are taken as they
/// are.
constexpr std::size_t kMostTakenApart = 100;
/// And those of more bodies than these, of which each would be looked at beside all others.
constexpr std::size_t kMostBodies = 2000;

class BodyReader {
 public:
  BodyReader(const StepFile& file, const IfcModel& model, WorkBudget& budget)
      : file_(file),
        model_(model),
        budget_(budget),
        terms_{file, model.metres_per_unit, radians_per_unit(file), budget_},
        shapes_(terms_),
        placements_(file) {
    for (const IfcOpening& opening : model.openings) {
      openings_[opening.element].push_back(opening.id);
    }
    for (const IfcOpening& each : model.projections) projections_[each.element].push_back(each.id);
  }

  std::optional<ElementBody> read(const IfcElement& element) {
    if (!element.X_WE) return std::nullopt;
    std::optional<Bodies> bodies = shapes_.read(element.shape);
    if (!bodies) return std::nullopt;
    const auto openings = openings_.find(element.id);
    if (openings != openings_.end()) cut_openings(element, openings->second, *bodies);
    const auto projections = projections_.find(element.id);
    if (projections != projections_.end()) {
      for (const std::uint64_t id : projections->second) add_projection(element, id, *bodies);
    }
    take_apart(*bodies);
    ElementBody result;
    for (const Solid& solid : bodies->solids) append(solid, result.solid);
    std::sort(bodies->notes.begin(), bodies->notes.end());
    bodies->notes.erase(std::unique(bodies->notes.begin(), bodies->notes.end()),
                        bodies->notes.end());
    result.notes = std::move(bodies->notes);
    return result;
  }

 private:
  static void append(const Solid& solid, Solid& to) {
    const auto base = static_cast<int>(to.points.size());
    to.points.insert(to.points.end(), solid.points.begin(), solid.points.end());
    for (const auto& t : solid.triangles) {
      to.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
    }
  }

  static std::uint64_t shape_of(const StepRecord& record) {
    constexpr std::size_t kShape = 6;
    const auto values = StepValues::read(record.arguments);
    return values ? (*values)[kShape].reference() : 0;
  }

  /// The bodies of another product in the frame of the element; nothing if they cannot be read.
  std::optional<Bodies> in_frame_of(const IfcElement& element, std::uint64_t id,
                                    std::uint64_t shape) {
    const auto X_WE = placements_.of_product(element.id);
    const auto X_WO = placements_.of_product(id);
    std::optional<Bodies> bodies = shapes_.read(shape);
    if (!bodies || !X_WE || !X_WO) return std::nullopt;
    const math::Pose X_EO = X_WE->inverse(Eigen::Isometry) * *X_WO;
    transform(X_EO.linear(), X_EO.translation() * model_.metres_per_unit, bodies->solids);
    return bodies;
  }

  void cut_openings(const IfcElement& element, const std::vector<std::uint64_t>& openings,
                    Bodies& bodies) {
    std::vector<BodyCut> cuts;
    for (const std::uint64_t id : openings) {
      const StepRecord* record = file_.find(id);
      const std::uint64_t shape = record == nullptr ? 0 : shape_of(*record);
      if (shape == 0) continue;  // an opening without a shape takes nothing away
      const std::optional<Bodies> hole = in_frame_of(element, id, shape);
      std::optional<std::vector<Cell>> cells = hole ? cells_of(*hole, budget_) : std::nullopt;
      if (cells) {
        cuts.push_back({std::move(*cells), "an opening"});
      } else {
        bodies.notes.emplace_back("an opening cannot be read and is not cut out");
      }
    }
    cut_bodies(bodies, cuts, budget_);
  }

  /// Adds what projects from the element, but for what the element fills already.
  void add_projection(const IfcElement& element, std::uint64_t id, Bodies& bodies) {
    const StepRecord* record = file_.find(id);
    const std::uint64_t shape = record == nullptr ? 0 : shape_of(*record);
    if (shape == 0) return;
    std::optional<Bodies> more = in_frame_of(element, id, shape);
    if (!more) {
      bodies.notes.emplace_back("a projection cannot be read and is missing");
      return;
    }
    Bodies met;
    for (const Solid& solid : bodies.solids) {
      const Box box = box_of(solid);
      const bool meets = std::any_of(more->solids.begin(), more->solids.end(),
                                     [&](const Solid& each) { return overlap(box, box_of(each)); });
      if (meets) met.solids.push_back(solid);
    }
    take_away(met, *more, "the part of a projection that is inside of it");
    for (Solid& solid : more->solids) bodies.solids.push_back(std::move(solid));
    bodies.notes.insert(bodies.notes.end(), more->notes.begin(), more->notes.end());
  }

  /// Takes from each body what those before it fill already: an L of two walls has its corner once.
  void take_apart(Bodies& bodies) {
    const std::size_t met_bodies = count_of_met(bodies);
    if (met_bodies == 0) return;
    if (met_bodies > kMostTakenApart) {
      bodies.notes.push_back(
          fmt::format("{} of its bodies may overlap: what they have in common counts more than "
                      "once in volume and mass",
                      met_bodies));
      return;
    }
    Bodies apart;
    std::vector<Box> boxes;
    for (Solid& solid : bodies.solids) {
      const Box box = box_of(solid);
      Bodies met;
      for (std::size_t i = 0; i < apart.solids.size(); ++i) {
        if (overlap(box, boxes[i])) met.solids.push_back(apart.solids[i]);
      }
      Bodies left{{std::move(solid)}, {}};
      // What is open has no volume.
      const bool closed = std::all_of(met.solids.begin(), met.solids.end(),
                                      [](const Solid& each) { return is_closed(welded(each)); });
      if (!met.solids.empty() && closed) {
        take_away(met, left, "what two of its bodies may have in common");
      }
      for (Solid& each : left.solids) {
        boxes.push_back(box_of(each));
        apart.solids.push_back(std::move(each));
      }
      bodies.notes.insert(bodies.notes.end(), left.notes.begin(), left.notes.end());
    }
    bodies.solids = std::move(apart.solids);
  }

  /// Bodies that may have something in common with others; all of them where they are too many.
  static std::size_t count_of_met(const Bodies& bodies) {
    const std::size_t all = bodies.solids.size();
    if (all > kMostBodies) return all;
    std::vector<Box> boxes;
    for (const Solid& solid : bodies.solids) boxes.push_back(box_of(solid));
    std::size_t count = 0;
    for (std::size_t i = 0; i < all; ++i) {
      for (std::size_t j = 0; j < all; ++j) {
        if (i == j || !overlap(boxes[i], boxes[j])) continue;
        ++count;
        break;
      }
    }
    return count;
  }

  /// Takes `met` from other bodies; `what` they lose.
  void take_away(const Bodies& met, Bodies& from, const std::string& what) {
    std::optional<std::vector<Cell>> cells = cells_of(met, budget_);
    if (cells) {
      cut_bodies(from, {{std::move(*cells), what}}, budget_);
    } else {
      from.notes.push_back(what + " counts twice");
    }
  }

  struct Box {
    math::Vec3 low = math::Vec3::Constant(std::numeric_limits<double>::infinity());
    math::Vec3 high = -low;
  };

  static Box box_of(const Solid& solid) {
    Box box;
    for (const math::Vec3& p : solid.points) {
      box.low = box.low.cwiseMin(p);
      box.high = box.high.cwiseMax(p);
    }
    return box;
  }

  /// Whether two boxes have more than a face in common.
  static bool overlap(const Box& a, const Box& b) {
    return (a.high.cwiseMin(b.high) - a.low.cwiseMax(b.low)).minCoeff() > kOnPlane;
  }

  const StepFile& file_;
  const IfcModel& model_;
  WorkBudget& budget_;
  ShapeTerms terms_;
  ShapeReader shapes_;
  IfcPlacements placements_;
  std::map<std::uint64_t, std::vector<std::uint64_t>> openings_, projections_;  ///< by element
};

}  // namespace

WorkBudget shape_budget(const StepFile& file) {
  return WorkBudget(kShapeSteps + kShapeStepsPerRecord * file.records().size());
}

std::vector<std::optional<ElementBody>> element_bodies(const StepFile& file, const IfcModel& model,
                                                       WorkBudget& budget) {
  BodyReader reader(file, model, budget);
  std::vector<std::optional<ElementBody>> bodies;
  for (const IfcElement& element : model.elements) {
    bodies.push_back(reader.read(element));
    if (budget.is_spent()) break;
  }
  return bodies;
}

}  // namespace rubicon::ifc
