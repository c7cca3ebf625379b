#include "interpreter/check/check_plan_obstacles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>
#include <variant>

#include "interpreter/check/standing_components.hpp"
#include "src/motion/math/index.hpp"

namespace rubicon::interpreter::plan_check {

namespace {

/// m: what stands so little above the surface stands on it, however low the tool goes.
constexpr double kOnSurface = 0.01;
/// Units that obstacles keep off the outline, so that the tool keeps its clearance from them there
/// too: 1 mm.
constexpr std::int64_t kOffOutline = 10;

const syntax::CoverItem* cover_of(const syntax::TaskItem& item) {
  for (const syntax::TaskPart& part : item.parts) {
    if (const auto* cover = std::get_if<syntax::CoverItem>(&part)) return cover;
  }
  return nullptr;
}

class ObstacleCheck {
 public:
  explicit ObstacleCheck(Subject& subject) : subject_(subject) {}

  void run() {
    find_areas();
    if (areas_.empty()) return;
    for (const auto& [name, item] : subject_.task_items) {
      const auto task = subject_.tasks.find(name);
      if (task != subject_.tasks.end()) covers_.emplace_back(task->second, cover_of(*item));
    }
    for (const PlaceInfo& place : subject_.place_infos) {
      if (place.module < 0) continue;
      const auto& tasks = subject_.module_infos[math::at(place.module)].tasks;
      for (std::size_t i = 0; i < tasks.size(); ++i) {
        covers_.emplace_back(place.first_task + static_cast<int>(i), cover_of(*tasks[i]));
      }
    }
    std::sort(covers_.begin(), covers_.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
    const ComponentPlaces places(subject_.model);
    for (const auto& [task, item] : covers_) {
      if (item != nullptr) finish(task, *item, places);
    }
  }

 private:
  void find_areas() {
    for (const syntax::PlanItem& each : subject_.plan.items) {
      const auto* area = std::get_if<syntax::AreaItem>(&each);
      if (area == nullptr) continue;
      const bool has = std::any_of(area->parts.begin(), area->parts.end(),
                                   [](const auto& part) { return part.key.text == "obstacles"; });
      const auto index = subject_.areas.find(area->name.text);
      if (has && index != subject_.areas.end() && index->second >= 0) areas_.insert(index->second);
    }
  }

  void finish(int index, const syntax::CoverItem& item, const ComponentPlaces& places) {
    TaskSpec& task = subject_.model.tasks[math::at(index)];
    std::vector<TaskSpec*> ways;
    for (TaskSpec& choice : task.choices) ways.push_back(&choice);
    if (ways.empty()) ways.push_back(&task);
    if (!ways.front()->cover || areas_.count(ways.front()->cover->area) == 0) return;
    const AreaSpec& area = subject_.model.areas[math::at(ways.front()->cover->area)];
    coverage::FloorParts parts;
    if (!find_standing(index, item, area, *ways.front(), places, parts.columns)) return;
    if (parts.columns.empty()) return;
    add_floor(area, parts);
    const std::vector<coverage::MadeFloor> floors = make_floors(parts);
    if (floors.size() != 1) {
      subject_.error(
          "P54", item.area.span,
          floors.empty()
              ? fmt::format("components stand on all of area '{}'", area.name)
              : fmt::format("components part area '{}' into {} pieces while '{}' covers it",
                            area.name, floors.size(), task.name),
          floors.empty() ? "" : "cover each piece as an area of its own");
      return;
    }
    coverage::FloorDescription floor = floor_within(area, parts);
    floor.beams = area.floor.beams;
    auto way = resolve_cover_over(subject_, item, floor);
    if (!way) return;
    for (TaskSpec* each : ways) {
      each->cover = way->cover;
      each->via = way->goals;
      each->go = std::move(each->via.back());
      each->via.pop_back();
    }
  }

  /// What stands on an area while a task covers it; false where that is not certain.
  bool find_standing(int index, const syntax::CoverItem& item, const AreaSpec& area,
                     const TaskSpec& way, const ComponentPlaces& places,
                     std::vector<coverage::Standing>& standing) {
    FloorLayer layer;
    layer.surface = 0;
    layer.tool = std::max(way.cover->above, kOnSurface);
    const math::Pose X_AW = area.X_WA.inverse();
    const coverage::Region slab = slab_of(area);
    const std::vector<ComponentPlaces::Answer> answers = places.during(index);
    for (std::size_t c = 0; c < answers.size(); ++c) {
      const ComponentSpec& component = subject_.model.components[c];
      for (const ComponentPlaces::Place& place : answers[c].places) {
        if (!place.is_there) continue;
        std::vector<coverage::Standing> things = standing_in(component, X_AW * place.X_WO, layer);
        std::erase_if(things, [&](const auto& thing) { return !takes_from(slab, thing); });
        if (things.empty()) continue;
        if (answers[c].undecided >= 0) {
          const std::string& other = subject_.model.tasks[math::at(answers[c].undecided)].name;
          const std::string& name = subject_.model.tasks[math::at(index)].name;
          subject_.error(
              "P54", item.area.span,
              fmt::format("component '{}' may or may not stand on area '{}' while '{}' covers it: "
                          "task '{}' is not sure to be done before, nor to begin after",
                          component.name, area.name, name, other),
              fmt::format("write after {}; in '{}', or after {}; in '{}'", other, name, name,
                          other));
          return false;
        }
        for (auto& thing : things) standing.push_back(std::move(thing));
      }
    }
    return true;
  }

  /// The outline as the area has it, with what stands at it as holes just inside: at an outline the
  /// tool keeps no clearance, from holes it does.
  static coverage::FloorDescription floor_within(const AreaSpec& area,
                                                 const coverage::FloorParts& parts) {
    coverage::FloorParts inner = parts;
    inner.columns.clear();
    const coverage::Region slab{slab_of(area).outline, {}};
    for (const coverage::Standing& thing : parts.columns) {
      const coverage::Ring ring =
          thing.round ? square_around(thing.centre, thing.diameter) : thing.ring;
      std::vector<coverage::Region> inside = inside_outline({ring}, slab, kOffOutline);
      if (inside.size() == 1 &&
          coverage::twice_area(inside.front()) == coverage::twice_area(ring)) {
        inner.columns.push_back(thing);
        continue;
      }
      for (coverage::Region& each : inside) {
        inner.columns.push_back({thing.name, std::move(each.outline), false, {}, 0});
      }
    }
    std::vector<coverage::MadeFloor> floors = make_floors(inner);
    return std::move(floors.front().floor);
  }

  static coverage::Ring ring_of(const std::vector<coverage::Place>& places) {
    coverage::Ring ring;
    for (const coverage::Place& p : places) ring.push_back(coverage::snap(p));
    if (coverage::twice_area(ring) < 0) std::reverse(ring.begin(), ring.end());
    return ring;
  }
  static coverage::Region slab_of(const AreaSpec& area) {
    coverage::Region slab;
    slab.outline = ring_of(area.floor.outline);
    for (const auto& shaft : area.floor.shafts) slab.holes.push_back(ring_of(shaft.corners));
    return slab;
  }
  static coverage::Ring square_around(const coverage::Place& centre, double size) {
    const double half = size / 2;
    return coverage::Box{coverage::snap({centre.x - half, centre.y - half}),
                         coverage::snap({centre.x + half, centre.y + half})}
        .ring();
  }

  /// Whether a thing takes something of a slab; corners are rounded to the grid, so less than 1 cm2
  /// is nothing.
  static bool takes_from(const coverage::Region& slab, const coverage::Standing& thing) {
    constexpr std::int64_t kNothing = std::int64_t{2} * 100 * 100;
    const coverage::Ring ring =
        thing.round ? square_around(thing.centre, thing.diameter) : thing.ring;
    if (!coverage::box_of(ring).overlaps(coverage::box_of(slab.outline))) return false;
    std::int64_t left = 0;
    for (const auto& each : coverage::difference({slab}, {ring}))
      left += coverage::twice_area(each);
    return coverage::twice_area(slab) - left > kNothing;
  }

  /// What the area itself says. A column that a component stands for as well counts once.
  static void add_floor(const AreaSpec& area, coverage::FloorParts& parts) {
    parts.slabs = {slab_of(area)};
    for (const coverage::ColumnDescription& column : area.floor.columns) {
      const coverage::Ring ring = square_around(column.centre, column.size);
      const bool said =
          std::any_of(parts.columns.begin(), parts.columns.end(), [&](const auto& each) {
            return each.round ? column.round && ring == square_around(each.centre, each.diameter)
                              : !column.round && ring == each.ring;
          });
      if (said) continue;
      coverage::Standing thing;
      thing.name = column.name;
      thing.round = column.round;
      thing.centre = column.centre;
      thing.diameter = column.size;
      if (!column.round) thing.ring = ring;
      parts.columns.push_back(std::move(thing));
    }
  }

  Subject& subject_;
  std::set<int> areas_;
  std::vector<std::pair<int, const syntax::CoverItem*>> covers_;
};

}  // namespace

void finish_covers(Subject& subject) {
  if (!subject.diagnostics.has_errors()) ObstacleCheck(subject).run();
}

}  // namespace rubicon::interpreter::plan_check
