#include "src/exchange/urdf/robot_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "interpreter/parse/parse.hpp"
#include "interpreter/syntax/token.hpp"
#include "src/exchange/project_io/decode_text.hpp"
#include "src/exchange/urdf/fault.hpp"
#include "src/exchange/urdf/limits.hpp"
#include "src/exchange/urdf/number_text.hpp"
#include "src/motion/math/angles.hpp"

namespace rubicon::urdf {

namespace {

/// Elements of a frame, to be joined by `*`.
using Frame = std::vector<std::string>;

/// Where a description gives no speed.
constexpr double kAssumedTurn = 10;    ///< degrees per second
constexpr double kAssumedSlide = 0.2;  ///< metres per second
/// Steps of joints: descriptions have none.
constexpr double kTurnStep = 5;       ///< degrees
constexpr double kSlideStep = 0.1;    ///< metres
constexpr double kStepsInRange = 10;  ///< fewest in the range of a joint

struct Body {
  std::string name;
  int parent = -1;
  const Joint* joint = nullptr;  ///< that moves it; null: the first body
  std::string parameter;
  Frame frame;
  std::vector<std::string> links;  ///< the others that are part of it
  std::vector<std::string> shapes;
};

/// A link as part of a body.
struct Place {
  int body = -1;
  Frame frame;            ///< in the body
  std::size_t depth = 0;  ///< links above it
};

std::string joined(const Frame& frame) { return fmt::format("{}", fmt::join(frame, " * ")); }

void append(Frame& frame, const Frame& more) {
  frame.insert(frame.end(), more.begin(), more.end());
}

std::string in_remark(const std::string& text) {
  std::string result = project_io::clean_text(text.substr(0, 80));
  for (char& c : result) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  }
  return result;
}

Frame frame_of(const Origin& origin) {
  Frame result;
  const auto& [x, y, z] = origin.xyz;
  if (x != 0 || y != 0 || z != 0) {
    result.push_back(fmt::format("trans({}, {}, {})", text_of(x), text_of(y), text_of(z)));
  }
  // Fixed axes x, y, z are turned axes z, y, x.
  constexpr const char* kTurns[] = {"rotx", "roty", "rotz"};
  for (int i = 2; i >= 0; --i) {
    const double angle = degrees_of(origin.rpy[static_cast<std::size_t>(i)]);
    if (angle != 0) result.push_back(fmt::format("{}({})", kTurns[i], text_of(angle)));
  }
  return result;
}

/// The axis of the frame that an axis is: 0, 1, 2 for x, y, z, with its sign; -1 for none of them.
std::pair<int, bool> frame_axis(const Triple& axis) {
  constexpr double kNear = 1e-12;
  for (std::size_t i = 0; i < 3; ++i) {
    if (std::fabs(axis[(i + 1) % 3]) < kNear && std::fabs(axis[(i + 2) % 3]) < kNear) {
      return {static_cast<int>(i), axis[i] < 0};
    }
  }
  return {-1, false};
}

/// The motion of a joint: about or along an axis of the frame, or of one that is turned so that its
/// z is the axis, and turned back.
Frame motion_of(const Joint& joint, const std::string& parameter) {
  const auto [axis, negative] = frame_axis(joint.axis);
  const std::string value = (negative ? "-" : "") + parameter;
  const auto moved = [&](int along) {
    if (joint.type != Joint::Type::prismatic) {
      constexpr const char* kTurns[] = {"rotx", "roty", "rotz"};
      return fmt::format("{}({})", kTurns[along], value);
    }
    return fmt::format("trans({}, {}, {})", along == 0 ? value : "0", along == 1 ? value : "0",
                       along == 2 ? value : "0");
  };
  if (axis >= 0) return {moved(axis)};
  const auto& [x, y, z] = joint.axis;
  const double about_z = math::atan2_deg(y, x);
  const double about_y = math::atan2_deg(std::sqrt(x * x + y * y), z);
  return {fmt::format("rotz({})", text_of(about_z)), fmt::format("roty({})", text_of(about_y)),
          moved(2), fmt::format("roty({})", text_of(-about_y)),
          fmt::format("rotz({})", text_of(-about_z))};
}

std::string parameter_of(const Joint& joint) {
  const int axis = std::max(frame_axis(joint.axis).first, -1);
  const auto i = static_cast<std::size_t>(axis < 0 ? 2 : axis);
  constexpr const char* kSlides[] = {"x", "y", "z"};
  constexpr const char* kTurns[] = {"psi", "phi", "theta"};
  return joint.type == Joint::Type::prismatic ? kSlides[i] : kTurns[i];
}

/// The largest of 1, 2, 5, 10, ... times a power of ten that is not above `value`.
double round_step(double value) {
  double power = 1;
  while (power > value) power /= 10;
  for (const double digit : {5.0, 2.0}) {
    if (digit * power <= value) return *number_of(fmt::format("{:.6g}", digit * power));
  }
  return *number_of(fmt::format("{:.6g}", power));
}

class RobotWriter {
 public:
  RobotWriter(const Machine& machine, const RobotTerms& terms, MeshShapes& meshes,
              Findings& findings)
      : machine_(machine), terms_(terms), meshes_(meshes), findings_(findings) {}

