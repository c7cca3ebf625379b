#pragma once

#include <optional>
#include <string>
#include <vector>

#include "src/results/flow/lane_flow.hpp"
#include "src/results/replay/replay.hpp"

namespace rubicon::flow {

/// What became of a component from the beginning of the plan to its end (1995 paper, section 1: the
/// flow of material).
struct ComponentFlow {
  std::string name;
  double mass = 0;       ///< kg
  std::string from;      ///< storage place where it stands at the beginning; "": none
  std::string to;        ///< where it stands at the end
  bool removed = false;  ///< it is gone at the end
  int lifts = 0;         ///< times it was picked up
  Ticks waiting = 0;     ///< it lay before it was picked up, all lifts together
  Ticks carried = 0;     ///< it hung on a machine
  double distance = 0;   ///< m: the way of the middle of the box round it while it hung
  int refused = 0;       ///< steps that were refused while it hung
};

/// The stock of a storage place from a moment on.
struct Stock {
  Ticks time = 0;
  int count = 0;
  double mass = 0;  ///< kg
};

/// What lies in a storage place: components whose box has its middle there.
struct StorageFlow {
  std::string name;
  int in = 0;                      ///< components that were set down there
  int out = 0;                     ///< components that were taken from there
  std::vector<Stock> stock;        ///< from time 0 on, one entry for each change
  Stock most;                      ///< when the count was greatest, first
  std::optional<Ticks> mean_stay;  ///< of those that were taken
};

struct MaterialFlow {
  std::string plan;
  Ticks end = 0;
  std::vector<ComponentFlow> components;  ///< as the header has them
  std::vector<StorageFlow> storages;
  LaneFlow lanes;
};

/// What happened counts: the tries of a rejected task do not. Throws std::invalid_argument for
/// shapes without extent.
MaterialFlow material_flow(const replay::Replay& replay);

/// A table of components that were moved, one of storage places, and of a plan with fleets one of
/// vehicles and one of the nodes where they waited.
std::string flow_text(const MaterialFlow& flow);
/// The components, a line each.
std::string flow_csv(const MaterialFlow& flow);
/// Everything; times in seconds.
std::string flow_json(const MaterialFlow& flow);

}  // namespace rubicon::flow
