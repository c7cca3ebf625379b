#include "src/exchange/urdf/machine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "src/exchange/urdf/fault.hpp"
#include "src/exchange/urdf/limits.hpp"
#include "src/exchange/urdf/number_text.hpp"

namespace rubicon::urdf {

namespace {

using interpreter::Span;

/// Beyond any machine, in m or rad.
constexpr double kLargest = 1e6;
/// What else is known to stand in such files, and what it is about.
constexpr std::pair<std::string_view, std::string_view> kKnown[] = {
    {"inertial", "masses: in plans, loads have them"},
    {"material", "colours"},
    {"transmission", "drives"},
    {"gazebo", "settings of the simulator Gazebo"},
    {"ros2_control", "drives"},
    {"dynamics", "friction and damping"},
    {"calibration", "reference positions"},
    {"safety_controller", "soft limits: the limits of the joint hold"}};

class MachineReader {
 public:
  explicit MachineReader(Findings& findings) : findings_(findings) {}

  Machine read(const Element& root) {
    if (root.name != "robot") {
      fail("I20", root.span,
           fmt::format("expected a URDF file with the element <robot>, found <{}>", root.name));
    }
    machine_.span = root.span;
    if (const std::string* name = root.find("name")) machine_.name = *name;
    know(root, {"name", "version"}, {"link", "joint"});
    for (const Element& each : root.children) {
      if (each.name == "link") read_link(each);
    }
    if (machine_.links.empty()) fail("I24", root.span, "expected at least one <link>, found none");
    for (const Element& each : root.children) {
      if (each.name == "joint") read_joint(each);
    }
    check_tree();
    check_mimics();
    return std::move(machine_);
  }

 private:
  // --- what every element needs

  /// Lists what else stands in an element.
  void know(const Element& element, const std::set<std::string_view>& attributes,
            const std::set<std::string_view>& children) {
    for (const Attribute& each : element.attributes) {
      if (attributes.contains(each.name) || each.name.starts_with("xmlns")) continue;
      findings_.note("I25", fmt::format("attribute {} {}", element.name, each.name), element.span,
                     fmt::format("'{}' of <{}> is not taken over", each.name, element.name));
    }
    for (const Element& each : element.children) {
      if (!children.contains(each.name)) list(each, element);
    }
  }

  void list(const Element& element, const Element& parent) {
    const std::string kind = fmt::format("element {} {}", parent.name, element.name);
    for (const auto& [name, about] : kKnown) {
      if (element.name != name) continue;
      findings_.note("I25", kind, element.span,
                     fmt::format("<{}> is not taken over ({})", name, about));
      return;
    }
    findings_.warn("I25", kind, element.span,
                   fmt::format("<{}> of <{}> is not known here and not taken over", element.name,
                               parent.name));
  }

  static const std::string& required(const Element& element, std::string_view attribute) {
    const std::string* value = element.find(attribute);
    if (value == nullptr || value->empty()) {
      fail("I24", element.span,
           fmt::format("expected the attribute '{}' in <{}>, found none", attribute, element.name));
    }
    return *value;
  }

  static double number(const Element& element, std::string_view attribute, double otherwise) {
    const std::string* text = element.find(attribute);
    if (text == nullptr) return otherwise;
    const std::optional<double> value = number_of(*text);
    if (!value || std::fabs(*value) > kLargest) {
      fail("I24", element.span,
           fmt::format("expected a number up to {} in '{}' of <{}>, found '{}'", kLargest,
                       attribute, element.name, shown(*text)));
    }
    return *value;
  }

  static double size(const Element& element, std::string_view attribute) {
    required(element, attribute);
    const double value = number(element, attribute, 0);
    if (value < 0) {
      fail("I24", element.span,
           fmt::format("expected '{}' of <{}> to be 0 or more, found {}", attribute, element.name,
                       value));
    }
    return value;
  }

  static Triple triple(const Element& element, std::string_view attribute, Triple otherwise) {
    const std::string* text = element.find(attribute);
    if (text == nullptr) return otherwise;
    const auto values = numbers_of(*text);
    const bool fine = values && values->size() == 3 &&
                      std::all_of(values->begin(), values->end(),
                                  [](double each) { return std::fabs(each) <= kLargest; });
    if (!fine) {
      fail("I24", element.span,
           fmt::format("expected three numbers in '{}' of <{}>, found '{}'", attribute,
                       element.name, shown(*text)));
    }
    return {(*values)[0], (*values)[1], (*values)[2]};
  }

