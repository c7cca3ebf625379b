#include "src/results/gltf/document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include "src/motion/math/index.hpp"
#include "src/results/gltf/animation.hpp"
#include "src/results/gltf/envelopes.hpp"
#include "src/results/gltf/looks.hpp"
#include "src/results/gltf/meshes.hpp"
#include "src/results/gltf/motion_curves.hpp"
#include "src/results/gltf/nodes.hpp"
#include "src/results/gltf/ropes.hpp"

namespace rubicon::gltf {

namespace {

using replay::Machine;
using replay::RobotTrack;
using replay::Stay;
using replay::Ticks;
using robot::FrameElement;

using math::at;

/// Places and stops of one thing with a timetable; after more of them it is not there any more.
constexpr std::size_t kMostStretches = 20'000;

/// s, of an animation whose speed nobody chose: the length with which the report page begins.
constexpr double kUsualLength = 60;

/// As long as that, but never slower than it was.
double usual_speed_up(double seconds) { return std::max(seconds / kUsualLength, 1.0); }

/// What the scene is moved by so that it is near its origin: whole metres.
Vec3 offset_of(const trace::TraceHeader& scene) {
  Eigen::AlignedBox3d box;
  for (const auto& robot : scene.robots) box.extend(Vec3(robot.X_WM.translation()));
  for (const auto& component : scene.components) box.extend(Vec3(component.X_WO.translation()));
  if (box.isEmpty() || box.max().cwiseMax(-box.min()).maxCoeff() < kFar) return Vec3::Zero();
  const Vec3 middle = box.center();
  return {std::floor(middle.x()), std::floor(middle.y()), 0};
}

class DocumentBuilder {
 public:
  DocumentBuilder(const replay::Replay& replay, const FilmOptions& options)
      : replay_(replay),
        scene_(replay.header),
        offset_(offset_of(replay.header)),
        seconds_(trace::seconds(replay.last)),
        speed_up_(options.speed_up > 0 ? options.speed_up : usual_speed_up(seconds_)),
        meshes_(data_),
        looks_(replay.header.components),
        animation_(speed_up_, data_) {}

  Document build() {
    add_root();
    add_site();
    for (const Stay& stay : replay_.stays) add_stay(stay);
    for (std::size_t i = 0; i < replay_.machines.size(); ++i) add_robot(i);
    for (const replay::TaskRun& run : replay_.runs) add_zones(run);
    for (std::size_t i = 0; i < scene_.movings.size(); ++i) add_moving(i);
    return finish();
  }

 private:
  /// Turns z up into y up; then x points to the right, and y away.
  void add_root() {
    root_ = nodes_.add(-1, scene_.plan);
    nodes_.place(root_, math::rotation_x_deg(-90));
  }

  Pose near(const Pose& X_W) const {
    Pose X = X_W;
    X.translation() -= offset_;
    return X;
  }

  void add_site() {
    const auto use = meshes_.use(scene_.site, looks_.ground());
    if (!use) return;
    const int node = nodes_.add(root_, "site");
    if (!offset_.isZero(0)) nodes_.place(node, near(Pose::Identity()));
    nodes_.show(node, *use);
  }

  /// The tasks that move a component.
  Json tasks_of(int component) const {
    Json tasks = Json::array();
    if (component < 0) return tasks;
    for (const trace::HeaderTask& task : scene_.tasks) {
      if (task.move == scene_.components[at(component)].name) tasks.push_back(task.name);
    }
    return tasks;
  }

  void set_extras(int node, Json extras, const trace::HeaderAttributes& attributes) {
    if (!attributes.empty()) {
      Json& texts = extras["attributes"] = Json::object();
      for (const auto& [key, text] : attributes) texts[key] = text;
    }
    nodes_.set(node, "extras", std::move(extras));
  }

  void add_presence(int node, Ticks from, Ticks to) {
    const Presence presence{trace::seconds(from), trace::seconds(to)};
    if (animation_.add_presence(node, presence, trace::seconds(replay_.until))) {
      nodes_.set(node, "scale", {0.0, 0.0, 0.0});
    }
  }

  void add_stay(const Stay& stay) {
    const trace::HeaderComponent& component = scene_.components[at(stay.component)];
    const bool placed = stay.from > 0;
    const auto use = meshes_.use(component.shapes,
                                 placed ? looks_.placed(at(stay.component)) : looks_.waiting());
    if (stay.from >= stay.to) return;
    const int node = nodes_.add(root_, component.name);
    nodes_.place(node, near(stay.X_WO));
    set_extras(node,
               {{"component", component.name},
                {"is", placed ? "placed" : "waiting"},
                {"tasks", tasks_of(stay.component)}},
               component.attributes);
    if (use) nodes_.show(node, *use);
    add_presence(node, stay.from, stay.to);
  }

