#include "src/results/flow/material_flow.hpp"

#include <algorithm>
#include <cmath>

#include "src/motion/collision/swept_query.hpp"
#include "src/motion/geometry/extent.hpp"
#include "src/motion/math/index.hpp"
#include "src/motion/robot/kinematics.hpp"

namespace rubicon::flow {

namespace {

using replay::Leg;
using replay::LoadChange;

/// m: a component whose middle is no farther outside of a storage place is in it.
constexpr double kInStorage = 0.01;

/// The way of a leg is measured along chords, as many as it takes until twice as many change it by
/// no more than this share.
constexpr double kSameLength = 1e-4;
constexpr int kMostChords = 1024;

using math::at;

/// The middle of the box round some shapes, in their frame.
math::Vec3 middle_of(const std::vector<geometry::Shape>& shapes) {
  if (shapes.empty()) return math::Vec3::Zero();
  Eigen::AlignedBox3d box;
  for (const geometry::Shape& shape : shapes) box.extend(geometry::extent_of(shape));
  return box.center();
}

class Storages {
 public:
  explicit Storages(const std::vector<trace::HeaderStorage>& storages) {
    for (const trace::HeaderStorage& storage : storages) {
      bodies_.push_back(collision::prepare(storage.shapes));
    }
    if (bodies_.empty()) return;
    point_ = collision::prepare(
        {{geometry::Sphere{math::Vec3::Zero(), kInStorage}, math::Pose::Identity()}});
  }

  /// The first that holds the point (world); -1: none.
  int holding(const math::Vec3& p_W) const {
    const math::Pose X_WP = math::translation(p_W.x(), p_W.y(), p_W.z());
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      if (collision::overlaps(*bodies_[i], math::Pose::Identity(), *point_, X_WP, 0)) {
        return static_cast<int>(i);
      }
    }
    return -1;
  }

 private:
  std::vector<collision::BodyPtr> bodies_;
  collision::BodyPtr point_;
};

/// Length of the way of a point fixed to the tool frame while a leg lasts.
double way_length(const replay::Machine& machine, const Leg& leg, const math::Vec3& p_T) {
  const auto place = [&](double s) -> math::Vec3 {
    std::vector<double> q(leg.q0.size());
    for (std::size_t i = 0; i < q.size(); ++i) q[i] = leg.q0[i] + s * (leg.q1[i] - leg.q0[i]);
    return robot::tool_pose(machine.model, machine.mounting, q) * p_T;
  };
  const auto chords = [&](int count) {
    double length = 0;
    math::Vec3 last = place(0);
    for (int i = 1; i <= count; ++i) {
      const math::Vec3 next = place(static_cast<double>(i) / count);
      length += (next - last).norm();
      last = next;
    }
    return length;
  };
  double length = chords(2);
  for (int count = 4; count <= kMostChords; count *= 2) {
    const double finer = chords(count);
    const bool same = finer - length <= kSameLength * finer;
    length = finer;
    if (same) break;
  }
  return length;
}

void add_carrying(const replay::Replay& replay, const std::vector<math::Vec3>& middles,
                  std::vector<ComponentFlow>& components) {
  for (std::size_t robot = 0; robot < replay.tracks.size(); ++robot) {
    const replay::RobotTrack& track = replay.tracks[robot];
    for (const Leg& leg : track.legs) {
      if (leg.hanging < 0) continue;
      const replay::Hanging& load = track.loads[at(leg.hanging)];
      if (load.component < 0) continue;
      ComponentFlow& component = components[at(load.component)];
      component.carried += leg.to - leg.from;
      if (!leg.moves()) continue;
      component.distance +=
          way_length(replay.machines[robot], leg, load.X_TO * middles[at(load.component)]);
    }
  }
}

/// Steps that were refused while something hung on the machine of the run.
void add_refusals(const replay::TaskRun& run, std::vector<ComponentFlow>& components) {
  int hanging = -1;
  for (const replay::Event& event : run.events) {
    if (const auto* change = std::get_if<LoadChange>(&event.what)) {
      if (change->kind == LoadChange::Kind::attach) {
        hanging = change->component;
        ++components[at(hanging)].lifts;
      } else if (change->kind == LoadChange::Kind::detach) {
        hanging = -1;
      }
    } else if (hanging >= 0 && event.refused) {
      ++components[at(hanging)].refused;
    }
  }
}

/// A component comes to a storage place or leaves it.
struct Change {
  Ticks time = 0;
  int count = 0;
  double mass = 0;
};

StorageFlow storage_flow(std::string name, std::vector<Change> changes) {
  StorageFlow flow;
  flow.name = std::move(name);
  std::stable_sort(changes.begin(), changes.end(),
                   [](const Change& a, const Change& b) { return a.time < b.time; });
  flow.stock.push_back({});
  for (const Change& change : changes) {
    if (flow.stock.back().time != change.time) {
      flow.stock.push_back(flow.stock.back());
      flow.stock.back().time = change.time;
    }
    flow.stock.back().count += change.count;
    flow.stock.back().mass += change.mass;
  }
  // The masses of what came and went need not cancel to the last bit.
  for (Stock& stock : flow.stock) {
    if (stock.count == 0) stock.mass = 0;
  }
  flow.most = *std::max_element(flow.stock.begin(), flow.stock.end(),
                                [](const Stock& a, const Stock& b) { return a.count < b.count; });
  return flow;
}

}  // namespace

