// Writes the plan of a real floor: 48 elements of the Schependomlaan building, read from its IFC
// model, lifted one by one by a tower crane from a truck bed to where the model has them.
//
//   make_schependomlaan IFC OUTDIR [--order good|bad]
//
// OUTDIR gets site.plan, crane.robot, crane.motion, a mesh a component and elements.csv (component,
// name in the model, target pose, size). With `bad` one element waits in the crawl space below its
// neighbours until they are laid, so that the last gap would have to be filled from below.

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "src/exchange/mesh_io/mesh_io.hpp"
#include "tests/support/places.hpp"

namespace rubicon::scenes {
namespace {

using geometry::Vec3;

// The site, metres, z up, in the coordinates of the model.
constexpr double kGround = -0.6;
constexpr double kCraneX = -8;
constexpr double kCraneY = 10;
constexpr double kBedX = -12;
constexpr double kBedY = 2;
constexpr double kBedLength = 13.6;  // a usual trailer
constexpr double kBedWidth = 2.5;
constexpr double kBedTop = kGround + 1.2;
/// Between the two rows of stacks on the bed.
constexpr double kRowGap = 0.04;
constexpr double kWidestElement = 1.2;
constexpr double kLongestElement = 8;
/// Longer ones stand at the front of the bed, the others behind them.
constexpr double kLongElement = 6;
/// The space below the floor of the bad plan: an element and a hand's breadth.
constexpr double kCrawlSpace = -1.0;
/// West of it the ground is as it is.
constexpr double kCrawlSpaceFrom = -0.5;
/// Hollow-core slabs with their topping, for each cubic metre of the outline.
constexpr double kTonsPerCubicMetre = 1.5;

/// The model is drawn in whole tenths of a millimetre; what lies below is single precision.
double rounded(double metres) { return std::round(metres * 1e5) / 1e5 + 0.0; }

struct Element {
  std::string name;          ///< of the component: floor_01 ... in the order of the model
  std::string ifc_name;      ///< of the node
  Vec3 top = Vec3::Zero();   ///< middle of the top face, in the model
  double turn_deg = 0;       ///< 90 for elements that lie along y
  Vec3 size = Vec3::Zero();  ///< along, across, down
  double volume = 0;
  geometry::TriangleMesh mesh;  ///< in its own frame: origin at `top`, length along x
  Vec3 on_bed = Vec3::Zero();   ///< where that frame stands on the truck
};

double volume_of(const geometry::TriangleMesh& mesh) {
  double six = 0;
  for (const std::array<int, 3>& t : mesh.triangles) {
    const auto corner = [&](std::size_t k) {
      return mesh.vertices[static_cast<std::size_t>(t[k])];
    };
    six += corner(0).dot(corner(1).cross(corner(2)));
  }
  return six / 6;
}

Element element_from(const mesh_io::NamedMesh& node, std::size_t number) {
  Element element;
  element.name = fmt::format("floor_{:02}", number);
  element.ifc_name = node.name;
  element.mesh = node.mesh;
  Vec3 low = Vec3::Constant(1e9);
  Vec3 high = -low;
  for (Vec3& p : element.mesh.vertices) {
    p = {rounded(p.x()), rounded(-p.z()), rounded(p.y())};  // the reader gives Y up
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const Vec3 extent = high - low;
  element.top = {rounded((low.x() + high.x()) / 2), rounded((low.y() + high.y()) / 2), high.z()};
  const bool along_y = extent.y() > extent.x();
  element.turn_deg = along_y ? 90 : 0;
  element.size = along_y ? Vec3(extent.y(), extent.x(), extent.z()) : extent;
  for (Vec3& p : element.mesh.vertices) {
    const Vec3 d = p - element.top;
    p = along_y ? Vec3(d.y(), -d.x(), d.z()) : d;
  }
  element.volume = volume_of(element.mesh);
  return element;
}

std::vector<Element> read_elements(const std::string& ifc) {
  mesh_io::SceneRequest request;
  request.path = ifc;
  request.folder = std::filesystem::path(ifc).parent_path().string();
  const auto scene = mesh_io::MeshReader(test::mesh_helper()).read_scene(request);
  if (const auto* failure = std::get_if<mesh_io::MeshFailure>(&scene)) {
    throw std::runtime_error(failure->message);
  }
  std::vector<Element> elements;
  for (const auto& node : std::get<std::vector<mesh_io::NamedMesh>>(scene)) {
    // Not the origin marker, and not `vloerstort`, the joint concrete that is poured on site.
    if (!node.name.starts_with("IfcSlab_vloer_")) continue;
    elements.push_back(element_from(node, elements.size() + 1));
  }
  if (elements.empty()) throw std::runtime_error("no floor elements (IfcSlab_vloer_...) in " + ifc);
  return elements;
}

/// The order of laying: row by row from the south, each from the crane outwards.
std::vector<std::size_t> laying_order(const std::vector<Element>& elements) {
  std::vector<std::size_t> order(elements.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const Vec3& p = elements[a].top;
    const Vec3& q = elements[b].top;
    return std::array{p.y(), p.x()} < std::array{q.y(), q.x()};
  });
  return order;
}

/// Stands all elements on the bed in four stacks, the first to be lifted on top.
void load_truck(std::vector<Element>& elements, const std::vector<std::size_t>& lifting_order) {
  std::array<std::array<double, 2>, 2> height{};  // [long or short][row]
  for (auto& kind : height) kind.fill(kBedTop);
  for (auto it = lifting_order.rbegin(); it != lifting_order.rend(); ++it) {
    Element& element = elements[*it];
    const bool is_long = element.size.x() > kLongElement;
    auto& rows = height[is_long ? 0 : 1];
    const std::size_t row = rows[1] < rows[0] ? 1 : 0;
    rows[row] += element.size.z();
    const double front = kBedX - kBedLength / 2;
    const double x = is_long ? front + kLongestElement / 2
                             : (front + kLongestElement + kBedX + kBedLength / 2) / 2;
    const double off = (kWidestElement + kRowGap) / 2;
    element.on_bed = {rounded(x), rounded(row == 0 ? kBedY - off : kBedY + off),
                      rounded(rows[row])};
  }
}

/// The element whose gap the bad plan leaves to the last: one with neighbours on both sides, in the
/// middle of the longest row.
std::size_t last_gap(const std::vector<Element>& elements) {
  std::optional<std::size_t> best;
  double best_distance = 0;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const Element& e = elements[i];
    if (e.size.x() < kLongElement || e.turn_deg != 0) continue;
    const double distance = (e.top - Vec3(9.5, 5, e.top.z())).norm();
    if (!best || distance < best_distance) {
      best = i;
      best_distance = distance;
    }
  }
  if (!best) throw std::runtime_error("no long element along x for the last gap");
  return *best;
}

std::string frame_text(const Vec3& p, double turn_deg) {
  std::string text =
      fmt::format("trans({}, {}, {})", rounded(p.x()), rounded(p.y()), rounded(p.z()));
  if (turn_deg != 0) text += fmt::format(" * rotz({})", turn_deg);
  return text;
}

std::string mesh_text(const Element& element) {
  std::string text = fmt::format("# {}\no {}\n", element.ifc_name, element.name);
  for (const Vec3& p : element.mesh.vertices) {
    text += fmt::format("v {} {} {}\n", rounded(p.x()), rounded(p.y()), rounded(p.z()));
  }
  for (const std::array<int, 3>& t : element.mesh.triangles) {
    text += fmt::format("f {} {} {}\n", t[0] + 1, t[1] + 1, t[2] + 1);
  }
  return text;
}

std::string box_text(const Vec3& low, const Vec3& high) {
  return fmt::format("box({}, {}, {}, {}, {}, {})", rounded(low.x()), rounded(low.y()),
                     rounded(low.z()), rounded(high.x()), rounded(high.y()), rounded(high.z()));
}

std::string task_text(const std::string& task, const Element& element, const Vec3& to) {
  return fmt::format(
      "  task {} {{\n    by crane, riggers;\n    move {} to {};\n"
      "    hook 3 min by riggers;\n    adjust 4 min by riggers;\n    release 1 min by riggers;\n"
      "  }}\n",
      task, element.name, frame_text(to, element.turn_deg));
}

std::string site_text(bool crawl_space) {
  const double deep = kGround - 1;
  std::string text;
  const auto add = [&](const Vec3& low, const Vec3& high) {
    text += fmt::format("  site {};\n", box_text(low, high));
  };
  if (crawl_space) {
    add({-60, -60, deep}, {kCrawlSpaceFrom, 60, kGround});
    add({kCrawlSpaceFrom, -60, deep}, {60, 60, kCrawlSpace});
  } else {
    add({-60, -60, deep}, {60, 60, kGround});
  }
  add({kBedX - kBedLength / 2, kBedY - kBedWidth / 2, kGround},
      {kBedX + kBedLength / 2, kBedY + kBedWidth / 2, kBedTop});
  return text;
}

std::string plan_text(const std::vector<Element>& elements, std::vector<std::size_t> order,
                      std::optional<std::size_t> from_below) {
  std::string text =
      "# Ground floor of the Schependomlaan building: hollow-core elements, "
      "written by make_schependomlaan.\n";
  text += fmt::format("plan schependomlaan{} {{\n", from_below ? "_from_below" : "");
  text += "  support warn;  # the plan has the floor, and not the walls it lies on\n";
  text += site_text(from_below.has_value());
  text += fmt::format("  robot crane \"crane.robot\" at trans({}, {}, {}) {{\n", kCraneX, kCraneY,
                      kGround);
  text += "    start jib.theta 0, x 12, z 12, hook.theta 0;\n  }\n  crew riggers;\n\n";
  for (const Element& element : elements) {
    text += fmt::format(
        "  component {} {{   # {}\n    shape mesh(\"{}.obj\", m);\n    at {};\n"
        "    grip trans(0, 0, 0);\n    mass {} t;\n  }}\n",
        element.name, element.ifc_name, element.name, frame_text(element.on_bed, 0),
        std::round(element.volume * kTonsPerCubicMetre * 100) / 100);
  }
  text += "\n";
  if (from_below) {
    const Element& element = elements[*from_below];
    const Vec3 below(element.top.x(), element.top.y() + element.size.y(),
                     kCrawlSpace + element.size.z());
    text += "  # into the crawl space, below where the next row will lie\n";
    text += task_text("park_" + element.name, element, below);
    order.erase(std::find(order.begin(), order.end(), *from_below));
    order.push_back(*from_below);
  }
  for (const std::size_t i : order) {
    text += task_text("lay_" + elements[i].name, elements[i], elements[i].top);
  }
  return text + "}\n";
}

constexpr std::string_view kRobot = R"(# Tower crane: jib, trolley, and a hook that turns the load.
robot crane {
  time_step 1;
  body mast { shape box(-0.9, -0.9, 0, 0.9, 0.9, 28); }
  body jib on mast {
    param theta range(-180, 180) step(2) speed(4 deg/s) start(0);
    frame rotz(theta);
    shape box(-10, -0.6, 28, 34, 0.6, 29.5);
  }
  body hook on jib {
    param x range(3, 32) step(0.5) speed(0.8 m/s) start(12);
    param z range(-1, 25) step(0.5) speed(1 m/s) loaded(0.5 m/s) start(12);
    param theta cyclic step(10) speed(15 deg/s) start(0);
    frame trans(x, 0, z) * rotz(theta);
    shape box(-0.25, -0.25, 0, 0.25, 0.25, 0.8);
  }
  tool hook;
  behaviour "crane.motion";
}
)";

