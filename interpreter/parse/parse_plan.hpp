#pragma once

#include "grammar/plan.hpp"
#include "interpreter/parse/parse_guide.hpp"
#include "interpreter/syntax/grid.hpp"

/// The state of a plan's parse. Only for the parse_plan*.cpp files.
namespace rubicon::interpreter {

/// The items of a plan under construction. Tasks and components go to the module they stand in.
class PlanState : public GuideState {
 public:
  PlanState(const SourceMap& sources, FileId file, Diagnostics& diagnostics, const char* code,
            std::vector<std::string_view> item_words)
      : GuideState(sources, file, diagnostics, code, std::move(item_words)) {
    computes_numbers_ = true;
  }

  struct Checkpoint : ScriptState::Checkpoint {
    bool in_task = false;
    bool in_module = false;
    bool in_network = false;
    std::size_t network_blocks = 0;
    std::size_t task_blocks = 0;
    std::size_t module_blocks = 0;
    std::size_t plan_blocks = 0;
  };
  Checkpoint checkpoint() const {
    return {ScriptState::checkpoint(),
            in_task,
            in_module,
            in_network,
            network_blocks.size(),
            task_blocks.size(),
            module_blocks.size(),
            plan_blocks.size()};
  }
  void roll_back(const Checkpoint& checkpoint);

  /// Where items go: into the innermost block, or what it stands in.
  std::vector<syntax::PlanItem>& plan_items() {
    return plan_blocks.empty() ? plan.items : plan_blocks.back().items;
  }
  std::vector<syntax::ModulePart>& module_items() {
    return module_blocks.empty() ? module.items : module_blocks.back().items;
  }
  std::vector<syntax::TaskPart>& task_parts() {
    return task_blocks.empty() ? task.parts : task_blocks.back().items;
  }
  std::vector<syntax::NetworkPart>& network_parts() {
    return network_blocks.empty() ? network.parts : network_blocks.back().items;
  }
  template <typename Part>
  void add_to_network(Part part, const char* from) {
    part.span = span_from(from);
    network_parts().emplace_back(std::move(part));
  }
  /// The '{' of a `for` or `when` comes next; `head` is its head.
  void open_block(std::string_view word);
  void close_task_block(const char* from);
  void close_module_block(const char* from);
  void close_network_block(const char* from);
  void close_plan_block(const char* from);

  template <typename Item>
  void add(Item item, const char* from) {
    item.span = span_from(from);
    plan_items().emplace_back(std::move(item));
  }
  template <typename Item>
  void add_to_module(Item item, const char* from) {
    item.span = span_from(from);
    if (in_module) {
      module_items().emplace_back(std::move(item));
    } else {
      plan_items().emplace_back(std::move(item));
    }
  }
  /// An item that may stand in a task or in the plan itself.
  template <typename Item>
  void add_to_task(Item item, const char* from) {
    item.span = span_from(from);
    if (in_task) {
      task_parts().emplace_back(std::move(item));
    } else if constexpr (std::is_constructible_v<syntax::PlanItem, Item>) {
      plan_items().emplace_back(std::move(item));
    }
  }
  syntax::Name word(const char* from) const {
    return {std::string(from, last_end), span_from(from)};
  }
  syntax::Values take_values() {
    syntax::Values result = std::exchange(values, {});
    if (!result.values.empty()) {
      result.span = result.values.front().name.span;
      result.span.end = result.values.back().value.span.end;
    }
    return result;
  }
  void set_cost(const char* from);
  /// Of the task or the component that is being read.
  void add_attribute(const char* from);
  /// The last name, `NAME.x` as one text.
  syntax::Name take_dotted_name();
  /// A bare number, or one that is computed in parentheses.
  syntax::Number take_plain_number(const char* from) {
    return *from == '(' ? take_quantity() : number;
  }
  /// The cost that was just read is an amount for each hour.
  void divide_by_hour(const char* from);
  void add_import(const char* from);
  /// One more text of a `group`.
  void add_heading();

  syntax::Plan plan;
  syntax::ModuleItem module;
  bool in_module = false;
  syntax::TaskItem task;
  bool in_task = false;
  syntax::BlockHead head;
  std::vector<syntax::TaskBlock> task_blocks;  ///< open ones, the innermost last
  std::vector<syntax::ModuleBlock> module_blocks;
  std::vector<syntax::NetworkBlock> network_blocks;
  std::vector<syntax::PlanBlock> plan_blocks;
  syntax::PlanParameter parameter;

