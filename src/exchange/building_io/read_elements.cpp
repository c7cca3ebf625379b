#include "src/exchange/building_io/read_elements.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "interpreter/check/check_number.hpp"
#include "src/exchange/building_io/component_text.hpp"
#include "src/exchange/building_io/element_frame.hpp"
#include "src/exchange/building_io/names.hpp"
#include "src/exchange/ifc/body_items.hpp"
#include "src/exchange/ifc/ifc_model.hpp"
#include "src/exchange/mesh_io/mesh_format.hpp"
#include "src/exchange/project_io/identifiers.hpp"

namespace rubicon::building_io {

namespace {

using mesh_io::NamedMesh;

/// Farther from its origin (metres) a building gets an origin of its own.
constexpr double kFarFromOrigin = 1000;
/// On this grid (metres), so that people can read it.
constexpr double kOriginGrid = 100;

constexpr std::size_t kGlobalIdLength = 22;

/// The GlobalId at the end of a node's name, CLASS_NAME_GLOBALID.
std::string guid_in(const std::string& node) {
  const bool has = node.size() > kGlobalIdLength && node[node.size() - kGlobalIdLength - 1] == '_';
  return has ? node.substr(node.size() - kGlobalIdLength) : std::string();
}

/// A name that a program gave because the file had none.
bool is_made_up(const std::string& name) {
  return name.empty() || name.front() == '<' || name == "defaultobject";
}

double metres_in(const std::string& unit) {
  return unit == "mm" ? 1e-3 : unit == "cm" ? 1e-2 : unit == "m" ? 1 : 0;
}

class ElementReader {
 public:
  ElementReader(const ModelTerms& terms, const mesh_io::MeshReader& reader,
                interpreter::Diagnostics& diagnostics)
      : terms_(terms), reader_(reader), diagnostics_(diagnostics) {}

  Elements read(const std::vector<ModelFile>& models) {
    for (const ModelFile& model : models) read_model(model);
    move_origin();
    leave_out_what_no_plan_holds();
    make_names();
    warn_of_sheets();
    return std::move(result_);
  }

 private:
  void fail(const std::string& message) { diagnostics_.error("I11", {}, message); }

  void read_model(const ModelFile& model) {
    mesh_io::MeshRequest request;
    request.path = model.path;
    request.folder = terms_.folder;
    request.metres_per_unit = metres_in(terms_.unit);
    request.up = terms_.up;
    auto nodes = reader_.read_nodes(request);
    if (const auto* failure = std::get_if<mesh_io::MeshFailure>(&nodes)) {
      return fail(failure->message);
    }
    auto& found = std::get<std::vector<NamedMesh>>(nodes);
    const auto format = mesh_io::format_of(model.path);
    if (format && format->name == "IFC") {
      read_ifc(model, found);
    } else {
      read_nodes(model, found);
    }
  }

  // ---- IFC

  void read_ifc(const ModelFile& model, const std::vector<NamedMesh>& nodes) {
    const auto file = ifc::StepFile::read(model.text);
    if (const auto* error = std::get_if<ifc::StepError>(&file)) {
      return fail(fmt::format("'{}': line {}: {}", model.path, error->line, error->message));
    }
    const auto read = ifc::read_model(std::get<ifc::StepFile>(file));
    if (const auto* failure = std::get_if<ifc::IfcFailure>(&read)) {
      return fail(fmt::format("'{}': {}", model.path, failure->message));
    }
    const auto& building = std::get<ifc::IfcModel>(read);
    note_model(model, building);
    std::map<std::size_t, const NamedMesh*> by_node;
    for (const NamedMesh& node : nodes) by_node.emplace(node.node, &node);
    for (const ifc::IfcElement& each : building.elements) {
      const auto node = by_node.find(static_cast<std::size_t>(each.node));
      if (node == by_node.end()) {
        left_out(model, std::get<ifc::StepFile>(file), each);
        continue;
      }
      note_shape(model, each, *node->second);
      Element element;
      element.storey = clean(each.storey);
      element.type = clean(each.type);
      element.name = clean(each.name);
      element.guid = clean(each.guid);
      // The plan names it by its GlobalId, if nobody else has it and nothing hangs below.
      const std::string guid = guid_in(node->second->name);
      const bool names_it =
          node->second->id_is_unique && can_be_quoted(guid) && !node->second->has_nodes_below;
      put(std::move(element), model, *node->second, names_it ? std::optional(guid) : std::nullopt);
    }
    for (const auto& [type, count] : building.no_elements) {
      result_.notes.push_back(
          fmt::format("{}: {} {} left out: nothing that is built", model.reference, count, type));
    }
  }

  void note_model(const ModelFile& model, const ifc::IfcModel& building) {
    std::string note =
        fmt::format("{}: {}, {} elements, lengths in {} m", model.reference, clean(building.schema),
                    building.elements.size(), building.metres_per_unit);
    if (building.map_origin) {
      const Vec3& p = *building.map_origin;
      note += fmt::format("; its origin lies on the map at {}, {}, {}", p.x(), p.y(), p.z());
    }
    result_.notes.push_back(std::move(note));
  }

  void left_out(const ModelFile& model, const ifc::StepFile& file, const ifc::IfcElement& element) {
    std::string why = clean(element.no_place);
    std::string hint = "export it with a placement of its own (IfcLocalPlacement)";
    if (element.X_WE) {
      hint = "export it as triangles, or as extruded profiles";
      why = "its shape has nothing that can be read";
      const std::vector<std::string> unread = ifc::unread_classes(file, element.shape);
      if (!unread.empty()) why += fmt::format(" ({})", fmt::join(unread, ", "));
    }
    warn(model, element, "is left out: " + why, hint);
  }

