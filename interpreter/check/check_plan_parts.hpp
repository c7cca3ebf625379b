#pragma once

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "interpreter/check/check_guide.hpp"
#include "interpreter/check/plan_model.hpp"
#include "interpreter/check/resolve_shape.hpp"
#include "interpreter/syntax/name_suggestion.hpp"
#include "interpreter/syntax/syntax.hpp"

/// What the parts of load_plan share; nothing here is for other files.
namespace rubicon::interpreter::plan_check {

/// Most components and most tasks of a plan, placed modules counted as often as they are placed.
inline constexpr std::size_t kMaxElements = 200000;

/// Bounds of soil: density as it lies, kg/m3, and swell.
inline constexpr double kMostDensity = 1e5;
inline constexpr double kMostSwell = 10;

/// The names of a module, and its elements in file order.
struct ModuleInfo {
  const syntax::ModuleItem* item = nullptr;
  std::vector<const syntax::ComponentItem*> components;
  std::vector<const syntax::TaskItem*> tasks;
  std::map<std::string, int> component_index;
  std::map<std::string, int> task_index;
  std::vector<ComponentSpec> checked_components;  ///< before it is placed
  bool placed = false;
};

/// One placing of a module: where it stands and where its elements are in the model.
struct PlaceInfo {
  const syntax::PlaceItem* item = nullptr;
  int module = -1;
  math::Pose X_WP = math::Pose::Identity();  ///< where it is built
  math::Pose X_WS = math::Pose::Identity();  ///< its stock: where its components stand at first
  int first_component = 0;
  int first_task = 0;
};

/// Soil that a task takes from an earth.
struct DugSoil {
  int earth = -1;
  int component = -1;
  soil::CubicMillimetres volume = 0;
  std::shared_ptr<const soil::Terrain> before = {}, after = {};  // shared: they are large
};

/// Who digs in an earth.
struct EarthWork {
  struct Dig {
    const syntax::TaskItem* task = nullptr;
    std::set<int> after;  ///< digs of it that must be done before
    std::shared_ptr<const soil::Terrain> before = {}, below = {};  ///< as `DugSoil` has them
  };
  std::vector<Dig> digs = {};
  std::vector<int> last_dig = {};                 ///< by cell, -1: nobody
  std::shared_ptr<const soil::Terrain> now = {};  ///< after the last of them; shared: it is large
};

/// One plan on its way from syntax to model.
struct Subject {
  const syntax::Plan& plan;
  PlanModel& model;
  SourceMap& sources;
  FileProvider& files;
  Diagnostics& diagnostics;
  ShapeResolver& shapes;
  FormulaNames& names;
  NameSuggestions suggestions = {};

  std::map<std::string, Span> component_spans = {}, task_spans = {};
  std::map<std::string, int> components = {}, tasks = {};  ///< of the plan itself: model index
  std::map<std::string, int> robots = {}, crews = {}, calendars = {}, modules = {}, places = {},
                             pools = {}, areas = {},
                             earths = {};  ///< areas, earths: -1 of one that is wrong
  std::map<std::string, const syntax::TaskItem*> task_items = {};  ///< of the plan itself
  std::vector<EarthWork> earth_works = {};                         ///< as the earths of the model
  std::map<const syntax::DigItem*, std::optional<DugSoil>> dug = {};
  /// By file, unit and column; null of those that are wrong.
  std::map<std::array<std::string, 3>, std::shared_ptr<const sampling::MeasuredTimes>> measured =
      {};
  GuideDeclarations guides = {};
  std::map<std::string, Span> import_spans = {};
  std::set<std::uint32_t> without_grip = {};  ///< components, by where their names stand
  std::vector<ModuleInfo> module_infos = {};
  std::vector<PlaceInfo> place_infos = {};
  bool has_open_import = false;  ///< an import without a name of its own: any name may be from it

  /// Names that a broken part of the file or an import may declare are not complained about.
  bool judges_names() const { return !plan.broken && !has_open_import; }
  void error(std::string code, Span span, std::string message, std::string hint = {}) {
    diagnostics.error(std::move(code), span, std::move(message), std::move(hint));
  }
  void twice(Span second, std::string message, Span first);
  void use(std::string what, Span span) { model.uses.push_back({std::move(what), span}); }