  /// The zones of people of a task that was done, as long as it goes on.
  void add_zones(const replay::TaskRun& run) {
    if (!run.happened || run.task < 0 || run.start >= run.end) return;
    const trace::HeaderTask& task = scene_.tasks[at(run.task)];
    const auto use = meshes_.use(task.zones, looks_.zone());
    if (!use) return;
    const int node = nodes_.add(root_, "zone of " + task.name);
    nodes_.place(node, near(Pose::Identity()));
    set_extras(node, {{"task", task.name}, {"is", "zone"}}, task.attributes);
    nodes_.show(node, *use);
    add_presence(node, run.start, run.end);
  }

  /// What keeps a timetable, as long as it is on the site.
  void add_moving(std::size_t number) {
    const trace::HeaderMoving& moving = scene_.movings[number];
    const std::vector<trace::MovingStretch> stretches = trace::moving_stretches(
        moving.timetable, replay_.moving_stops[number], replay_.until, kMostStretches);
    const auto use = meshes_.use(moving.shapes, looks_.moving(!moving.overhead.empty()));
    if (!use || stretches.empty()) return;
    const int node = nodes_.add(root_, moving.name);
    nodes_.place(node, near(stretches.front().X_from));
    set_extras(node, {{"moving", moving.name}}, {});
    nodes_.show(node, *use);
    add_presence(node, stretches.front().from, stretches.back().to);
    std::vector<Animation::PoseKey> keys;
    bool moves = false;
    for (const trace::MovingStretch& each : stretches) {
      moves = moves || each.kind == trace::MovingStretch::Kind::goes;
      if (keys.empty()) keys.push_back({trace::seconds(each.from), near(each.X_from)});
      keys.push_back({trace::seconds(each.to), near(each.X_to)});
    }
    keys_ += 2 * keys.size();
    if (keys_ > kMostKeys) throw std::invalid_argument("expected a film within bounds");
    if (moves) animation_.add_poses(node, keys);
  }

  void add_robot(std::size_t number) {
    const Machine& robot = replay_.machines[number];
    const robot::RobotModel& model = robot.model;
    const RobotTrack& track = replay_.tracks[number];
    const int mounting = nodes_.add(root_, robot.name);
    nodes_.place(mounting, near(robot.mounting.X_WM));
    nodes_.set(mounting, "extras", {{"robot", robot.name}});
    const std::vector<FrameCurves> curves = motion_curves(robot, track);
    keys_ += film_keys(curves);
    if (keys_ > kMostKeys) throw std::invalid_argument("expected a film within bounds");
    const std::vector<bool> envelopes = envelopes_of(robot);
    std::vector<int> body_nodes;
    for (std::size_t i = 0; i < model.bodies.size(); ++i) {
      const robot::Body& body = model.bodies[i];
      const int parent = body.parent < 0 ? mounting : body_nodes[at(body.parent)];
      const int node = add_frame(parent, robot.name + "." + body.name, curves[i]);
      body_nodes.push_back(node);
      const Look look = envelopes[i] ? looks_.envelope(number) : looks_.body(number, i);
      if (const auto use = meshes_.use(body.shapes, look)) nodes_.show(node, *use);
    }
    const std::optional<Rope> rope = rope_of(robot, curves);
    if (rope) add_rope(robot, body_nodes[at(rope->above)], *rope);
    const int tool =
        add_frame(body_nodes[at(model.tool_body)], robot.name + " tool", curves.back());
    add_loads(tool, robot, track, rope.has_value());
  }

  void add_rope(const Machine& robot, int above, const Rope& rope) {
    const auto use = meshes_.use({rope_shape()}, looks_.rope());
    const int node = nodes_.add(above, robot.name + " rope");
    nodes_.set(node, "scale", {1.0, 1.0, rope.start});
    nodes_.show(node, *use);
    if (!rope.length.empty()) animation_.add_length(node, rope.length);
  }

  /// A node for each element; the last carries the name of the frame, and is returned.
  int add_frame(int parent, const std::string& name, const FrameCurves& elements) {
    if (elements.empty()) return nodes_.add(parent, name);
    int node = parent;
    for (std::size_t i = 0; i < elements.size(); ++i) {
      const bool last = i + 1 == elements.size();
      node = nodes_.add(node, last ? name : fmt::format("{} {}", name, i + 1));
      place_element(node, elements[i]);
    }
    return node;
  }

