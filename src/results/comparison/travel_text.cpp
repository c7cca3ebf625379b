#include <fmt/format.h>

#include <algorithm>

#include "src/results/comparison/compare_travel.hpp"
#include "src/results/report/columns.hpp"
#include "src/simulation/trace/json_builder.hpp"

namespace rubicon::comparison {

namespace {

using travel::Event;
using travel::Vec2;

/// So many events of a way are in the table.
constexpr std::size_t kMostEvents = 30;

std::string place_text(const Vec2& p) { return fmt::format("({:.2f}, {:.2f})", p.x(), p.y()); }

std::string names_text(const Event& event, const char* separator) {
  return fmt::format("{}", fmt::join(event.obstacles, separator));
}

void write_place(trace::JsonBuilder& json, const Vec2& p) {
  json.begin_array().value(p.x()).value(p.y()).end_array();
}

}  // namespace

std::string travel_text(const TravelComparison& comparison) {
  const double distance = (comparison.destination - comparison.start).norm();
  std::string text = fmt::format(
      "{}: {} travels from {} to {}, {:.2f} m, without a map; obstacles as they stand at the "
      "beginning: {}{}\n",
      comparison.plan, comparison.task, place_text(comparison.start),
      place_text(comparison.destination), distance, comparison.obstacles,
      comparison.movings > 0 ? fmt::format(", of which {} keep a timetable", comparison.movings)
                             : std::string());
  text += comparison.radius > 0
              ? fmt::format(
                    "the machine is a disc of {:.2f} m, which holds it however it is turned\n\n",
                    comparison.radius)
              : std::string("the machine has no shape and is a point\n\n");
  std::vector<report::TableRow> rows = {
      {"method", "verdict", "length m", "time s", "at most m", "events"}};
  for (const TravelTrial& trial : comparison.trials) {
    if (!trial.result) {
      rows.push_back({std::string(travel::name_of(trial.method)), "for standing obstacles only",
                      "-", "-", "-", "-"});
      continue;
    }
    const travel::TravelResult& result = *trial.result;
    rows.push_back({std::string(travel::name_of(trial.method)),
                    std::string(travel::name_of(result.verdict)),
                    fmt::format("{:.2f}", result.length), fmt::format("{:.1f}", result.time),
                    result.bound ? fmt::format("{:.2f}", result.bound->length) : "-",
                    std::to_string(result.events.size())});
  }
  text += report::columns(rows, {2, 3, 4, 5});
  if (comparison.movings == 0) {
    text += comparison.shortest >= 0
                ? fmt::format("who knows the map goes {:.2f} m\n", comparison.shortest)
                : std::string("there is no way\n");
  }
  for (const TravelTrial& trial : comparison.trials) {
    if (!trial.result) continue;
    text += fmt::format("\n{}\n", travel::name_of(trial.method));
    std::size_t shown = 0;
    for (const Event& event : trial.result->events) {
      if (++shown > kMostEvents) {
        text += fmt::format("  ... and {} more: --format csv has all\n",
                            trial.result->events.size() - kMostEvents);
        break;
      }
      text += fmt::format("  {:>9.2f} s  {:<14} {}", event.time, travel::name_of(event.kind),
                          place_text(event.point));
      if (!event.obstacles.empty()) text += "  " + names_text(event, ", ");
      text += '\n';
    }
  }
  return text;
}

std::string travel_csv(const TravelComparison& comparison) {
  std::string text = "method,verdict,length,event,time,x,y,obstacles\n";
  for (const TravelTrial& trial : comparison.trials) {
    if (!trial.result) continue;
    for (const Event& event : trial.result->events) {
      text += fmt::format("{},{},{},{},{},{},{},{}\n", travel::name_of(trial.method),
                          travel::name_of(trial.result->verdict), trial.result->length,
                          travel::name_of(event.kind), event.time, event.point.x(), event.point.y(),
                          report::csv_field(names_text(event, ";")));
    }
  }
  return text;
}

std::string travel_json(const TravelComparison& comparison) {
  trace::JsonBuilder json;
  json.begin_object().field("plan", comparison.plan).field("task", comparison.task);
  json.field("radius", comparison.radius).key("start");
  write_place(json, comparison.start);
  write_place(json.key("destination"), comparison.destination);
  json.key("shortest");
  if (comparison.shortest >= 0) {
    json.value(comparison.shortest);
  } else {
    json.null();
  }
  json.key("methods").begin_array();
  for (const TravelTrial& trial : comparison.trials) {
    if (!trial.result) continue;
    const travel::TravelResult& result = *trial.result;
    json.begin_object().field("method", travel::name_of(trial.method));
    json.field("verdict", travel::name_of(result.verdict)).field("length", result.length);
    json.field("time", result.time);
    if (result.bound) {
      json.key("bound").begin_object().field("length", result.bound->length);
      json.field("distance", result.bound->distance).field("perimeters", result.bound->perimeters);
      json.field("crossings", result.bound->crossings).end_object();
    }
    json.key("events").begin_array();
    for (const Event& event : result.events) {
      json.begin_object().field("kind", travel::name_of(event.kind)).field("t", event.time);
      write_place(json.key("at"), event.point);
      json.key("obstacles").strings(event.obstacles).end_object();
    }
    json.end_array().key("way").begin_array();
    for (const travel::WayPoint& point : result.way) write_place(json, point.point);
    json.end_array().key("modes").begin_array();
    for (const travel::WayPoint& point : result.way) json.value(static_cast<int>(point.mode));
    json.end_array().end_object();
  }
  json.end_array().end_object();
  return json.take() + '\n';
}

}  // namespace rubicon::comparison