  /// P01 with did-you-mean among the names of the given maps; `where` ends what is unknown.
  void unknown(Span span, const std::string& what, const std::string& name,
               std::initializer_list<const std::map<std::string, int>*> candidates,
               const std::string& where = {});
  /// The index of `name`; -1 after reporting that there is none.
  int find(const std::map<std::string, int>& index, const syntax::Name& name, const char* what);
};

/// Where the names of a task are looked up: in its module first, then in the plan.
struct Scope {
  const ModuleInfo* module = nullptr;
  int first_component = 0;
  int first_task = 0;
  math::Pose X_WP = math::Pose::Identity();
  bool records_uses = true;
  std::vector<PoolMember> members = {};  ///< who stands in the place of each pool
};

/// Of a module by itself, for what is wrong in it wherever it is placed.
Scope scope_of(const ModuleInfo& module);
/// Of a module where it is placed; the place must be of a module that is known.
Scope scope_of(const Subject& subject, const PlaceInfo& place);

/// The short form or the full form; P03, P04, P15.
void check_form(Subject& subject);

/// Gives every component, task, robot, crew, calendar, module and place its index: P02, P18.
void declare_names(Subject& subject);

/// site, contact, budget, start_at, currency, situation, import: P01, P02, P09, P10.
void check_settings(Subject& subject);

/// P02, P10, P11.
void check_calendars(Subject& subject);

/// Loads the robots, each file once; robots and crews with their items: P01, P02, P09, F01.
void check_robots(Subject& subject, const std::vector<std::string>& situations);
void check_crews(Subject& subject);

/// rental, mobilisation, overtime and fuel of `who` ("crew 'c'"), and what a component's material
/// or a day of the plan costs: P02, P09, P10.
Charges resolve_charges(Subject& subject, const syntax::Charges& charges, const std::string& who);
std::optional<double> resolve_money(Subject& subject, const syntax::Number& amount,
                                    const std::string& what);

/// The places of the nodes of a plan's networks.
class NodePlaces : public NoFormulaNames {
 public:
  explicit NodePlaces(const std::vector<NetworkSpec>& networks) : networks_(networks) {}
  /// P01 at a name that is unknown.
  std::optional<math::Pose> place_of(const syntax::QualifiedName& node,
                                     Diagnostics& diagnostics) override;