  static std::string shown(const std::string& text) {
    return text.size() <= 60 ? text : text.substr(0, 57) + "...";
  }

  /// The one child of that name, null if there is none.
  static const Element* child(const Element& element, std::string_view name) {
    const Element* result = nullptr;
    for (const Element& each : element.children) {
      if (each.name != name) continue;
      if (result != nullptr) {
        fail("I24", each.span, fmt::format("<{}> stands twice in this <{}>", name, element.name));
      }
      result = &each;
    }
    return result;
  }

  Origin read_origin(const Element& element) {
    const Element* origin = child(element, "origin");
    if (origin == nullptr) return {};
    for (const Attribute& each : origin->attributes) {
      // It says where something is: to pass it over would move it.
      if (each.name != "xyz" && each.name != "rpy") {
        fail("I24", origin->span,
             fmt::format("expected 'xyz' and 'rpy' in <origin>, found '{}'", each.name));
      }
    }
    know(*origin, {"xyz", "rpy"}, {});
    return {triple(*origin, "xyz", {}), triple(*origin, "rpy", {})};
  }

  // --- links

  void read_link(const Element& element) {
    Link link;
    link.name = required(element, "name");
    link.span = element.span;
    if (machine_.links.size() == kMaxLinks) {
      fail("I21", element.span, fmt::format("expected at most {} links, found more", kMaxLinks),
           "is this one machine?");
    }
    if (!links_.emplace(link.name, machine_.links.size()).second) {
      fail("I24", element.span, fmt::format("link '{}' is there twice", link.name));
    }
    know(element, {"name"}, {"collision", "visual"});
    const bool collides = std::any_of(element.children.begin(), element.children.end(),
                                      [](const Element& each) { return each.name == "collision"; });
    for (const Element& each : element.children) {
      if (each.name != "collision" && each.name != "visual") continue;
      if (collides && each.name == "visual") {
        findings_.note("I25", "visual beside collision", each.span,
                       "<visual> is not taken over where a link has a <collision>");
      } else if (auto piece = read_piece(each)) {
        link.pieces.push_back(std::move(*piece));
      }
    }
    if (!collides && !link.pieces.empty()) {
      findings_.warn("I26", "visual taken", element.span,
                     fmt::format("link '{}' has no <collision>: its <visual> is taken for its body",
                                 link.name));
    }
    machine_.links.push_back(std::move(link));
  }

  std::optional<Piece> read_piece(const Element& element) {
    know(element, {"name", "group"}, {"origin", "geometry", "material"});
    Piece piece;
    piece.origin = read_origin(element);
    const Element* geometry = child(element, "geometry");
    if (geometry == nullptr || geometry->children.empty()) {
      fail("I24", element.span,
           fmt::format("expected <geometry> in <{}>, found none", element.name));
    }
    if (geometry->children.size() > 1) {
      fail("I24", geometry->children[1].span, "expected one shape in <geometry>, found another");
    }
    const Element& shape = geometry->children.front();
    piece.geometry.span = shape.span;
    if (!read_shape(shape, piece.geometry)) {
      findings_.warn(
          "I25", "shape " + shape.name, shape.span,
          fmt::format("the shape <{}> is not known here: the link goes without it", shape.name));
      return std::nullopt;
    }
    if (is_empty(piece.geometry)) {
      findings_.warn("I25", "empty shape", shape.span,
                     fmt::format("this <{}> has no volume: the link goes without it", shape.name));
      return std::nullopt;
    }
    return piece;
  }

  /// Descriptions have boxes of nothing, where something must stand.
  static bool is_empty(const Geometry& geometry) {
    const Triple& size = geometry.size;
    switch (geometry.kind) {
      case Geometry::Kind::box:
        return size[0] == 0 || size[1] == 0 || size[2] == 0;
      case Geometry::Kind::cylinder:
      case Geometry::Kind::capsule:
        return size[0] == 0 || size[1] == 0;
      case Geometry::Kind::sphere:
        return size[0] == 0;
      case Geometry::Kind::mesh:
        break;
    }
    return false;
  }

