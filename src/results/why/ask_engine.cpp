#include "src/results/why/ask_engine.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <variant>

#include "src/motion/math/turns.hpp"
#include "src/motion/robot/kinematics.hpp"
#include "src/results/why/scene.hpp"

namespace rubicon::why {

namespace {

/// m: what is farther off is no near miss.
constexpr double kMissRange = 5;
/// m: what is nearer than this where a way begins or ends stands there on purpose.
constexpr double kTouchGap = 0.01;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

const replay::TaskRun* run_of(const replay::Replay& replay, const std::string& task) {
  const replay::TaskRun* found = nullptr;
  for (const replay::TaskRun& run : replay.runs) {
    if (run.task >= 0 && replay.header.tasks[index(run.task)].name == task) found = &run;
  }
  return found;
}

/// A robot's own numbers of its parameters.
class Parameters {
 public:
  explicit Parameters(const replay::Machine& machine) : machine_(machine) {
    const auto& all = machine.model.parameters;
    for (std::size_t i = 0; i < all.size(); ++i) numbers_.emplace(all[i].display_name, i);
  }

  std::optional<std::size_t> number(const std::string& name) const {
    const auto found = numbers_.find(name);
    return found == numbers_.end() ? std::nullopt : std::optional(found->second);
  }
  std::optional<std::vector<double>> values(const Configuration& q) const {
    std::vector<double> result(numbers_.size());
    if (q.size() != result.size()) return std::nullopt;
    for (const auto& [name, value] : q) {
      const auto i = number(name);
      if (!i) return std::nullopt;
      result[*i] = value;
    }
    return result;
  }
  std::vector<double> after(const std::vector<double>& q, const std::vector<double>& steps) const {
    std::vector<double> next = q;
    robot::apply_rules(machine_.model, machine_.mounting, q, steps, next);
    return next;
  }
  bool cyclic(std::size_t i) const { return machine_.model.parameters[i].cyclic; }

 private:
  const replay::Machine& machine_;
  std::map<std::string, std::size_t> numbers_;
};

class Questions {
 public:
  Questions(const replay::Replay& replay, const replay::TaskRun& run, TaskStory& story)
      : replay_(replay),
        run_(run),
        story_(story),
        scene_(replay, run),
        parameters_(scene_.machine()) {}

  void ask() {
    story_.contact_tolerance = scene_.contact_tolerance();
    for (Motion& motion : story_.motions) {
      if (motion.first_hit) {
        ask_about(*motion.first_hit);
        motion.way = way_to_goal(*motion.first_hit, motion);
      }
      for (Attempt& attempt : motion.last) {
        if (!attempt.met.empty()) ask_about(attempt);
      }
    }
    if (run_.happened && story_.run.result == "done") story_.nearest = nearest_miss();
  }

 private:
  struct Step {
    std::vector<double> q;
    std::vector<double> steps;
  };

  /// The step as the command wanted it; nothing where the trace does not say.
  std::optional<Step> step_of(const Attempt& attempt) const {
    const auto q = parameters_.values(attempt.q);
    if (!q || attempt.steps.size() != attempt.parameters.size()) return std::nullopt;
    Step step{*q, std::vector<double>(q->size(), 0.0)};
    for (std::size_t i = 0; i < attempt.steps.size(); ++i) {
      const auto number = parameters_.number(attempt.parameters[i]);
      if (!number) return std::nullopt;
      step.steps[*number] = attempt.steps[i];
    }
    return step;
  }

  std::vector<Blocked> blocking(const Step& step) const {
    const std::vector<double> q_to = parameters_.after(step.q, step.steps);
    return scene_.blocking({step.q, q_to});
  }

  void set_moment(const Attempt& attempt) {
    scene_.set_moment({std::llround(attempt.t * 1e9), attempt.trace_line});
  }

  void ask_about(Attempt& attempt) {
    const auto step = step_of(attempt);
    if (!step) return;
    set_moment(attempt);
    for (const Blocked& pair : blocking(*step)) {
      if (pair.moved != attempt.moved || pair.met != attempt.met) continue;
      attempt.contact = pair.contact;
      break;
    }
    attempt.origin = scene_.origin_of(attempt.met);
  }

  /// The same command, but all the way to the goal: how far its parameters would have to go.
  std::optional<Step> whole_way(const Attempt& attempt, const Motion& motion) const {
    auto step = step_of(attempt);
    if (!step) return std::nullopt;
    for (const std::string& name : attempt.parameters) {
      const std::size_t i = *parameters_.number(name);
      const auto named = [&](const auto& each) { return each.first == name; };
      const auto off = std::find_if(motion.residual.begin(), motion.residual.end(), named);
      const auto end = std::find_if(motion.at_end.begin(), motion.at_end.end(), named);
      if (off == motion.residual.end() || end == motion.at_end.end()) continue;
      double way = end->second + off->second - step->q[i];
      if (parameters_.cyclic(i)) {
        way = math::normalised_deg(way);
        if (way * step->steps[i] < 0) way = math::other_way_round_deg(way);
      }
      // What goes the other way goes round something, not to the goal.
      if (way * step->steps[i] > 0 && std::fabs(way) > std::fabs(step->steps[i])) {
        step->steps[i] = way;
      }
    }
    return step;
  }

