#include <nlohmann/json.hpp>

#include "src/results/why/story_text.hpp"

namespace rubicon::why {

namespace {

using nlohmann::ordered_json;

ordered_json pose_json(const Configuration& q) {
  ordered_json result = ordered_json::object();
  for (const auto& [name, value] : q) result[name] = value;
  return result;
}

ordered_json attributes_json(const Attributes& attributes) {
  ordered_json result = ordered_json::object();
  for (const auto& [name, text] : attributes) result[name] = text;
  return result;
}

ordered_json point_json(const math::Vec3& p) { return {p.x(), p.y(), p.z()}; }

const char* name_of(Origin::Kind kind) {
  switch (kind) {
    case Origin::Kind::site:
      return "site";
    case Origin::Kind::component:
      return "component";
    case Origin::Kind::zone:
      return "zone";
    case Origin::Kind::machine:
      return "machine";
    case Origin::Kind::own:
      return "own";
  }
  return "";
}

/// Without `task` it was there from the beginning.
ordered_json origin_json(const Origin& origin) {
  ordered_json result = {{"kind", name_of(origin.kind)}};
  if (origin.task.empty()) return result;
  result["task"] = origin.task;
  result["since"] = origin.since;
  if (origin.kind == Origin::Kind::machine) result["at_work"] = origin.at_work;
  return result;
}

ordered_json contact_json(const ContactAnswer& contact) {
  return {{"free_to", contact.free_to},
          {"point", point_json(contact.point_W)},
          {"depth_at_end", contact.depth_at_end}};
}

ordered_json way_json(const std::vector<InTheWay>& way) {
  ordered_json result = ordered_json::array();
  for (const InTheWay& each : way) {
    result.push_back({{"hit", {each.moved, each.met}}, {"from", each.from}});
    if (each.origin) result.back()["obstacle"] = origin_json(*each.origin);
  }
  return result;
}

ordered_json miss_json(const NearestMiss& nearest) {
  ordered_json result = {{"range", nearest.range}, {"at_least", nearest.at_least}};
  if (nearest.found) {
    result["at_most"] = nearest.at_most;
    result["step"] = nearest.step;
    result["t"] = nearest.time;
    result["share"] = nearest.share;
    result["pair"] = {nearest.moved, nearest.met};
    result["points"] = {point_json(nearest.moved_point_W), point_json(nearest.met_point_W)};
  }
  result["touched"] = nearest.touched;
  return result;
}

ordered_json attempt_json(const Attempt& attempt) {
  ordered_json result = {
      {"step", attempt.n},       {"command", attempt.command}, {"parameters", attempt.parameters},
      {"file", attempt.file},    {"line", attempt.line},       {"ok", attempt.ok},
      {"reason", attempt.reason}};
  if (!attempt.met.empty()) result["hit"] = {attempt.moved, attempt.met};
  if (attempt.contact) result["contact"] = contact_json(*attempt.contact);
  if (attempt.origin) result["obstacle"] = origin_json(*attempt.origin);
  return result;
}

ordered_json motion_json(const Motion& motion) {
  ordered_json result = {
      {"what", motion.what},     {"from", motion.from},         {"to", motion.to},
      {"tries", motion.tries},   {"accepted", motion.accepted}, {"reached", motion.reached},
      {"status", motion.status}, {"message", motion.message},   {"hits", motion.hits}};
  for (const GuideStory& guide : motion.guides) {
    ordered_json each = {{"name", guide.name}, {"kind", guide.kind}};
    if (!guide.cause.empty()) each["cause"] = guide.cause;
    each["waypoints"] = guide.waypoints;
    each["checks"] = guide.checks;
    each["length"] = guide.length;
    if (!guide.events.empty()) each["events"] = guide.events;
    result["guides"].push_back(std::move(each));
  }
  if (motion.first_hit) {
    result["first_hit"] = attempt_json(*motion.first_hit);
    result["first_hit"]["q"] = pose_json(motion.first_hit->q);
    if (!motion.way.empty()) result["way_to_goal"] = way_json(motion.way);
  }
  result["last"] = ordered_json::array();
  for (const Attempt& attempt : motion.last) result["last"].push_back(attempt_json(attempt));
  result["q"] = pose_json(motion.at_end);
  return result;
}

}  // namespace

std::string story_json(const TaskStory& story) {
  ordered_json result = {{"task", story.task},         {"robot", story.robot},
                         {"result", story.run.result}, {"reason", story.run.reason},
                         {"start", story.run.start},   {"end", story.run.end}};
  if (story.start_at) result["start_at"] = schedule::text_of(*story.start_at);
  if (!story.attributes.empty()) result["attributes"] = attributes_json(story.attributes);
  if (!story.component.empty()) {
    result["component"] = {{"name", story.component}};
    if (!story.component_attributes.empty()) {
      result["component"]["attributes"] = attributes_json(story.component_attributes);
    }
  }
  result["motions"] = ordered_json::array();
  for (const Motion& motion : story.motions) result["motions"].push_back(motion_json(motion));
  result["works"] = ordered_json::array();
  for (const Span& work : story.works) {
    result["works"].push_back({{"what", work.what},
                               {"crew", work.whom},
                               {"from", work.from},
                               {"to", work.to},
                               {"time", work.time}});
  }
  if (story.turn) {
    result["turn"] = {{"component", story.turn->component},
                      {"angle", story.turn->angle_deg},
                      {"from", story.turn->from},
                      {"to", story.turn->to}};
    if (!story.turn->refused.first.empty()) {
      result["turn"]["refused"] = {{"moved", story.turn->refused.first},
                                   {"met", story.turn->refused.second}};
    }
  }
  result["pauses"] = ordered_json::array();
  for (const Span& pause : story.pauses) {
    result["pauses"].push_back(
        {{"why", pause.what}, {"for", pause.whom}, {"from", pause.from}, {"to", pause.to}});
  }
  if (story.contact_tolerance > 0) result["contact_tolerance"] = story.contact_tolerance;
  if (story.nearest) result["nearest_miss"] = miss_json(*story.nearest);
  if (story.overtime > 0) result["overtime"] = story.overtime;
  result["waits"] = ordered_json::array();
  for (const WaitStep& step : story.waits) {
    result["waits"].push_back({{"task", step.task}, {"start", step.start}, {"text", step.text}});
  }
  return result.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace rubicon::why