  syntax::Values values;
  syntax::QualifiedName value_name;
  syntax::Goal goal;
  std::vector<syntax::Link> links;
  bool lag_is_negative = false;
  std::vector<syntax::Name> names;
  syntax::Name key;
  syntax::Name storage;
  syntax::Name name;
  syntax::QualifiedName component_name;
  syntax::QualifiedName second_name;
  std::optional<syntax::Name> crew_of_work;
  std::optional<syntax::Name> turned;  ///< by crew work
  syntax::Number duration;
  std::optional<syntax::DurationLaw> law;  ///< in place of the duration
  syntax::Number quantity;
  syntax::String headings;  ///< of a group, joined
  syntax::WithinItem within;
  syntax::MotionClause clause_of_motion;
  /// A part of an area, or a clause of a cover, begins with its word.
  void begin_area_part(const char* from) {
    places.clear();
    area_part = {word(from), {}, {}, {}};
  }
  void add_area_part(const char* from) {
    area_part.places = std::move(places);
    area_part.span = span_from(from);
    area.parts.push_back(std::move(area_part));
  }
  void begin_cover_clause(const char* from) {
    places.clear();
    cover_clause = {};
    cover_clause.key = word(from);
  }
  void begin_earth_clause(const char* from) {
    earth_clause = {};
    earth_clause.key = word(from);
  }
  void add_earth_clause() { earth.clauses.push_back(std::move(earth_clause)); }
  void begin_dig_clause(const char* from) {
    dig_clause = {};
    dig_clause.key = word(from);
  }
  void add_dig_clause() { dig.clauses.push_back(std::move(dig_clause)); }
  void take_dig_duration() {
    dig_clause.duration = duration;
    dig_clause.law = law;
  }
  syntax::HaulItem haul;
  syntax::HaulItem::Clause haul_clause;
  void begin_haul_clause(const char* from) {
    haul_clause = {};
    haul_clause.key = word(from);
  }
  void add_haul_clause() { haul.clauses.push_back(std::move(haul_clause)); }
  void add_cover_clause() { cover.clauses.push_back(std::move(cover_clause)); }
  void begin_clause(const char* from) {
    clause_of_motion = {};
    clause_of_motion.key = word(from);
  }
  syntax::WholeItem whole;
  syntax::DateItem date;
  std::optional<syntax::Number> up_to;  ///< of the zone under way
  syntax::SupportItem support;
  syntax::Shift shift;
  syntax::String shift_from;
  syntax::CalendarItem calendar;
  syntax::ComponentItem component;
  syntax::MovingItem moving;
  std::vector<syntax::MovingItem::Place> path;
  syntax::Number path_time;
  syntax::Number place_x;
  std::vector<syntax::FloorPlace> places;
  syntax::AreaItem area;
  syntax::AreaItem::Part area_part;
  syntax::CoverItem cover;
  syntax::CoverItem::Clause cover_clause;
  syntax::EarthItem earth;
  syntax::EarthItem::Clause earth_clause;
  syntax::DigItem dig;
  syntax::DigItem::Clause dig_clause;
  syntax::RobotUse robot;
  syntax::CrewItem crew;
  bool in_crew = false;
  syntax::Charges& charges() { return in_crew ? crew.charges : robot.charges; }
  syntax::Number per_day;
  syntax::Rental rental;
  syntax::Overtime overtime;
  syntax::Fuel fuel;
  syntax::Breakdown breakdown;
  syntax::PoolItem pool;
  syntax::WorkspacesItem workspaces;
  syntax::NetworkItem network;
  bool in_network = false;
  syntax::PolicyItem policy;
  syntax::ErrandItem errand;
  syntax::LaneReportItem lane_report;
  syntax::BarrierItem barrier;
  syntax::GridItem grid;
  std::vector<syntax::GridItem> grids;
  syntax::GridItem::Agent grid_agent;
  syntax::GridItem::Job grid_job;
  /// The grid that is being read; what is in a block is noted.
  syntax::GridItem& add_to_grid(const char* from) {
    if (!network_blocks.empty()) grid.in_blocks.push_back(span_from(from));
    return grid;
  }
  syntax::LaneClassItem lane_class;
  syntax::NodeItem node;
  syntax::LaneItem lane;
  syntax::FleetItem fleet;
  syntax::ByItem by;
  syntax::NeedsItem needs;
  syntax::PlaceItem place;
  syntax::ImportItem import;
};

}  // namespace rubicon::interpreter