constexpr std::string_view kMotion = R"(# Carry an element from the truck to its place.
which {
  place:
  # the crew has it in its hands: straight down
  chain {move_to(z, goal(z))};
  default:
  # up, clear of the stacks on the truck
  chain {move_to(z, max(z, 8 m))};
  # round and out, higher where something is in the way
  chain {move_to(jib.theta, goal(jib.theta)), move_dir(z, dir(z, max(z)))};
  chain {move_to(x, goal(x)), move_dir(z, dir(z, max(z)))};
  # turned as it will lie
  chain {move_to(hook.theta, goal(hook.theta)), move_dir(z, dir(z, max(z)))};
  which {
    transport:
    # a metre above its place the crew takes hold of it
    chain {move_to(z, goal(z) + 1 m)};
    default:
    chain {move_to(z, goal(z))};
  };
};
)";

std::string table_text(const std::vector<Element>& elements) {
  std::string text = "component,ifc,x,y,z,turn_deg,length,width,depth,volume\n";
  for (const Element& e : elements) {
    text += fmt::format("{},{},{},{},{},{},{},{},{},{}\n", e.name, e.ifc_name, e.top.x(), e.top.y(),
                        e.top.z(), e.turn_deg, rounded(e.size.x()), rounded(e.size.y()),
                        rounded(e.size.z()), rounded(e.volume));
  }
  return text;
}

