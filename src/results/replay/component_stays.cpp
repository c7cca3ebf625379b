#include "src/results/replay/component_stays.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace rubicon::replay {

namespace {

class StayBuilder {
 public:
  explicit StayBuilder(const std::vector<trace::HeaderComponent>& components) {
    for (const trace::HeaderComponent& component : components) {
      places_.push_back({true, component.X_WO, 0});
    }
  }

  void apply(const LoadChange& change, Ticks time) {
    leave(change.component, time);
    if (change.kind != LoadChange::Kind::detach) return;
    places_[static_cast<std::size_t>(change.component)] = {true, change.X, time};
  }

  std::vector<Stay> finish(Ticks until) {
    for (std::size_t i = 0; i < places_.size(); ++i) leave(static_cast<int>(i), until);
    std::stable_sort(stays_.begin(), stays_.end(),
                     [](const Stay& a, const Stay& b) { return a.component < b.component; });
    return std::move(stays_);
  }

 private:
  struct Place {
    bool stands = false;
    math::Pose X_WO = math::Pose::Identity();
    Ticks since = 0;
  };

  void leave(int component, Ticks time) {
    Place& place = places_[static_cast<std::size_t>(component)];
    if (place.stands) stays_.push_back({component, place.X_WO, place.since, time});
    place.stands = false;
  }

  std::vector<Place> places_;
  std::vector<Stay> stays_;
};

/// The changes of what happened, in the order of time.
std::vector<const Event*> load_events(const std::vector<TaskRun>& runs) {
  std::vector<const Event*> events;
  for (const TaskRun& run : runs) {
    if (!run.happened) continue;
    for (const Event& event : run.events) {
      if (std::holds_alternative<LoadChange>(event.what)) events.push_back(&event);
    }
  }
  std::sort(events.begin(), events.end(), [](const Event* a, const Event* b) {
    return std::tie(a->time, a->line) < std::tie(b->time, b->line);
  });
  return events;
}

}  // namespace

std::vector<Stay> component_stays(const std::vector<trace::HeaderComponent>& components,
                                  const std::vector<TaskRun>& runs, Ticks until) {
  StayBuilder builder(components);
  for (const Event* event : load_events(runs)) {
    builder.apply(std::get<LoadChange>(event->what), event->time);
  }
  return builder.finish(until);
}

}  // namespace rubicon::replay