  void place_element(int node, const ElementCurve& element) {
    const Vec3& start = element.start;
    if (element.kind == FrameElement::Kind::trans) {
      if (!start.isZero(0)) nodes_.set(node, "translation", {start.x(), start.y(), start.z()});
    } else if (start.x() != 0) {
      const Eigen::Vector4d turn = turn_of(element.kind, start.x());
      nodes_.set(node, "rotation", {turn.x(), turn.y(), turn.z(), turn.w()});
    }
    if (!element.keys.empty()) animation_.add_element(node, element);
  }

  /// Legs with the same load, one after the other.
  void add_loads(int tool, const Machine& robot, const RobotTrack& track, bool hangs) {
    const auto& [name, model, mounting] = robot;
    for (std::size_t i = 0; i < track.legs.size();) {
      const int hanging = track.legs[i].hanging;
      const Ticks from = track.legs[i].from;
      Ticks to = from;
      const std::vector<double>& last = track.legs[i].q0;
      for (; i < track.legs.size() && track.legs[i].hanging == hanging; ++i) {
        to = track.legs[i].to;
      }
      if (hanging < 0 || from >= to) continue;
      const replay::Hanging& load = track.loads[at(hanging)];
      if (load.turn_deg == 0) {
        add_load(tool, load, from, to, hangs);
      } else {
        // It begins as the leg before it stands.
        add_turned_load(tool, load, robot::tool_pose(model, mounting, last), from, to, hangs);
      }
    }
  }

  /// While people turn it the load hangs on a frame that is upright.
  void add_turned_load(int tool, const replay::Hanging& load, const Pose& X_WT, Ticks from,
                       Ticks to, bool hangs) {
    Pose upright = Pose::Identity();
    upright.linear() = X_WT.linear();
    const int frame = nodes_.add(tool, "upright");
    nodes_.place(frame, upright.inverse(Eigen::Isometry));
    const int turning = nodes_.add(frame, "turned by people");
    ElementCurve curve;
    curve.kind = FrameElement::Kind::rotz;
    curve.keys = {{trace::seconds(from), Vec3::Zero()},
                  {trace::seconds(to), Vec3(load.turn_deg, 0, 0)}};
    animation_.add_element(turning, curve);
    add_load(turning, {load.component, upright * load.X_TO, 0}, from, to, hangs);
  }

  /// `hangs`: on a rope, and so on slings.
  void add_load(int tool, const replay::Hanging& load, Ticks from, Ticks to, bool hangs) {
    const bool nameless = load.component < 0;
    const std::string name = nameless ? "load" : scene_.components[at(load.component)].name;
    const int node = nodes_.add(tool, name);
    nodes_.place(node, load.X_TO);
    set_extras(
        node, {{"component", name}, {"is", "carried"}, {"tasks", tasks_of(load.component)}},
        nameless ? trace::HeaderAttributes{} : scene_.components[at(load.component)].attributes);
    const auto& shapes = nameless ? scene_.carry : scene_.components[at(load.component)].shapes;
    if (const auto use = meshes_.use(shapes, looks_.carried())) nodes_.show(node, *use);
    if (hangs) {
      const auto use = meshes_.use(slings(shapes, load.X_TO), looks_.rope());
      if (use) nodes_.show(nodes_.add(node, "slings"), *use);
    }
    add_presence(node, from, to);
  }

  Document finish() {
    Document document;
    Json extras = {{"plan", scene_.plan}, {"seconds", seconds_}, {"speed_up", speed_up_}};
    if (scene_.start_at) extras["start_at"] = *scene_.start_at;
    if (!offset_.isZero(0)) extras["origin"] = {offset_.x(), offset_.y(), offset_.z()};
    document.json["asset"] = {
        {"version", "2.0"}, {"generator", "rubicon export"}, {"extras", std::move(extras)}};
    document.json["scene"] = 0;
    document.json["scenes"] =
        Json::array({{{"name", scene_.plan}, {"nodes", Json::array({root_})}}});
    nodes_.finish(document.json);
    meshes_.finish(document.json);
    animation_.finish(document.json);
    document.binary = data_.finish(document.json);
    return document;
  }

  const replay::Replay& replay_;
  const trace::TraceHeader& scene_;
  const Vec3 offset_;
  const double seconds_;
  const double speed_up_;
  std::size_t keys_ = 0;  ///< of all robots
  BinaryData data_;
  Meshes meshes_;
  const Looks looks_;
  Animation animation_;
  Nodes nodes_;
  int root_ = 0;
};

}  // namespace

Document make_document(const replay::Replay& replay, const FilmOptions& options) {
  return DocumentBuilder(replay, options).build();
}

}  // namespace rubicon::gltf