  bool read_shape(const Element& shape, Geometry& geometry) {
    if (shape.name == "box") {
      know(shape, {"size"}, {});
      required(shape, "size");
      geometry.size = triple(shape, "size", {});
      for (const double each : geometry.size) {
        if (each < 0) {
          fail("I24", shape.span,
               fmt::format("expected sizes of 0 or more, found '{}'", *shape.find("size")));
        }
      }
    } else if (shape.name == "sphere") {
      know(shape, {"radius"}, {});
      geometry.kind = Geometry::Kind::sphere;
      geometry.size = {size(shape, "radius"), 0, 0};
    } else if (shape.name == "cylinder" || shape.name == "capsule") {
      know(shape, {"radius", "length"}, {});
      geometry.kind = shape.name == "capsule" ? Geometry::Kind::capsule : Geometry::Kind::cylinder;
      geometry.size = {size(shape, "radius"), size(shape, "length"), 0};
    } else if (shape.name == "mesh") {
      know(shape, {"filename", "scale"}, {});
      geometry.kind = Geometry::Kind::mesh;
      geometry.mesh = required(shape, "filename");
      geometry.scale = triple(shape, "scale", {1, 1, 1});
      for (const double each : geometry.scale) {
        if (each == 0) {
          fail("I24", shape.span,
               fmt::format("expected a scale other than 0, found '{}'", *shape.find("scale")));
        }
      }
    } else {
      return false;
    }
    return true;
  }

  // --- joints

  void read_joint(const Element& element) {
    Joint joint;
    joint.name = required(element, "name");
    joint.span = element.span;
    if (machine_.joints.size() == kMaxLinks) {
      fail("I21", element.span, fmt::format("expected at most {} joints, found more", kMaxLinks));
    }
    if (!joints_.emplace(joint.name, machine_.joints.size()).second) {
      fail("I24", element.span, fmt::format("joint '{}' is there twice", joint.name));
    }
    know(element, {"name", "type"}, {"origin", "parent", "child", "axis", "limit", "mimic"});
    joint.type = read_type(element, joint);
    joint.parent = read_end(element, "parent");
    joint.child = read_end(element, "child");
    joint.origin = read_origin(element);
    if (joint.type != Joint::Type::fixed) {
      joint.axis = read_axis(element);
      read_mimic(element, joint);
      read_limit(element, joint);
    }
    machine_.joints.push_back(std::move(joint));
  }

  Joint::Type read_type(const Element& element, const Joint& joint) {
    const std::string& type = required(element, "type");
    if (type == "fixed") return Joint::Type::fixed;
    if (type == "revolute") return Joint::Type::revolute;
    if (type == "continuous") return Joint::Type::continuous;
    if (type == "prismatic") return Joint::Type::prismatic;
    if (type != "floating" && type != "planar") {
      fail("I24", element.span,
           fmt::format("expected the type fixed, revolute, continuous or prismatic of joint '{}', "
                       "found '{}'",
                       joint.name, shown(type)));
    }
    findings_.warn("I26", "type " + joint.name, element.span,
                   fmt::format("joint '{}' is {}: it is held fast at its origin", joint.name, type),
                   "a plan says where a machine stands; let it drive by parameters of its first "
                   "body, if it has to");
    return Joint::Type::fixed;
  }

  std::size_t read_end(const Element& element, std::string_view name) {
    const Element* end = child(element, name);
    if (end == nullptr) {
      fail("I24", element.span, fmt::format("expected <{}> in this joint, found none", name));
    }
    know(*end, {"link"}, {});
    const std::string& link = required(*end, "link");
    const auto found = links_.find(link);
    if (found == links_.end()) {
      std::vector<std::string> names;
      for (const auto& [each, index] : links_) names.push_back(each);
      const std::string nearest = interpreter::did_you_mean(link, names);
      fail("I24", end->span,
           fmt::format("there is no link '{}'{}", shown(link),
                       nearest.empty() ? "" : "; did you mean " + nearest + "?"));
    }
    return found->second;
  }

  Triple read_axis(const Element& element) {
    const Element* axis = child(element, "axis");
    if (axis == nullptr) return {1, 0, 0};
    know(*axis, {"xyz"}, {});
    Triple result = triple(*axis, "xyz", {1, 0, 0});
    const double length =
        std::sqrt(result[0] * result[0] + result[1] * result[1] + result[2] * result[2]);
    if (!(length > 1e-9)) {
      fail("I24", axis->span,
           fmt::format("expected an axis longer than 0, found '{}'", *axis->find("xyz")));
    }
    for (double& each : result) each /= length;
    return result;
  }

  void read_mimic(const Element& element, Joint& joint) {
    const Element* mimic = child(element, "mimic");
    if (mimic == nullptr) return;
    know(*mimic, {"joint", "multiplier", "offset"}, {});
    joint.mimic = Mimic{required(*mimic, "joint"), number(*mimic, "multiplier", 1),
                        number(*mimic, "offset", 0), mimic->span};
  }