 private:
  const std::vector<NetworkSpec>& networks_;
};

/// Networks with their nodes and lanes: P01, P02, P09, P50. Before all that has frames.
void check_networks(Subject& subject);

/// The robots of a fleet as they would be written one by one; none after P02, P09, P51.
std::vector<syntax::RobotUse> members_of(Subject& subject, const syntax::FleetItem& item);
/// Fleets whose robots are there: where they stand, and their pools: P01, P02, P51, G04.
void check_fleets(Subject& subject);
/// A mass or density without a unit that can only be meant in tons: P22.
void warn_of_tons(Subject& subject, const syntax::Number& number, const std::string& what,
                  const char* unit);
/// The same of a mass that is too little for its shapes.
void check_light_mass(Subject& subject, const syntax::Number& mass, const std::string& what,
                      const std::vector<geometry::Shape>& shapes);

/// One pool: P01, P02, P40.
void add_pool(Subject& subject, const syntax::PoolItem& item);

/// Pools of robots or crews, which are declared before: P01, P02, P40.
void check_pools(Subject& subject);

/// Each choice of members that a task has by its pools; one that is empty for a task without. P40.
std::vector<std::vector<PoolMember>> choices_of(Subject& subject, const Scope& scope,
                                                const syntax::TaskItem& item);

/// Tasks `by same as` another come after it: P40.
void check_same_as(Subject& subject);

/// Components of the plan, and of modules where they are placed: P02, P09, P16, P17, P19.
void check_components(Subject& subject);

/// What keeps a timetable: P02, P09, P49.
void check_movings(Subject& subject);

/// Floors: P02, P09, P53.
void check_areas(Subject& subject);
/// What a task does that covers a floor, and the way of its tool, `via` and `go`; nothing after
/// P01, P02, P09, P54.
struct CoverWay {
  CoverSpec cover;
  std::vector<GoalSpec> goals;
};
std::optional<CoverWay> resolve_cover(Subject& subject, const syntax::CoverItem& item);

/// People of a crew that a task needs: all, where it does not say how many.
int people_of(const Subject& subject, const TaskSpec& task, int crew);

/// How a task digs whose crews of `by` are `diggers`, each with how many of it there are; nothing
/// after P01, P02, P05, P09, P52, P55. Before that `crews_of_dig` gives the crews that it names.
std::vector<int> crews_of_dig(Subject& subject, const syntax::DigItem& item);
struct CrewUnits {
  int crew = -1;
  int units = 0;
};
/// The ground: P01, P02, P09, P56.
void check_earths(Subject& subject);
/// What the dig of a task takes from its earth; nothing after P01, P56. The same whenever it is
/// asked.
std::optional<DugSoil> take_soil(Subject& subject, const Scope& scope, const syntax::DigItem& item,
                                 const syntax::TaskItem& task);
/// When all tasks are checked: what is left of the ground is part of the site. P56.
void finish_earths(Subject& subject);

std::optional<DigSpec> resolve_dig(Subject& subject, const syntax::DigItem& item,
                                   const std::optional<DugSoil>& soil,
                                   const std::vector<CrewUnits>& diggers,
                                   const std::function<int(int crew)>& units_of);
/// How the robot of a task digs with its own body; nothing after P01, P02, P09, P55.
std::optional<MotionDigSpec> resolve_motion_dig(Subject& subject, const syntax::DigItem& item,
                                                const DugSoil& soil, const RobotSpec& robot,
                                                const std::vector<int>& diggers,
                                                const std::function<int(int crew)>& units_of);
/// How the robot of a task hauls what others dig; nothing after P01, P02, P09, P62. What it takes
/// of each of them is said by `finish_hauls`, when all tasks are checked.
std::optional<HaulSpec> resolve_haul(Subject& subject, const Scope& scope,
                                     const syntax::HaulItem& item, const RobotSpec& robot);
void finish_hauls(Subject& subject);
/// Which machines keep their workspaces apart: P01, P02, P09, P63.
void check_workspaces(Subject& subject);
/// The law of a duration; nothing after P09, P52, F01.
std::optional<sampling::DurationLaw> resolve_law(Subject& subject,
                                                 const syntax::DurationLaw& written);
/// Times that were measured; nothing after P52, P58, F01.
std::shared_ptr<const sampling::MeasuredTimes> resolve_measured(Subject& subject,
                                                                const syntax::DurationLaw& written);
/// When a machine breaks down; nothing after P02, P09, P52, P59.
std::optional<BreakdownSpec> resolve_breakdown(Subject& subject,
                                               const std::vector<syntax::Breakdown>& written,
                                               const std::string& who);

/// Robots and components that stand too far apart for metres: P21.
void check_scale(Subject& subject);

/// Tasks of the plan and of modules: P01, P02, P05-P09, P12-P14, P19.
void check_tasks(Subject& subject);

/// What may overlap at the beginning, in the plan and in placed modules: P01, P30.
void check_waivers(Subject& subject);

/// support, and what components are fixed to or braced by, in the plan and in placed modules: P01,
/// P02, P05, P09.
void check_support(Subject& subject);

/// The mass (kg) of a component by its density; nothing after reporting P31.
std::optional<double> mass_by_density(Subject& subject, const syntax::ComponentItem& item,
                                      const std::vector<geometry::Shape>& shapes);

/// Components without mass that tasks give to machines with a load chart: P32.
void check_masses(Subject& subject);

/// A date and time in quotes; nothing after reporting P10.
std::optional<schedule::CivilTime> resolve_civil_time(Subject& subject,
                                                      const syntax::String& written);

/// The seconds that `what` takes, from 0 on; nothing after reporting P09. Warns of a bare number:
/// P22.
std::optional<double> resolve_duration(Subject& subject, const syntax::Number& number,
                                       const std::string& what);

/// Ticks from the beginning of the plan to a moment that `what` gives, below zero before it;
/// nothing after reporting P09, P10.
std::optional<schedule::Ticks> resolve_moment(Subject& subject, const syntax::Moment& moment,
                                              const std::string& what);

/// What a `whole` item says; nothing after reporting P09.
std::optional<bool> resolve_whole(Subject& subject, const syntax::WholeItem& item);

/// Calendars that carry over, so that what they are needed for is not lifted whole: P36.
void check_whole(Subject& subject);

/// One task in its scope, with all its choices.
void check_task(Subject& subject, const Scope& scope, const syntax::TaskItem& item, TaskSpec& task);

/// The guides that are declared in the plan, but for what a robot must say to them: G01-G03, G05.
void check_guides(Subject& subject);

/// The guides that a motion of the robot uses (null: nothing is said), each by its name in the plan
/// or else in the robot file: G03, G04, P01.
std::vector<guides::GuideSpec> resolve_guides(Subject& subject, const RobotSpec* robot,
                                              const syntax::GuideItem& item);

/// start, via, goal, carry, within of the short form.
void check_short_form(Subject& subject);

/// Adds one attribute of `who` ("task 't'") to `attributes`; `spans` has the keys seen so far. P02,
/// P19.
void add_attribute(Subject& subject, const syntax::AttributeItem& item, const std::string& who,
                   std::map<std::string, Span>& spans, Attributes& attributes);

/// Tasks that wait for each other: P08.
void check_cycles(Subject& subject);

/// Links of a task or a place. Nothing of one that is wrong (P01, P08, F09).
std::vector<LinkSpec> resolve_links(Subject& subject, const Scope& scope,
                                    const std::vector<syntax::Link>& links);

/// The task or component that `name` means in `scope`.
std::optional<int> find_task(Subject& subject, const Scope& scope,
                             const syntax::QualifiedName& name);
std::optional<int> find_component(Subject& subject, const Scope& scope,
                                  const syntax::QualifiedName& name);

enum class ValueUse { start, via, goal, park, within, near };

/// Parameter values of a robot (null or unusable: nothing is said). P12-P14, P09, F09.
std::vector<std::pair<int, double>> resolve_values(Subject& subject, const RobotSpec* robot,
                                                   const syntax::Values& values, ValueUse use);

/// The start values of a robot, those of the plan before its own, derived ones computed; P13 at
/// `span` where a given derived one differs.
void set_starts(Subject& subject, RobotSpec& robot,
                const std::vector<std::pair<int, double>>& values, Span span);

/// The control parameter of a robot that a name means; nothing after P12.
std::optional<int> find_parameter(Subject& subject, const RobotSpec& robot,
                                  const syntax::QualifiedName& name);

/// Adds what a clause says: P02, P09, P47, P48.
void resolve_clause(Subject& subject, const Scope& scope, const RobotSpec* robot,
                    const syntax::MotionClause& clause, MotionClauses& clauses);

/// Whether the clauses suit each other and the goals; `given`: where each stands. P47.
void check_clauses(Subject& subject, const RobotSpec* robot, const MotionClauses& clauses,
                   std::span<const GoalSpec> goals, bool moves_component,
                   const std::map<std::string, Span>& given);

/// A goal or waypoint; frames are relative to `X_WP`.
GoalSpec resolve_goal(Subject& subject, const RobotSpec* robot, const syntax::Goal& goal,
                      ValueUse use, const math::Pose& X_WP);

/// Adds one `within` item to `within`.
void resolve_within(Subject& subject, const RobotSpec* robot, const syntax::WithinItem& item,
                    Within& within);

/// A frame of the plan; identity after reporting what is wrong.
math::Pose resolve_frame_or_identity(Subject& subject, const syntax::Frame& frame);

/// A frame relative to `X_WP`, or the place of a node, in the world.
math::Pose resolve_placed_frame(Subject& subject, const syntax::Frame& frame,
                                const math::Pose& X_WP);

/// A number with a unit of that kind within bounds; nothing after reporting F09 or P09.
std::optional<double> bounded(Subject& subject, const syntax::Number& number, syntax::UnitKind unit,
                              const std::string& what, double lowest, double highest);

/// A whole number of attempts, at least 1.
std::optional<double> resolve_budget(Subject& subject, const syntax::Number& number);

/// The first of several things of which one is expected; P02 at the second.
template <typename T, typename SpanOf>
const T* only_one(Subject& subject, const std::vector<T>& items, const std::string& what,
                  const SpanOf& span_of) {
  if (items.empty()) return nullptr;
  if (items.size() > 1) {
    subject.twice(span_of(items[1]), what + " is given twice", span_of(items[0]));
  }
  return &items[0];
}

}  // namespace rubicon::interpreter::plan_check