void write(const std::filesystem::path& file, std::string_view text) {
  std::ofstream out(file, std::ios::binary);
  out << text;
  out.close();
  if (!out) throw std::runtime_error("cannot write " + file.string());
}

void write_scene(const std::string& ifc, const std::filesystem::path& folder, bool bad_order) {
  std::vector<Element> elements = read_elements(ifc);
  const std::vector<std::size_t> order = laying_order(elements);
  std::optional<std::size_t> from_below;
  std::vector<std::size_t> lifting_order = order;
  if (bad_order) {
    from_below = last_gap(elements);
    const auto place = std::find(lifting_order.begin(), lifting_order.end(), *from_below);
    std::rotate(lifting_order.begin(), place, place + 1);
  }
  load_truck(elements, lifting_order);
  std::filesystem::create_directories(folder);
  for (const Element& element : elements) {
    write(folder / (element.name + ".obj"), mesh_text(element));
  }
  write(folder / "crane.robot", kRobot);
  write(folder / "crane.motion", kMotion);
  write(folder / "elements.csv", table_text(elements));
  write(folder / "site.plan", plan_text(elements, order, from_below));
}

}  // namespace
}  // namespace rubicon::scenes

int main(int argc, char** argv) {
  const std::vector<std::string_view> words(argv + 1, argv + argc);
  const bool with_order = words.size() == 4 && words[2] == "--order";
  const bool bad = with_order && words[3] == "bad";
  if (words.size() != 2 && !(with_order && (bad || words[3] == "good"))) {
    fmt::print(stderr, "usage: make_schependomlaan IFC OUTDIR [--order good|bad]\n");
    return 2;
  }
  try {
    rubicon::scenes::write_scene(std::string(words[0]), words[1], bad);
  } catch (const std::exception& error) {
    fmt::print(stderr, "make_schependomlaan: {}\n", error.what());
    return 1;
  }
  return 0;
}
