#include "src/exchange/ifc/ifc_model.hpp"

#include <set>
#include <string_view>
#include <utility>

#include "src/exchange/ifc/ifc_class_names.hpp"
#include "src/exchange/ifc/ifc_placement.hpp"
#include "src/exchange/ifc/ifc_tree.hpp"
#include "src/exchange/ifc/ifc_units.hpp"
#include "src/exchange/ifc/step_values.hpp"

namespace rubicon::ifc {

namespace {

// Arguments of IfcProduct and its subclasses, the same in all versions.
constexpr std::size_t kGlobalId = 0;
constexpr std::size_t kName = 2;
constexpr std::size_t kObjectType = 4;
constexpr std::size_t kPlacement = 5;
constexpr std::size_t kShape = 6;
constexpr std::size_t kTag = 7;

class ModelReader {
 public:
  explicit ModelReader(const StepFile& file) : file_(file), tree_(file), placements_(file) {}

  std::variant<IfcModel, IfcFailure> read() {
    model_.schema = file_.schema();
    if (!model_.schema.starts_with("IFC")) {
      return IfcFailure{"it is a STEP file, but no IFC: its schema is '" + model_.schema + "'"};
    }
    const std::optional<double> unit = metres_per_unit(file_);
    if (!unit) return IfcFailure{"it says no unit of length that can be understood"};
    model_.metres_per_unit = *unit;
    X_WC_ = world_coordinates();
    find_projections();
    for (const StepRecord& record : file_.records()) {
      if (record.keyword == "IFCMAPCONVERSION") read_map_conversion(record);
      read_product(record);
    }
    model_.openings = tree_.openings();
    return std::move(model_);
  }

 private:
  /// The frame that all coordinates of the model are in, of the context for bodies.
  math::Pose world_coordinates() const {
    constexpr std::size_t kContextType = 1;
    constexpr std::size_t kWorld = 4;
    const StepRecord* chosen = nullptr;
    for (const StepRecord& record : file_.records()) {
      if (record.keyword != "IFCGEOMETRICREPRESENTATIONCONTEXT") continue;
      const auto values = StepValues::read(record.arguments);
      const bool model = values && (*values)[kContextType].text() == "Model";
      if (chosen == nullptr || model) chosen = &record;
      if (model) break;
    }
    if (chosen == nullptr) return math::Pose::Identity();
    const auto values = StepValues::read(chosen->arguments);
    if (!values) return math::Pose::Identity();
    return axis_placement(file_, (*values)[kWorld].reference()).value_or(math::Pose::Identity());
  }

  /// What projects from an element is a part of it; from anything else, an element of its own.
  void find_projections() {
    for (const IfcOpening& each : tree_.projections()) {
      const StepRecord* whole = file_.find(each.element);
      if (whole == nullptr || is_no_element(whole->keyword)) continue;
      const auto values = StepValues::read(whole->arguments);
      if (!values || !is_a((*values)[kShape], "IFCPRODUCTDEFINITIONSHAPE")) continue;
      // Of a ring, or of two wholes, the first counts.
      if (each.id == each.element || parts_.contains(each.element)) continue;
      if (parts_.insert(each.id).second) model_.projections.push_back(each);
    }
  }

  void read_map_conversion(const StepRecord& record) {
    constexpr std::size_t kEastings = 2;
    const auto values = StepValues::read(record.arguments);
    if (!values) return;
    math::Vec3 origin;
    for (int k = 0; k < 3; ++k) {
      origin[k] = (*values)[kEastings + static_cast<std::size_t>(k)].number().value_or(0);
    }
    model_.map_origin = origin;
  }

  bool is_a(const StepItem& item, std::string_view keyword) const {
    const StepRecord* record = file_.find(item.reference());
    return record != nullptr && record->keyword == keyword;
  }

  void read_product(const StepRecord& record) {
    // Whatever its class and version: a product has a GlobalId first and a shape at its place. Most
    // records begin otherwise and need not be read.
    if (record.arguments.find_first_not_of("( \t\r\n/") ==
        record.arguments.find_first_of("#.$*0123456789-"))
      return;
    const auto values = StepValues::read(record.arguments);
    if (!values || (*values)[kGlobalId].kind() != StepKind::text ||
        !is_a((*values)[kShape], "IFCPRODUCTDEFINITIONSHAPE")) {
      return;
    }
    if (parts_.contains(record.id)) return;
    if (is_no_element(record.keyword)) {
      ++model_.no_elements[class_name(record.keyword)];
      return;
    }
    IfcElement element;
    element.id = record.id;
    element.type = class_name(record.keyword);
    element.guid = (*values)[kGlobalId].decoded();
    element.name = (*values)[kName].decoded();
    element.object_type = (*values)[kObjectType].decoded();
    element.tag = (*values)[kTag].decoded();
    element.shape = (*values)[kShape].reference();
    element.X_WE = place((*values)[kPlacement]);
    if (!element.X_WE) element.no_place = placements_.fault();
    element.node = tree_.node_of(record.id, model_.tree);
    find_storey(element);
    model_.elements.push_back(std::move(element));
  }

  std::optional<math::Pose> place(const StepItem& placement) {
    std::optional<math::Pose> pose =
        placement.is_set() ? placements_.world(placement.reference()) : math::Pose::Identity();
    if (!pose) return std::nullopt;
    pose = X_WC_ * *pose;
    pose->translation() *= model_.metres_per_unit;
    return pose;
  }

  void find_storey(IfcElement& element) const {
    constexpr std::size_t kElevation = 9;
    for (const std::uint64_t each : tree_.way_to(element.id)) {
      const StepRecord* record = file_.find(each);
      if (record == nullptr || record->keyword != "IFCBUILDINGSTOREY") continue;
      const auto values = StepValues::read(record->arguments);
      if (!values) continue;
      element.storey = (*values)[kName].decoded();
      element.storey_height = (*values)[kElevation].number().value_or(0) * model_.metres_per_unit;
    }
  }

  const StepFile& file_;
  IfcTree tree_;
  IfcPlacements placements_;
  math::Pose X_WC_ = math::Pose::Identity();
  std::set<std::uint64_t> parts_;  ///< products that project from an element
  IfcModel model_;
};

}  // namespace

std::variant<IfcModel, IfcFailure> read_model(const StepFile& file) {
  return ModelReader(file).read();
}

}  // namespace rubicon::ifc
