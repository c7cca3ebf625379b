#include "src/exchange/ifc/element_bodies.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "src/exchange/ifc/ifc_placement.hpp"
#include "src/exchange/ifc/ifc_units.hpp"
#include "src/exchange/ifc/shape_reader.hpp"
#include "src/exchange/ifc/step_values.hpp"

namespace rubicon::ifc {

namespace {

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
  }

  std::optional<ElementBody> read(const IfcElement& element) {
    if (!element.X_WE) return std::nullopt;
    std::optional<Bodies> bodies = shapes_.read(element.shape);
    if (!bodies) return std::nullopt;
    const auto openings = openings_.find(element.id);
    if (openings != openings_.end()) cut_openings(element, openings->second, *bodies);
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

  /// Holes stand in the frame of what they are in.
  void cut_openings(const IfcElement& element, const std::vector<std::uint64_t>& openings,
                    Bodies& bodies) {
    const auto X_WE = placements_.of_product(element.id);
    std::vector<BodyCut> cuts;
    for (const std::uint64_t id : openings) {
      const StepRecord* record = file_.find(id);
      const auto values = record == nullptr ? std::nullopt : StepValues::read(record->arguments);
      const auto X_WO = placements_.of_product(id);
      constexpr std::size_t kShape = 6;
      const std::uint64_t shape = values ? (*values)[kShape].reference() : 0;
      if (shape == 0) continue;  // an opening without a shape takes nothing away
      std::optional<Bodies> hole = shapes_.read(shape);
      std::optional<std::vector<Cell>> cells;
      if (hole && X_WE && X_WO) {
        math::Pose X_EO = X_WE->inverse(Eigen::Isometry) * *X_WO;
        transform(X_EO.linear(), X_EO.translation() * model_.metres_per_unit, hole->solids);
        cells = cells_of(*hole, budget_);
      }
      if (cells) {
        cuts.push_back({std::move(*cells), "an opening"});
      } else {
        bodies.notes.emplace_back("an opening cannot be read and is not cut out");
      }
    }
    cut_bodies(bodies, cuts, budget_);
  }

  const StepFile& file_;
  const IfcModel& model_;
  WorkBudget& budget_;
  ShapeTerms terms_;
  ShapeReader shapes_;
  IfcPlacements placements_;
  std::map<std::uint64_t, std::vector<std::uint64_t>> openings_;  ///< by element
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