  std::vector<InTheWay> way_to_goal(const Attempt& attempt, const Motion& motion) {
    const auto way = whole_way(attempt, motion);
    if (!way) return {};
    set_moment(attempt);
    std::vector<InTheWay> result;
    for (const Blocked& pair : blocking(*way)) {
      const auto known = std::find_if(result.begin(), result.end(),
                                      [&](const InTheWay& each) { return each.met == pair.met; });
      if (known == result.end()) {
        result.push_back({pair.moved, pair.met, pair.contact.free_to, scene_.origin_of(pair.met)});
      } else if (pair.contact.free_to < known->from) {
        known->moved = pair.moved;
        known->from = pair.contact.free_to;
      }
    }
    std::stable_sort(result.begin(), result.end(),
                     [](const InTheWay& a, const InTheWay& b) { return a.from < b.from; });
    return result;
  }

  // ---- the nearest miss

  /// A step that was made.
  struct Made {
    const replay::Leg* leg = nullptr;
    int line = 0;
    int number = 0;   ///< of the attempt
    int segment = 0;  ///< pick-ups and set-downs before it
  };

  /// The steps of the robot's runs before this one, in the order in which its track has them.
  std::size_t steps_before() const {
    std::vector<const replay::TaskRun*> runs;
    for (const replay::TaskRun& run : replay_.runs) {
      if (run.happened && run.robot == run_.robot) runs.push_back(&run);
    }
    std::stable_sort(
        runs.begin(), runs.end(),
        [](const replay::TaskRun* a, const replay::TaskRun* b) { return a->start < b->start; });
    std::size_t count = 0;
    for (const replay::TaskRun* run : runs) {
      if (run == &run_) break;
      count += static_cast<std::size_t>(
          std::count_if(run->events.begin(), run->events.end(), [](const replay::Event& event) {
            return std::holds_alternative<replay::Step>(event.what);
          }));
    }
    return count;
  }

  std::vector<Made> steps_made() const {
    std::vector<const replay::Leg*> legs;
    for (const replay::Leg& leg : replay_.tracks[index(run_.robot)].legs) {
      if (leg.moves()) legs.push_back(&leg);
    }
    std::vector<Made> made;
    std::size_t next = steps_before();
    int segment = 0;
    for (const replay::Event& event : run_.events) {
      if (std::holds_alternative<replay::LoadChange>(event.what) ||
          std::holds_alternative<replay::LoadTurn>(event.what)) {
        ++segment;
      }
      if (!std::holds_alternative<replay::Step>(event.what) || next >= legs.size()) continue;
      const std::size_t number = made.size();
      made.push_back({legs[next++], event.line,
                      number < story_.made.size() ? story_.made[number] : 0, segment});
    }
    return made;
  }

  void set_moment(const Made& step) { scene_.set_moment({step.leg->from, step.line}); }

  std::optional<NearestMiss> nearest_miss() {
    const std::vector<Made> steps = steps_made();
    if (steps.empty()) return std::nullopt;
    NearestMiss nearest;
    nearest.range = kMissRange;
    nearest.at_least = std::numeric_limits<double>::infinity();
    std::set<std::string> touched;
    for (std::size_t first = 0; first < steps.size();) {
      std::size_t last = first;
      while (last + 1 < steps.size() && steps[last + 1].segment == steps[first].segment) ++last;
      look_along({steps.begin() + static_cast<std::ptrdiff_t>(first),
                  steps.begin() + static_cast<std::ptrdiff_t>(last + 1)},
                 touched, nearest);
      first = last + 1;
    }
    if (!nearest.found) nearest.at_least = nearest.range;
    nearest.touched.assign(touched.begin(), touched.end());
    return nearest;
  }

  /// One way, from one pick-up or set-down to the next.
  void look_along(const std::vector<Made>& steps, std::set<std::string>& touched,
                  NearestMiss& nearest) {
    Touches touches;
    set_moment(steps.front());
    scene_.add_touches(steps.front().leg->q0, kTouchGap, touches);
    set_moment(steps.back());
    scene_.add_touches(steps.back().leg->q1, kTouchGap, touches);
    for (const auto& [part, name] : touches) touched.insert(name);
    if (!story_.component.empty()) {
      touched.insert(story_.component);
      for (int part = 0; part < scene_.part_count(); ++part) {
        touches.emplace(part, story_.component);
      }
    }
    for (const Made& step : steps) {
      set_moment(step);
      if (!scene_.look_for_miss({step.leg->q0, step.leg->q1}, touches, nearest)) continue;
      nearest.step = step.number;
      nearest.time = trace::seconds(step.leg->from);
    }
  }

  const replay::Replay& replay_;
  const replay::TaskRun& run_;
  TaskStory& story_;
  Scene scene_;
  Parameters parameters_;
};

}  // namespace

void ask_engine(const replay::Replay& replay, TaskStory& story) {
  const replay::TaskRun* run = run_of(replay, story.task);
  if (run == nullptr || run->robot < 0) return;
  try {
    Questions(replay, *run, story).ask();
  } catch (const std::invalid_argument& error) {
    story.no_scene = error.what();
  }
}

}  // namespace rubicon::why
