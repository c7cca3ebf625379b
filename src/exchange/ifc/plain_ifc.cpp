#include "src/exchange/ifc/plain_ifc.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include "src/exchange/ifc/ifc_far_points.hpp"
#include "src/exchange/ifc/ifc_placement.hpp"
#include "src/exchange/ifc/ifc_units.hpp"
#include "src/exchange/ifc/record_writer.hpp"
#include "src/exchange/ifc/shape_writer.hpp"
#include "src/exchange/ifc/step_values.hpp"

namespace rubicon::ifc {

namespace {

/// With what the GlobalIds begin that this file gives.
constexpr std::string_view kMark = "_element_";

class PlainWriter {
 public:
  PlainWriter(const StepFile& file, const IfcModel& model, const std::vector<char>& left_out)
      : file_(file),
        model_(model),
        left_out_(left_out),
        out_(file.largest_id()),
        far_(file, model.metres_per_unit, shapes_of(file, model)),
        shapes_(file, model.metres_per_unit, far_, out_),
        placements_(file) {}

  PlainIfc write() {
    write_frame();
    for (std::size_t i = 0; i < model_.elements.size(); ++i) {
      if (left_out_.empty() || left_out_[i] == 0) write_element(i);
    }
    for (const IfcOpening& opening : model_.openings) write_opening(opening);
    out_.add(fmt::format("IFCRELAGGREGATES('a',#{},$,$,#{},(#{}))", owner_, project_, site_));
    if (!written_.empty()) {
      out_.add(fmt::format("IFCRELAGGREGATES('b',#{},$,$,#{},({}))", owner_, site_,
                           references_text(written_)));
    }
    PlainIfc plain;
    for (const IfcElement& element : model_.elements) {
      plain.offsets.push_back(far_.offset_of(element.shape));
    }
    plain.elements = written_.size();
    plain.text =
        "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\n"
        "FILE_NAME('','',(''),(''),'','','');\nFILE_SCHEMA(('IFC2X3'));\nENDSEC;\nDATA;\n" +
        out_.text() + "ENDSEC;\nEND-ISO-10303-21;\n";
    return plain;
  }

 private:
  // Arguments of IfcProduct.
  static constexpr std::size_t kShape = 6;

  static std::uint64_t shape_of(const StepFile& file, std::uint64_t product) {
    const StepRecord* record = file.find(product);
    const auto values = record == nullptr ? std::nullopt : StepValues::read(record->arguments);
    return values ? (*values)[kShape].reference() : 0;
  }

  static std::vector<std::uint64_t> shapes_of(const StepFile& file, const IfcModel& model) {
    std::vector<std::uint64_t> shapes;
    for (const IfcElement& element : model.elements) shapes.push_back(element.shape);
    for (const IfcOpening& opening : model.openings) shapes.push_back(shape_of(file, opening.id));
    return shapes;
  }

  /// Project, units, context and site: what the elements hang on.
  void write_frame() {
    const auto organisation = out_.add("IFCORGANIZATION($,'',$,$,$)");
    const auto person = out_.add("IFCPERSON($,'',$,$,$,$,$,$)");
    const auto both =
        out_.add(fmt::format("IFCPERSONANDORGANIZATION(#{},#{},$)", person, organisation));
    const auto program = out_.add(fmt::format("IFCAPPLICATION(#{},'','','')", organisation));
    owner_ = out_.add(fmt::format("IFCOWNERHISTORY(#{},#{},$,.ADDED.,$,$,$,0)", both, program));
    const auto metre = out_.add("IFCSIUNIT(*,.LENGTHUNIT.,$,.METRE.)");
    const auto radian = out_.add("IFCSIUNIT(*,.PLANEANGLEUNIT.,$,.RADIAN.)");
    const auto factor = out_.add(fmt::format("IFCMEASUREWITHUNIT(IFCPLANEANGLEMEASURE({}),#{})",
                                             real_text(radians_per_unit(file_)), radian));
    const auto dimensions = out_.add("IFCDIMENSIONALEXPONENTS(0,0,0,0,0,0,0)");
    const auto angle = out_.add(fmt::format(
        "IFCCONVERSIONBASEDUNIT(#{},.PLANEANGLEUNIT.,'ANGLE',#{})", dimensions, factor));
    const auto units = out_.add(fmt::format("IFCUNITASSIGNMENT((#{},#{}))", metre, angle));
    project_ = out_.add(
        fmt::format("IFCPROJECT('p',#{},'x',$,$,$,$,(#{}),#{})", owner_, shapes_.context(), units));
    site_ = out_.add(fmt::format("IFCSITE('s',#{},'x',$,$,$,$,$,.ELEMENT.,$,$,$,$,$)", owner_));
  }

  void write_element(std::size_t i) {
    const IfcElement& element = model_.elements[i];
    if (!element.X_WE) return;
    const std::uint64_t shape = shapes_.write(element.shape);
    if (shape == 0) return;
    out_.put(element.id, fmt::format("IFCBUILDINGELEMENTPROXY('{}{}',#{},'x',$,$,$,#{},$,$)", kMark,
                                     i, owner_, shape));
    written_.push_back(element.id);
    place_.emplace(element.id, i);
  }

  /// A hole stands in the frame of what it is in.
  void write_opening(const IfcOpening& opening) {
    const auto element = place_.find(opening.element);
    if (element == place_.end() || place_.contains(opening.id)) return;
    const std::uint64_t shape = shape_of(file_, opening.id);
    const std::uint64_t written = shapes_.write(shape);
    const auto X_WO = placements_.of_product(opening.id);
    const auto X_WE = placements_.of_product(opening.element);
    if (!X_WO || !X_WE || written == 0) return;
    place_.emplace(opening.id, element->second);
    math::Pose X_EO = X_WE->inverse(Eigen::Isometry) * *X_WO;
    X_EO.translation() =
        X_EO * far_.offset_of(shape) - far_.offset_of(model_.elements[element->second].shape);
    const auto frame = out_.add_placement(X_EO);
    const auto placement = out_.add(fmt::format("IFCLOCALPLACEMENT($,#{})", frame));
    out_.put(opening.id, fmt::format("IFCOPENINGELEMENT('o{}',#{},'x',$,$,#{},#{},$)", opening.id,
                                     owner_, placement, written));
    out_.add(fmt::format("IFCRELVOIDSELEMENT('v{}',#{},$,$,#{},#{})", opening.id, owner_,
                         opening.element, opening.id));
  }

  const StepFile& file_;
  const IfcModel& model_;
  const std::vector<char>& left_out_;
  RecordWriter out_;
  FarPoints far_;
  ShapeWriter shapes_;
  IfcPlacements placements_;
  std::unordered_map<std::uint64_t, std::size_t> place_;  ///< of what is written, index of element
  std::vector<std::uint64_t> written_;
  std::uint64_t owner_ = 0, project_ = 0, site_ = 0;
};

}  // namespace

PlainIfc plain_ifc(const StepFile& file, const IfcModel& model, const std::vector<char>& left_out) {
  return PlainWriter(file, model, left_out).write();
}

std::optional<std::size_t> element_of(std::string_view node_name) {
  const std::size_t mark = node_name.rfind(kMark);
  if (mark == std::string_view::npos) return std::nullopt;
  const auto index = whole_number(node_name.substr(mark + kMark.size()));
  if (!index) return std::nullopt;
  return static_cast<std::size_t>(*index);
}

}  // namespace rubicon::ifc