MaterialFlow material_flow(const replay::Replay& replay) {
  const trace::TraceHeader& header = replay.header;
  MaterialFlow flow;
  flow.plan = header.plan;
  flow.end = replay.last;
  std::vector<math::Vec3> middles;
  for (const trace::HeaderComponent& component : header.components) {
    middles.push_back(middle_of(component.shapes));
    ComponentFlow& each = flow.components.emplace_back();
    each.name = component.name;
    each.mass = component.mass;
    each.removed = true;  // unless it stands at the end
  }
  flow.lanes = lane_flow(replay);
  add_carrying(replay, middles, flow.components);
  for (const replay::TaskRun& run : replay.runs) {
    if (run.happened) add_refusals(run, flow.components);
  }

  const Storages storages(header.storages);
  std::vector<std::vector<Change>> changes(header.storages.size());
  struct Stays {
    int in = 0, out = 0, taken = 0;
    Ticks together = 0;
  };
  std::vector<Stays> stays(header.storages.size());
  for (const replay::Stay& stay : replay.stays) {
    ComponentFlow& component = flow.components[at(stay.component)];
    const bool to_the_end = stay.to >= replay.until;
    const int storage = storages.holding(stay.X_WO * middles[at(stay.component)]);
    const std::string name = storage < 0 ? "" : header.storages[at(storage)].name;
    if (stay.from == 0 && component.from.empty()) component.from = name;
    if (to_the_end) {
      component.to = name;
      component.removed = false;
    } else {
      component.waiting += stay.to - stay.from;
    }
    if (storage < 0) continue;
    Stays& counted = stays[at(storage)];
    changes[at(storage)].push_back({stay.from, 1, component.mass});
    if (stay.from > 0) ++counted.in;
    if (to_the_end) continue;
    changes[at(storage)].push_back({stay.to, -1, -component.mass});
    ++counted.out;
    counted.together += stay.to - stay.from;
  }
  for (std::size_t i = 0; i < header.storages.size(); ++i) {
    StorageFlow each = storage_flow(header.storages[i].name, std::move(changes[i]));
    each.in = stays[i].in;
    each.out = stays[i].out;
    if (stays[i].out > 0) each.mean_stay = stays[i].together / stays[i].out;
    flow.storages.push_back(std::move(each));
  }
  return flow;
}

}  // namespace rubicon::flow
