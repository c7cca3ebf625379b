#include "src/results/why/story_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "src/results/report/schedule_text.hpp"
#include "src/simulation/trace/record.hpp"

namespace rubicon::why {

namespace {

/// Of a long chain of waits the last are shown.
constexpr std::size_t kShownWaits = 15;

interpreter::Ticks ticks(double seconds) { return std::llround(seconds * 1e9); }

std::string span_text(double seconds) { return report::clock_text(ticks(seconds)); }

std::string moment(const TaskStory& story, double time) {
  return story.start_at ? report::moment_text(*story.start_at, ticks(time)) : span_text(time);
}

std::string pose_text(const Configuration& q) {
  std::string text;
  for (const auto& [name, value] : q) {
    text += fmt::format("{}{} {:g}", text.empty() ? "" : ", ", name, value);
  }
  return text;
}

std::string command_text(const Attempt& attempt) {
  std::string text = fmt::format("{}({})", attempt.command, fmt::join(attempt.parameters, ", "));
  if (attempt.line > 0) text += fmt::format(" in {}, line {}", attempt.file, attempt.line);
  return text;
}

std::string outcome_text(const Attempt& attempt) {
  if (attempt.ok) return "accepted";
  if (!attempt.met.empty()) return fmt::format("{} meets {}", attempt.moved, attempt.met);
  if (attempt.reason == "at goal") return "is there already";
  if (attempt.reason == "no direction") return "has no direction";
  if (attempt.reason.starts_with("limit ")) return "is at the limit of " + attempt.reason.substr(6);
  return attempt.reason;
}

std::string point_text(const math::Vec3& p) {
  return fmt::format("({:.3f}, {:.3f}, {:.3f})", p.x(), p.y(), p.z());
}

/// Who put it there, and when.
std::string origin_text(const TaskStory& story, const std::string& name, const Origin& origin) {
  const std::string when = origin.task.empty() ? "" : moment(story, origin.since);
  switch (origin.kind) {
    case Origin::Kind::site:
      return name + " is part of the site";
    case Origin::Kind::zone:
      return fmt::format("{}: people work there since {}", name, when);
    case Origin::Kind::own:
      return name + " belongs to the machine itself";
    case Origin::Kind::component:
      if (origin.task.empty()) break;
      return fmt::format("{} stands there since {} set it down at {}", name, origin.task, when);
    case Origin::Kind::machine:
      if (origin.task.empty()) break;
      return fmt::format("{} stands there since task {} {} {}", name, origin.task,
                         origin.at_work ? "began at" : "ended at", when);
  }
  return name + " stands there from the beginning";
}

std::string contact_text(const TaskStory& story, const Attempt& attempt) {
  const ContactAnswer& contact = *attempt.contact;
  std::string text = fmt::format("      free for {:.1f} % of the step; then they meet at {}",
                                 100 * contact.free_to, point_text(contact.point_W));
  if (contact.depth_at_end > story.contact_tolerance) {
    text += fmt::format(", at its end {} would be {:.3f} m deep in {}", attempt.moved,
                        contact.depth_at_end, attempt.met);
  } else if (contact.free_to < 1) {
    text += ", and part again before its end or lie inside each other";
  }
  return text + fmt::format(" (contact tolerance {:g} mm)\n", 1000 * story.contact_tolerance);
}

/// What the first hit meets, who put it there, what comes behind it.
std::string obstacle_text(const TaskStory& story, const Motion& motion) {
  const Attempt& hit = *motion.first_hit;
  std::string text;
  if (hit.contact) text += contact_text(story, hit);
  if (hit.origin) text += fmt::format("      {}\n", origin_text(story, hit.met, *hit.origin));
  if (motion.way.size() < 2) return text;
  text += "      on the way to the goal it would meet:\n";
  for (const InTheWay& each : motion.way) {
    text += fmt::format("        {:5.1f} %  {} meets {}", 100 * each.from, each.moved, each.met);
    if (each.origin && each.met != hit.met && each.origin->kind != Origin::Kind::site) {
      text += "; " + origin_text(story, each.met, *each.origin);
    }
    text += "\n";
  }
  return text;
}

/// How near it came to what it did not touch.
std::string miss_text(const TaskStory& story) {
  const NearestMiss& nearest = *story.nearest;
  std::string text = "  nearest miss: ";
  if (nearest.found) {
    text += fmt::format(
        "{} passed {} at {:.3f} m in step {}, at {}, between {} and {}; proved: "
        "nothing came nearer than {:.3f} m",
        nearest.moved, nearest.met, nearest.at_most, nearest.step, moment(story, nearest.time),
        point_text(nearest.moved_point_W), point_text(nearest.met_point_W), nearest.at_least);
  } else {
    text += fmt::format("proved: nothing came nearer than {:g} m", nearest.range);
  }
  if (!nearest.touched.empty()) {
    text += fmt::format(" (what it touched where a way began or ended left out: {})",
                        fmt::join(nearest.touched, ", "));
  }
  return text + "\n";
}

/// What was tried, and how often it ended in the same way, in the order in which it came first.
std::string tried_text(const Motion& motion) {
  struct Tried {
    std::string text;
    int first = 0;
    int count = 0;
  };
  std::vector<Tried> all;
  for (const Attempt& attempt : motion.last) {
    const std::string text = command_text(attempt) + ": " + outcome_text(attempt);
    const auto known =
        std::find_if(all.begin(), all.end(), [&](const Tried& each) { return each.text == text; });
    if (known == all.end()) {
      all.push_back({text, attempt.n, 1});
    } else {
      ++known->count;
    }
  }
  std::string text;
  for (const Tried& each : all) {
    text += fmt::format("      step {}: {}{}\n", each.first, each.text,
                        each.count > 1 ? fmt::format(", {} times", each.count) : "");
  }
  return text;
}

/// `column_1: storey "0", type "IfcColumn"`; nothing without attributes.
std::string attributes_text(const std::string& whose, const Attributes& attributes) {
  if (attributes.empty()) return {};
  std::string text;
  for (const auto& [name, value] : attributes) {
    text += fmt::format("{}{} \"{}\"", text.empty() ? "" : ", ", name, value);
  }
  return fmt::format("  {}: {}\n", whose, text);
}

/// What guides planned for the motion: the last ones, with what a travelling one met.
std::string guides_text(const Motion& motion) {
  constexpr std::size_t kShownPlans = 3;
  constexpr std::size_t kShownEvents = 12;
  std::string text;
  const std::size_t count = motion.guides.size();
  const std::size_t first = count > kShownPlans ? count - kShownPlans : 0;
  if (first > 0) text += fmt::format("    guides planned {} times, the last are:\n", count);
  for (std::size_t i = first; i < count; ++i) {
    const GuideStory& guide = motion.guides[i];
    if (!guide.cause.empty()) {
      text +=
          fmt::format("    guide {} ({}) found no way: {}\n", guide.name, guide.kind, guide.cause);
    } else {
      text += fmt::format("    guide {} ({}): {} waypoint{}, {:.2f} m, {} tests of legs\n",
                          guide.name, guide.kind, guide.waypoints, guide.waypoints == 1 ? "" : "s",
                          guide.length, guide.checks);
    }
    for (std::size_t k = 0; k < std::min(guide.events.size(), kShownEvents); ++k) {
      text += "      " + guide.events[k] + "\n";
    }
    if (guide.events.size() > kShownEvents) {
      text += fmt::format("      and {} more\n", guide.events.size() - kShownEvents);
    }
  }
  return text;
}

std::string motion_text(const TaskStory& story, const Motion& motion) {
  std::string text = fmt::format("  {}, from {} to {}: {} steps tried, {} accepted", motion.what,
                                 moment(story, motion.from), moment(story, motion.to), motion.tries,
                                 motion.accepted);
  if (motion.reached) return text + ", reached\n" + guides_text(motion);
  const bool on_purpose = story.run.result == "done" && motion.status == "done";
  text += fmt::format("; {}{}\n", on_purpose ? "it ended short, as it may: " : "",
                      motion.message.empty() ? motion.status : motion.message);
  text += guides_text(motion);
  if (motion.first_hit) {
    text += fmt::format("    first blocked at step {}: {}: {}\n      there {}\n",
                        motion.first_hit->n, command_text(*motion.first_hit),
                        outcome_text(*motion.first_hit), pose_text(motion.first_hit->q));
    text += obstacle_text(story, motion);
  }
  if (!motion.last.empty()) text += "    what it tried there:\n" + tried_text(motion);
  if (!motion.at_end.empty()) text += fmt::format("    it ended at {}\n", pose_text(motion.at_end));
  return text;
}

std::string pause_text(const Span& pause) {
  if (pause.what == "machine") return pause.whom + " was in the way";
  if (pause.what == "crew" || pause.what == "truck") return "waited for " + pause.whom;
  if (pause.what == "held") return "was done, and held by its link to " + pause.whom;
  if (pause.what == "repair") return pause.whom + " was under repair";
  return "out of shift";
}

std::string waits_text(const TaskStory& story) {
  std::string text;
  const std::size_t count = story.waits.size();
  const std::size_t first = count > kShownWaits ? count - kShownWaits : 0;
  if (first > 0) text += fmt::format("  ... {} before\n", first);
  for (std::size_t i = first; i < count; ++i) {
    text += fmt::format("  {}  {}\n", moment(story, story.waits[i].start), story.waits[i].text);
  }
  return text;
}

std::string turn_text(const TaskStory& story, const LoadTurn& turn) {
  std::string text =
      fmt::format("  people turned {} by {:.6g} degrees about the vertical, from {} to {}\n",
                  turn.component, turn.angle_deg, moment(story, turn.from), moment(story, turn.to));
  if (!turn.refused.first.empty()) {
    text += fmt::format("    the longer way: by {:.6g} degrees {} would have met {}\n",
                        turn.angle_deg - std::copysign(360.0, turn.angle_deg), turn.refused.first,
                        turn.refused.second);
  }
  return text;
}

}  // namespace

std::string story_text(const TaskStory& story) {
  const TaskRun& run = story.run;
  std::string text = fmt::format("{} is {}", story.task, run.result);
  if (!run.reason.empty()) text += ": " + run.reason;
  text += "\n";
  text += attributes_text(story.task, story.attributes);
  text += attributes_text(story.component, story.component_attributes);
  if (run.result == "not reached") return text;
  if (trace::has_happened(run.result)) {
    double work = 0;
    for (const Span& each : story.works) work += each.time;
    double moved = 0;
    for (const Motion& each : story.motions) moved += each.to - each.from;
    text += fmt::format("  from {} to {}, {}: motion {}, crew work {}\n", moment(story, run.start),
                        moment(story, run.end), span_text(run.end - run.start), span_text(moved),
                        span_text(work));
  } else {
    text += fmt::format("  it would have begun at {}; it was undone\n", moment(story, run.start));
  }
  if (story.detail != "steps" && !story.robot.empty()) {
    text +=
        "  the trace has no single steps: run with --trace-detail steps to see what was tried\n";
  }
  for (const Span& pause : story.pauses) {
    const std::string why = pause.what == "lift" ? fmt::format("its lift starts {}: {}",
                                                               moment(story, pause.to), pause.whom)
                                                 : pause_text(pause);
    text += fmt::format("  {} from {}: {}\n", span_text(pause.to - pause.from),
                        moment(story, pause.from), why);
  }
  if (story.overtime > 0) {
    text += fmt::format("  its load hung for {} out of the shifts of its lift: overtime\n",
                        span_text(story.overtime));
  }
  bool told = false;
  for (const Motion& motion : story.motions) {
    const bool after_turn = story.turn && !told && motion.from >= story.turn->to;
    if (after_turn) text += turn_text(story, *story.turn);
    told = told || after_turn;
    if (motion.tries > 0 || !motion.reached) text += motion_text(story, motion);
  }
  if (story.turn && !told) text += turn_text(story, *story.turn);
  if (story.nearest) text += miss_text(story);
  if (!story.no_scene.empty()) {
    text += fmt::format("  the collision engine could not be asked again: {}\n", story.no_scene);
  }
  if (!story.waits.empty()) text += "why it began when it did:\n" + waits_text(story);
  return text;
}

}  // namespace rubicon::why