  std::string write() {
    place_links();
    for (const Link& each : machine_.links) add_shapes(each);
    write_head();
    for (const Body& each : bodies_) write_body(each);
    write_touching();
    write_tool();
    const bool moves = std::any_of(bodies_.begin(), bodies_.end(), [](const Body& each) {
      return each.joint != nullptr && !each.joint->mimic;
    });
    if (moves) {
      write_guide();
      text_ += "behaviour { chain { follow }; }\n";
    } else {
      findings_.warn("I26", "nothing moves", machine_.span,
                     "no joint of this machine moves: it gets no behaviour");
    }
    text_ += "}\n";
    return interpreter::format_text(text_, interpreter::TextKind::robot);
  }

 private:
  std::size_t index_of(const Link& link) const {
    return static_cast<std::size_t>(&link - machine_.links.data());
  }

  // --- names

  /// A name of the language, each once.
  std::string name_of(const std::string& name, const std::string& otherwise,
                      interpreter::Span span) {
    std::string result;
    for (const char c : name.substr(0, kLongestName)) {
      const bool fine =
          (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
      result += fine ? c : '_';
    }
    if (result.empty()) result = otherwise;
    if (result.front() >= '0' && result.front() <= '9') result.insert(0, "_");
    static const std::set<std::string> kWords = {"at", "on", "from", "to", "follow"};
    if (interpreter::is_reserved(result) || kWords.contains(result)) result += "_";
    const std::string stem = result;
    for (int i = 2; !names_.insert(result).second; ++i) result = fmt::format("{}_{}", stem, i);
    if (result != name) {
      findings_.note("I28", "name " + name, span,
                     fmt::format("'{}' is called {} in the robot file", in_remark(name), result),
                     "names have the letters a to z, digits and _, and no word of the language");
    }
    return result;
  }

  // --- bodies

  void place_links() {
    std::vector<std::vector<const Joint*>> below(machine_.links.size());
    for (const Joint& each : machine_.joints) below[each.parent].push_back(&each);
    places_.resize(machine_.links.size());
    new_body(machine_.root, nullptr);
    std::vector<std::size_t> open = {machine_.root};
    while (!open.empty()) {
      const std::size_t link = open.back();
      open.pop_back();
      for (const Joint* each : below[link]) place_child(*each);
      for (auto each = below[link].rbegin(); each != below[link].rend(); ++each) {
        open.push_back((*each)->child);
      }
    }
  }

  void place_child(const Joint& joint) {
    const Place& parent = places_[joint.parent];
    const Link& link = machine_.links[joint.child];
    Frame frame = parent.frame;
    append(frame, frame_of(joint.origin));
    if (frame.size() > kMaxFrame) {
      fail("I21", joint.span, "more fixed joints hang on each other here than a frame can hold");
    }
    const std::size_t depth = parent.depth + 1;
    if (joint.type == Joint::Type::fixed) {
      const int body = parent.body;
      places_[joint.child] = {body, std::move(frame), depth};
      bodies_[static_cast<std::size_t>(body)].links.push_back(link.name);
      return;
    }
    const int on = parent.body;
    new_body(joint.child, &joint);
    Body& body = bodies_.back();
    body.parent = on;
    body.parameter = parameter_of(joint);
    append(frame, motion_of(joint, body.parameter));
    body.frame = std::move(frame);
    body_of_joint_[joint.name] = bodies_.size() - 1;
    places_[joint.child].depth = depth;
  }

  void new_body(std::size_t link, const Joint* joint) {
    if (joint != nullptr && bodies_.size() > kMaxMovingLinks) {
      fail("I21", joint->span,
           fmt::format("expected at most {} joints that move, found more", kMaxMovingLinks));
    }
    Body body;
    const Link& first = machine_.links[link];
    body.name = name_of(first.name, "link", first.span);
    body.joint = joint;
    places_[link] = {static_cast<int>(bodies_.size()), {}, 0};
    bodies_.push_back(std::move(body));
  }

  void add_shapes(const Link& link) {
    const Place& place = places_[index_of(link)];
    Body& body = bodies_[static_cast<std::size_t>(place.body)];
    for (const Piece& each : link.pieces) {
      std::string shape = shape_of(each.geometry);
      if (shape.empty()) continue;
      Frame frame = place.frame;
      append(frame, frame_of(each.origin));
      if (!frame.empty()) shape += " at " + joined(frame);
      body.shapes.push_back(std::move(shape));
    }
  }

  std::string shape_of(const Geometry& geometry) {
    const auto& [a, b, c] = geometry.size;
    switch (geometry.kind) {
      case Geometry::Kind::box:
        return fmt::format("box({}, {}, {}, {}, {}, {})", text_of(-a / 2), text_of(-b / 2),
                           text_of(-c / 2), text_of(a / 2), text_of(b / 2), text_of(c / 2));
      case Geometry::Kind::cylinder:
        return fmt::format("cylinder({}, {}, {})", text_of(a), text_of(-b / 2), text_of(b / 2));
      case Geometry::Kind::sphere:
        return fmt::format("sphere(0, 0, 0, {})", text_of(a));
      case Geometry::Kind::capsule:
        return fmt::format("capsule(0, 0, {}, 0, 0, {}, {})", text_of(-b / 2), text_of(b / 2),
                           text_of(a));
      case Geometry::Kind::mesh:
        break;
    }
    return meshes_.shape(geometry);
  }

  // --- text

  void write_head() {
    text_ = fmt::format(
        "# Made by rubicon import of {}.\n# Assumed: the steps of the joints{}.\nrobot {} {{\n",
        in_remark(terms_.file), assumes_speeds() ? ", and the speeds that say so" : "",
        robot_name());
  }

  bool assumes_speeds() const {
    return std::any_of(bodies_.begin(), bodies_.end(), [](const Body& each) {
      return each.joint != nullptr && !each.joint->mimic && each.joint->speed == 0;
    });
  }

  std::string robot_name() {
    // A body may have the name of its robot.
    const std::set<std::string> names = std::exchange(names_, {});
    std::string name = name_of(machine_.name, "machine", machine_.span);
    names_ = names;
    return name;
  }

  void write_body(const Body& body) {
    text_ += "body " + body.name;
    if (body.parent >= 0) text_ += " on " + bodies_[static_cast<std::size_t>(body.parent)].name;
    text_ += " {";
    if (!body.links.empty()) text_ += "  # with " + link_names(body.links);
    text_ += "\n";
    if (body.joint != nullptr) write_joint(body);
    if (!body.frame.empty()) text_ += "frame " + joined(body.frame) + ";\n";
    for (const std::string& each : body.shapes) text_ += "shape " + each + ";\n";
    text_ += "}\n";
  }

  static std::string link_names(const std::vector<std::string>& links) {
    constexpr std::size_t kShown = 4;
    std::string result;
    for (std::size_t i = 0; i < std::min(links.size(), kShown); ++i) {
      result += (i > 0 ? ", " : "") + in_remark(links[i]);
    }
    if (links.size() > kShown) result += fmt::format(" and {} more", links.size() - kShown);
    return result;
  }

  void write_joint(const Body& body) {
    const Joint& joint = *body.joint;
    text_ += "param " + body.parameter;
    std::string remark = "joint " + in_remark(joint.name);
    if (joint.mimic) {
      text_ += " = " + mimic_text(joint) + ";";
      remark += ", which mimics " + in_remark(joint.mimic->joint);
    } else {
      const bool slides = joint.type == Joint::Type::prismatic;
      const auto unit = [&](double value) { return slides ? value : degrees_of(value); };
      const double lower = unit(joint.lower), upper = unit(joint.upper);
      double step = slides ? kSlideStep : kTurnStep;
      if (joint.type == Joint::Type::continuous) {
        text_ += " cyclic";
      } else {
        text_ += fmt::format(" range({}, {})", text_of(lower), text_of(upper));
        const double part = (upper - lower) / kStepsInRange;
        if (part > 0 && part < step) step = std::max(round_step(part), 1e-6);
      }
      double speed = slides ? joint.speed : math::degrees(joint.speed);
      if (speed == 0) {
        speed = slides ? kAssumedSlide : kAssumedTurn;
        remark += "; the speed is assumed";
        findings_.warn("I26", "speed " + joint.name, joint.span,
                       fmt::format("joint '{}' has no velocity: {} {} is assumed", joint.name,
                                   speed, slides ? "m/s" : "deg/s"),
                       "correct its speed(...) in the robot file");
      }
      text_ += fmt::format(" step({}) speed({:.9g} {});", text_of(step), speed,
                           slides ? "m/s" : "deg/s");
    }
    text_ += "  # " + remark + "\n";
  }

  /// In the unit of the joint: m or degrees.
  std::string mimic_text(const Joint& joint) const {
    const bool slides = joint.type == Joint::Type::prismatic;
    const double offset = slides ? joint.mimic->offset : degrees_of(joint.mimic->offset);
    const auto found = body_of_joint_.find(joint.mimic->joint);
    double factor = joint.mimic->multiplier;
    if (found == body_of_joint_.end() || factor == 0) return text_of(offset);  // of a fixed joint
    const Body& leader = bodies_[found->second];
    const bool leader_slides = leader.joint->type == Joint::Type::prismatic;
    if (slides && !leader_slides) factor = math::radians(factor);
    if (!slides && leader_slides) factor = math::degrees(factor);
    std::string text = fmt::format("{}.{}", leader.name, leader.parameter);
    if (factor == -1) {
      text = "-" + text;
    } else if (factor != 1) {
      text = text_of(factor) + " * " + text;
    }
    if (offset != 0)
      text += fmt::format(" {} {}", offset < 0 ? "-" : "+", text_of(std::fabs(offset)));
    return text;
  }

  /// Bodies with nothing but bodies without a shape between them turn about each other as a body
  /// and its parent do.
  void write_touching() {
    for (const Body& each : bodies_) {
      if (each.shapes.empty() || each.parent < 0) continue;
      int above = each.parent;
      while (above >= 0 && bodies_[static_cast<std::size_t>(above)].shapes.empty()) {
        above = bodies_[static_cast<std::size_t>(above)].parent;
      }
      if (above < 0 || above == each.parent) continue;
      text_ += fmt::format("touching {} {};\n", bodies_[static_cast<std::size_t>(above)].name,
                           each.name);
    }
  }

  /// Guides look for ways in ranges, and a joint that turns freely has none where another, which
  /// mimics it, tells its turns apart.
  void write_guide() {
    for (const Body& each : bodies_) {
      if (each.joint == nullptr || !each.joint->mimic) continue;
      const Joint* leader = each.joint;
      while (leader != nullptr && leader->mimic) {
        const auto found = body_of_joint_.find(leader->mimic->joint);
        leader = found == body_of_joint_.end() ? nullptr : bodies_[found->second].joint;
      }
      if (leader == nullptr || leader->type != Joint::Type::continuous) continue;
      findings_.note("I26", "no guide", each.joint->span,
                     fmt::format("this machine gets no guide: joint '{}' mimics '{}', which turns "
                                 "without limits",
                                 each.joint->name, leader->name));
      return;
    }
    text_ += "guide way rrt_connect { seed 1; }\n";
  }

  void write_tool() {
    const Place& place = places_[tool_link()];
    text_ += "tool " + bodies_[static_cast<std::size_t>(place.body)].name;
    if (!place.frame.empty()) text_ += " at " + joined(place.frame);
    text_ += ";\n";
  }

  std::size_t tool_link() const {
    std::size_t deepest = machine_.root;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < machine_.links.size(); ++i) {
      if (machine_.links[i].name == terms_.tool) return i;
      if (places_[i].depth > places_[deepest].depth) deepest = i;
      names.push_back(machine_.links[i].name);
    }
    if (!terms_.tool.empty()) {
      const std::string nearest = interpreter::did_you_mean(terms_.tool, names);
      fail("I24", machine_.span,
           fmt::format("there is no link '{}' for --tool{}", terms_.tool,
                       nearest.empty() ? "" : "; did you mean " + nearest + "?"));
    }
    return deepest;
  }

  static constexpr std::size_t kLongestName = 200;
  static constexpr std::size_t kMaxFrame = 2000;  ///< elements

  const Machine& machine_;
  const RobotTerms& terms_;
  MeshShapes& meshes_;
  Findings& findings_;
  std::vector<Body> bodies_;
  std::vector<Place> places_;
  std::map<std::string, std::size_t> body_of_joint_;
  std::set<std::string> names_;
  std::string text_;
};

}  // namespace

std::string robot_file(const Machine& machine, const RobotTerms& terms, MeshShapes& meshes,
                       Findings& findings) {
  return RobotWriter(machine, terms, meshes, findings).write();
}

}  // namespace rubicon::urdf
