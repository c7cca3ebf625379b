#include "src/simulation/taskplan/checkpoint.hpp"

#include <algorithm>
#include <utility>

namespace rubicon::taskplan {

namespace {

/// No line of a trace is this task's.
constexpr int kNobody = -2;

}  // namespace

void Checkpoints::add(int task, Journal::Mark resources) {
  Checkpoint& point = checkpoints_.emplace_back();
  point.task = task;
  point.records = records_.mark();
  point.links = stage_.links->mark();
  point.resources = resources;
  point.choices = stage_.choices().mark();
  point.trace = stage_.trace.mark();
  point.site = stage_.site_changes.moment(stage_.robots());
  point.events = stage_.events;
  point.active = stage_.active;
  point.lifts = stage_.lifts;
  point.progress = stage_.progress;
  point.breakdowns = stage_.breakdowns;
  point.breakdown_outcomes = stage_.breakdown_outcomes.size();
  point.failed_parkings = stage_.failed_parkings.size();
  point.haulage = stage_.haulage;
  point.zone_waits = zone_waits_;
  point.zone_waits.erase(task);
}

void Checkpoints::drop(int task) {
  std::erase_if(checkpoints_, [&](const Checkpoint& point) { return point.task == task; });
  const bool none = checkpoints_.empty();
  const auto oldest = checkpoints_.begin();
  records_.forget_before(none ? records_.mark() : oldest->records);
  stage_.links->forget_before(none ? stage_.links->mark() : oldest->links);
  stage_.allocator->forget_before(none ? stage_.allocator->mark() : oldest->resources);
  stage_.choices().forget_before(none ? stage_.choices().mark() : oldest->choices);
  stage_.trace.release_before(none ? stage_.trace.mark() : oldest->trace);
  stage_.site_changes.forget_before(none ? stage_.site_changes.mark() : oldest->site.mark);
}

bool Checkpoints::go_back(int task, bool keeps_lines) {
  const auto place = std::find_if(checkpoints_.begin(), checkpoints_.end(),
                                  [&](const Checkpoint& point) { return point.task == task; });
  if (place == checkpoints_.end()) return false;
  Checkpoint point = std::move(*place);
  checkpoints_.erase(place, checkpoints_.end());
  records_.undo_to(point.records);
  stage_.links->undo_to(point.links);
  stage_.allocator->undo_to(point.resources);
  stage_.choices().undo_to(point.choices);
  stage_.trace.keep_only(point.trace, keeps_lines ? task : kNobody);
  stage_.events = std::move(point.events);
  stage_.active = std::move(point.active);
  stage_.lifts = std::move(point.lifts);
  stage_.progress = point.progress;
  stage_.breakdowns = std::move(point.breakdowns);
  stage_.breakdown_outcomes.resize(point.breakdown_outcomes);
  zone_waits_ = std::move(point.zone_waits);
  stage_.haulage = std::move(point.haulage);
  stage_.site_changes.go_back(point.site, stage_.now());
  // A parking that is under way again: one of the same robot that failed later never was.
  for (std::size_t i = 0; i < stage_.active.size(); ++i) {
    const int active = stage_.active[i].task;
    if (!stage_.is_park(active)) continue;
    stage_.trace.drop_kept(point.trace, active);
    auto& failed = stage_.failed_parkings;
    const auto later = failed.begin() + static_cast<std::ptrdiff_t>(point.failed_parkings);
    const std::string& name = stage_.spec(active).name;
    failed.erase(std::remove_if(later, failed.end(),
                                [&](const TaskOutcome& each) { return each.task == name; }),
                 failed.end());
  }
  return true;
}

}  // namespace rubicon::taskplan