  void read_limit(const Element& element, Joint& joint) {
    const bool limited = joint.type != Joint::Type::continuous;
    const Element* limit = child(element, "limit");
    if (limit == nullptr) {
      if (limited && !joint.mimic) {
        fail("I24", element.span,
             fmt::format("expected <limit lower=\"...\" upper=\"...\" velocity=\"...\"/> in joint "
                         "'{}', which is {}; found none",
                         joint.name, *element.find("type")),
             "write it, or the type continuous for a joint that turns freely");
      }
      return;
    }
    know(*limit, {"lower", "upper", "velocity"}, {});
    joint.speed = number(*limit, "velocity", 0);
    if (joint.speed < 0) {
      fail("I24", limit->span,
           fmt::format("expected a velocity of 0 or more, found {}", joint.speed));
    }
    if (!limited) return;
    joint.lower = number(*limit, "lower", 0);
    joint.upper = number(*limit, "upper", 0);
    if (joint.lower > joint.upper) {
      fail("I24", limit->span,
           fmt::format("the limits of joint '{}' go from {} to {}; expected the "
                       "smaller first",
                       joint.name, joint.lower, joint.upper));
    }
    if (joint.lower == joint.upper && !joint.mimic) {
      findings_.warn("I27", "still " + joint.name, limit->span,
                     fmt::format("the limits of joint '{}' forbid all motion: {} to {}", joint.name,
                                 joint.lower, joint.upper),
                     "write its limits here, or in range(...) of the robot file");
    }
  }

  // --- the whole

  void check_tree() {
    std::vector<const Joint*> above(machine_.links.size(), nullptr);
    for (const Joint& each : machine_.joints) {
      const Joint*& joint = above[each.child];
      if (joint != nullptr) {
        fail("I24", each.span,
             fmt::format("link '{}' hangs on two joints, '{}' and '{}'; expected a tree",
                         machine_.links[each.child].name, joint->name, each.name),
             "a closed chain cannot be said in URDF: leave one joint out");
      }
      joint = &each;
    }
    std::optional<std::size_t> root;
    for (std::size_t i = 0; i < machine_.links.size(); ++i) {
      if (above[i] != nullptr) continue;
      if (root) {
        fail("I24", machine_.links[i].span,
             fmt::format("expected one first link, found two: '{}' and '{}'",
                         machine_.links[*root].name, machine_.links[i].name),
             "join them by a joint");
      }
      root = i;
    }
    check_rings(above);
    machine_.root = *root;
  }

  /// From every link the way up must end.
  void check_rings(const std::vector<const Joint*>& above) const {
    std::vector<int> seen(above.size(), -1);
    for (std::size_t i = 0; i < above.size(); ++i) {
      for (std::size_t at = i; seen[at] == -1 || seen[at] == static_cast<int>(i);
           at = above[at]->parent) {
        if (seen[at] == static_cast<int>(i)) {
          fail("I24", above[at]->span,
               fmt::format("joint '{}' closes a ring of links; expected a tree", above[at]->name));
        }
        seen[at] = static_cast<int>(i);
        if (above[at] == nullptr) break;
      }
    }
  }

  void check_mimics() {
    for (Joint& each : machine_.joints) {
      if (!each.mimic) continue;
      std::set<const Joint*> seen = {&each};
      for (const Joint* at = &each; at->mimic;) {
        const auto found = joints_.find(at->mimic->joint);
        if (found == joints_.end()) {
          fail("I24", at->mimic->span,
               fmt::format("joint '{}' mimics '{}', which is not there", at->name,
                           at->mimic->joint));
        }
        at = &machine_.joints[found->second];
        if (!seen.insert(at).second) {
          fail("I24", each.mimic->span,
               fmt::format("joint '{}' mimics itself over others", at->name));
        }
        if (seen.size() > kMaxMimics) {
          fail("I21", each.mimic->span,
               fmt::format("expected joints to mimic each other over at most {}, found more",
                           kMaxMimics));
        }
      }
    }
  }

  static constexpr std::size_t kMaxMimics = 50;

  Findings& findings_;
  Machine machine_;
  std::map<std::string, std::size_t> links_;
  std::map<std::string, std::size_t> joints_;
};

}  // namespace

Machine read_machine(const Element& root, Findings& findings) {
  return MachineReader(findings).read(root);
}

}  // namespace rubicon::urdf
