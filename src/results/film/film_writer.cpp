#include "src/results/film/film_writer.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <iterator>
#include <utility>

#include "src/results/film/film_builder.hpp"
#include "src/simulation/trace/json_builder.hpp"

namespace rubicon::film {

namespace {

constexpr std::string_view kMagic = "RUBICONF";
constexpr std::uint32_t kVersion = 1;

void append_number(std::string& out, std::uint32_t number) {
  for (int shift = 0; shift < 32; shift += 8) out += static_cast<char>((number >> shift) & 255);
}

/// The columns one after the other, and the head's `columns`, which says where each stands.
class Body {
 public:
  Body() { directory_.begin_object(); }

  void add(std::string_view name, const Column& column) {
    directory_.key(name).begin_object();
    directory_.field("offset", static_cast<std::int64_t>(bytes_.size()));
    directory_.field("count", static_cast<std::int64_t>(column.count()));
    directory_.field("scale", column.scale()).field("delta", column.delta()).end_object();
    column.append_to(bytes_);
  }

  const std::string& bytes() const { return bytes_; }
  std::string directory() { return directory_.end_object().take(); }

 private:
  std::string bytes_;
  trace::JsonBuilder directory_;
};

/// The head's `tracks`; their keys go into columns.
std::string add_tracks(Body& body, const std::vector<Track>& tracks) {
  Column t(kMillionth, true);
  Column q(kMillionth, true);
  trace::JsonBuilder json;
  json.begin_array();
  for (const Track& track : tracks) {
    json.begin_object().field("robot", track.robot).field("run", track.run);
    json.field("first", static_cast<std::int64_t>(t.count()));
    json.field("count", static_cast<std::int64_t>(track.keys.count()));
    json.field("q", static_cast<std::int64_t>(q.count())).end_object();
    t.add(track.keys.t());
    for (const Column& parameter : track.keys.q()) q.add(parameter);
  }
  body.add("key.t", t);
  body.add("key.q", q);
  return json.end_array().take();
}

std::string strings_json(const StringTable& strings) {
  trace::JsonBuilder json;
  json.begin_array();
  for (const std::string* text : strings.texts()) json.value(std::string_view(*text));
  return json.end_array().take();
}

std::string places_json(const PlaceTable& places) {
  trace::JsonBuilder json;
  json.begin_array();
  for (const Place& place : places.places()) {
    json.begin_array().value(place.file).value(place.line).value(place.column).end_array();
  }
  return json.end_array().take();
}

}  // namespace

Film FilmBuilder::finish(std::string_view schedule, std::string_view flow) {
  Body body;
  for (std::size_t i = 0; i < scene_.meshes.size(); ++i) {
    body.add(fmt::format("mesh.{}.vertices", i), scene_.meshes[i].vertices);
    body.add(fmt::format("mesh.{}.triangles", i), scene_.meshes[i].triangles);
  }
  for (const auto& [name, column] : columns_.take()) body.add(name, column);
  const std::string tracks = add_tracks(body, tracks_->take_tracks());

  std::string head = "{\"header\":" + scene_.json;
  head += ",\"schedule\":" + (schedule.empty() ? std::string("null") : tidy_json(schedule));
  head += ",\"flow\":" + (flow.empty() ? std::string("null") : tidy_json(flow));
  if (!movings_.empty()) {
    trace::JsonBuilder json;
    json.begin_array();
    for (const MovingStop& each : movings_) {
      json.begin_object().field("name", each.name).field("by", each.by);
      json.field("delay", each.delay).field("t", each.t).end_object();
    }
    head += ",\"movings\":" + json.end_array().take();
  }
  const auto list = [](trace::JsonBuilder& json, const char* name,
                       const std::vector<double>& values) {
    json.key(name).begin_array();
    for (const double value : values) json.value(value);
    json.end_array();
  };
  if (!soils_.empty()) {
    trace::JsonBuilder json;
    json.begin_array();
    for (const SoilTaken& each : soils_) {
      json.begin_object().field("run", each.run).field("component", each.component);
      json.field("t", each.t);
      list(json, "cells", each.cells);
      list(json, "heights", each.heights);
      json.end_object();
    }
    head += ",\"soils\":" + json.end_array().take();
  }
  if (!foreseen_.empty()) {
    trace::JsonBuilder json;
    json.begin_array();
    for (const ForeseenWay& each : foreseen_) {
      json.begin_object().field("run", each.run).field("machine", each.machine);
      json.field("seconds", each.seconds).field("t", each.t);
      list(json, "corners", each.corners);
      list(json, "points", each.points);
      json.end_object();
    }
    head += ",\"foreseen\":" + json.end_array().take();
  }
  if (!walks_.empty()) {
    trace::JsonBuilder json;
    json.begin_array();
    for (const Walk& each : walks_) {
      json.begin_object().field("run", each.run).field("t", each.t);
      list(json, "way", each.way);
      json.key("events").strings(each.events).end_object();
    }
    head += ",\"walks\":" + json.end_array().take();
  }
  if (!graphs_.empty()) {
    trace::JsonBuilder json;
    json.begin_array();
    for (const SearchGraph& each : graphs_) {
      json.begin_object().field("run", each.run).field("t", each.t).field("legs", each.legs);
      list(json, "graph", each.values);
      if (const auto& grid = each.forbidden) {
        json.key("forbidden").begin_object();
        json.key("parameters").strings(grid->parameters);
        list(json, "low", grid->low);
        list(json, "high", grid->high);
        list(json, "cells", grid->cells);
        list(json, "layers", grid->layers);
        list(json, "at", grid->at);
        list(json, "runs", grid->runs);
        json.end_object();
      }
      json.end_object();
    }
    head += ",\"graphs\":" + json.end_array().take();
  }
  head += ",\"end\":";
  trace::append_number(head, runs_.end());
  head += ",\"strings\":" + strings_json(strings_);
  head += ",\"places\":" + places_json(places_);
  head += ",\"runs\":" + runs_json(runs_);
  head += ",\"tracks\":" + tracks;
  head += ",\"columns\":" + body.directory() + "}";

  Film film{scene_.plan, std::string(kMagic)};
  append_number(film.bytes, kVersion);
  append_number(film.bytes, static_cast<std::uint32_t>(head.size()));
  film.bytes += head;
  film.bytes += body.bytes();
  return film;
}

FilmWriter::FilmWriter() : builder_(std::make_unique<FilmBuilder>()) {}
FilmWriter::FilmWriter(FilmWriter&&) noexcept = default;
FilmWriter& FilmWriter::operator=(FilmWriter&&) noexcept = default;
FilmWriter::~FilmWriter() = default;

void FilmWriter::line(std::string_view text) { builder_->line(text); }
void FilmWriter::restart() { builder_ = std::make_unique<FilmBuilder>(); }
bool FilmWriter::has_header() const { return builder_->has_header(); }
Film FilmWriter::finish(std::string_view schedule, std::string_view flow) {
  return builder_->finish(schedule, flow);
}

}  // namespace rubicon::film