  /// A shape that is not all that the model says.
  void note_shape(const ModelFile& model, const ifc::IfcElement& element, const NamedMesh& node) {
    if (node.note.empty()) return;
    warn(model, element, "is not quite as in the model: " + clean(node.note),
         "look at it in the report, or export it as triangles");
  }

  void warn(const ModelFile& model, const ifc::IfcElement& element, const std::string& what,
            const std::string& hint) {
    const std::string text = fmt::format("{} '{}' ({}) of {} {}", element.type, clean(element.name),
                                         clean(element.guid), model.reference, what);
    result_.notes.push_back(text);
    diagnostics_.warning("I14", {}, text, hint);
  }

  // ---- other formats

  void read_nodes(const ModelFile& model, const std::vector<NamedMesh>& nodes) {
    result_.notes.push_back(model.reference + ": " + counted(nodes.size(), "element"));
    for (const NamedMesh& node : nodes) {
      Element element;
      element.name = is_made_up(node.name) ? stem_of(model.reference) : clean(node.name);
      element.storey = is_made_up(node.above) ? std::string() : clean(node.above);
      std::optional<std::string> part;
      if (nodes.size() == 1) {
        part = std::string();  // the whole file
      } else if (!is_made_up(node.name) && node.name_is_unique && can_be_quoted(node.name) &&
                 !node.has_nodes_below) {
        part = node.name;
      }
      put(std::move(element), model, node, part);
    }
  }

  static std::string stem_of(const std::string& file) {
    const std::size_t slash = file.rfind('/');
    const std::string name = slash == std::string::npos ? file : file.substr(slash + 1);
    return name.substr(0, name.rfind('.'));
  }

  // ---- both

  void put(Element element, const ModelFile& model, const NamedMesh& node,
           const std::optional<std::string>& part) {
    element.model = model.reference;
    element.unit = terms_.unit;
    element.up = terms_.up;
    element.frame = frame_of(node.mesh);
    if (terms_.keep_meshes) {
      element.world = std::make_shared<const geometry::TriangleMesh>(node.mesh);
    }
    if (part) {
      element.part = *part;
    } else {
      element.mesh = in_frame(node.mesh, element.frame);
    }
    result_.all.push_back(std::move(element));
  }

  void move_origin() {
    if (result_.all.empty()) return;
    const Vec3 first = result_.all.front().frame.origin;
    if (first.cwiseAbs().maxCoeff() <= kFarFromOrigin) return;
    result_.origin = (first / kOriginGrid).array().round().matrix() * kOriginGrid;
  }

  /// Elements whose numbers are larger than those of a plan may be, and such that are so small that
  /// nothing of them is left in a mesh file of their own.
  void leave_out_what_no_plan_holds() {
    std::erase_if(result_.all, [&](const Element& element) {
      std::string why;
      const ElementFrame& frame = element.frame;
      if (!(frame.origin.norm() <= interpreter::kMaxLength &&
            (frame.origin - result_.origin).norm() <= interpreter::kMaxLength &&
            frame.size.maxCoeff() <= interpreter::kMaxLength)) {
        why = fmt::format("it reaches farther than {} m", interpreter::kMaxLength);
      } else if (element.mesh && is_nothing_when_written(*element.mesh)) {
        why = "it is smaller than 0.01 mm";
      }
      if (why.empty()) return false;
      const std::string text =
          fmt::format("{} {}{} of {} is left out: {}",
                      element.type.empty() ? "element" : element.type, remark_name(element.name),
                      element.guid.empty() ? "" : " (" + element.guid + ")", element.model, why);
      result_.notes.push_back(text);
      diagnostics_.warning("I14", {}, text, "check the unit and the scale of the model");
      return true;
    });
    if (result_.all.empty() && !diagnostics_.has_errors()) {
      fail("no element is left that a plan can hold");
    }
  }

  void make_names() {
    project_io::Identifiers names;
    for (Element& element : result_.all) {
      const std::string name = element.name.empty() ? element.type : element.name;
      element.component =
          names.make(element.storey.empty() ? name : name + "_" + element.storey, "element");
    }
  }

  /// Elements in which a machine could stand unnoticed.
  void warn_of_sheets() {
    constexpr std::size_t kMostNamed = 20;
    std::vector<std::string> sheets;
    for (const Element& element : result_.all) {
      if (!(element.frame.volume > 0)) sheets.push_back(element.component);
    }
    if (sheets.empty()) return;
    const std::string text = fmt::format(
        "{} with a surface that is not closed; only the surface itself stands in the way of "
        "machines, not what it should enclose: {}",
        counted(sheets.size(), "element"), joined(sheets, kMostNamed));
    diagnostics_.warning("I14", {}, text, "export them as solids");
  }

  const ModelTerms& terms_;
  const mesh_io::MeshReader& reader_;
  interpreter::Diagnostics& diagnostics_;
  Elements result_;
};

}  // namespace

Elements read_elements(const std::vector<ModelFile>& models, const ModelTerms& terms,
                       const mesh_io::MeshReader& reader, interpreter::Diagnostics& diagnostics) {
  return ElementReader(terms, reader, diagnostics).read(models);
}

}  // namespace rubicon::building_io
