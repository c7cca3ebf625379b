#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "interpreter/syntax/dimension.hpp"
#include "interpreter/syntax/source.hpp"

/// The syntax trees of behaviour scripts (NAME.motion), robot files (NAME.robot) and plans
/// (NAME.plan): what was written, with its place, nothing resolved. Numbers are already in base
/// units (m, degrees, s, kg, m/s, degrees/s, 1/h as per s).
namespace rubicon::syntax {

using interpreter::Span;

// ---- names and values
// ------------------------------------------------------------------------------------------

struct Expression;
/// Shared, since the copies that a `for` makes share what is the same in all; nothing changes a
/// tree once it is built.
using ExpressionPtr = std::shared_ptr<Expression>;

struct Name {
  std::string text;  ///< Greek letters already spelt psi, phi, theta
  Span span;
  std::vector<ExpressionPtr> indices = {};  ///< of NAME[e, f], in plans until they are expanded
};

/// NAME or NAME.NAME; of what an imported plan places or imports `body` has dots of its own.
struct QualifiedName {
  std::optional<Name> body;
  Name name;
  Span span;
  std::string text() const { return body ? body->text + "." + name.text : name.text; }
};

/// A literal: 30, 2.5 mm, 6 m/s. `value` is in the base unit of its kind.
struct Number {
  double value = 0;
  UnitKind unit = UnitKind::none;
  std::string unit_text;  ///< as written, empty if bare
  Span span;
  Dimension dimension = {};       ///< what `unit` says, and more of UnitKind::compound
  ExpressionPtr expression = {};  ///< in plans until they are expanded: what is to be computed
};

struct String {
  std::string text;  ///< without quotes
  Span span;
};

struct Expression {
  enum class Kind {
    number,       ///< `number`
    parameter,    ///< `name`: a bare name, a control parameter
    variable,     ///< var(`name`)
    call,         ///< `name`(operands...)
    command,      ///< move_to(...) or the like where a value is wanted (S06); `name`
    negate,       ///< - operands[0]
    plus,         ///< + operands[0]
    logical_not,  ///< not operands[0]
    binary        ///< operands[0] `op` operands[1]
  };
  enum class Operator {
    add,
    subtract,
    multiply,
    divide,
    equal,
    not_equal,
    less,
    less_equal,
    greater,
    greater_equal,
    logical_and,
    logical_or
  };
  Kind kind = Kind::number;
  Number number;
  QualifiedName name;
  Operator op = Operator::add;
  Span op_span;  ///< the operator's own token
  std::vector<ExpressionPtr> operands;
  Span span;  ///< the whole expression (parentheses around it not included)
};

// ---- behaviour scripts
// -----------------------------------------------------------------------------------------

struct Statement;

/// `transport:`, `default:` or `when (c):`
struct Label {
  enum class Kind { situation, otherwise, when };
  Kind kind = Kind::situation;
  Name name;                ///< for a situation; "default" / "when" otherwise
  ExpressionPtr condition;  ///< for when
  Span span;
};

struct Module {
  std::vector<Label> labels;
  std::vector<Statement> statements;
};

/// A statement, or an element of a loop, or a part of `together`.
struct Statement {
  enum class Kind {
    assignment,  ///< var(`name`) = value
    move_to,     ///< move_to(`name`, value)
    move_dir,    ///< move_dir(`name`, value)
    together,    ///< together { elements }
    wait,
    use,  ///< `name`; runs a named behaviour
    chain,
    cycle,
    first,  ///< loops: { elements } [until (until)]
    each,
    which,
    broken  ///< did not parse; already reported, nothing else is said of it
  };
  Kind kind = Kind::broken;
  Span span;     ///< the whole statement
  Span keyword;  ///< its first token; what messages and traces point at
  QualifiedName name;
  ExpressionPtr value;
  std::vector<Statement> elements;
  ExpressionPtr until;
  std::vector<Module> modules;
};

/// behaviour NAME { statements }
struct BehaviourDefinition {
  Name name;
  std::vector<Statement> statements;
  Span span;
};

struct Script {
  std::vector<BehaviourDefinition> behaviours;
  std::vector<Statement> statements;  ///< the main sequence, in file order
  Span span;
};

// ---- frames and shapes
// -----------------------------------------------------------------------------------------

struct FrameElement {
  enum class Kind { trans, rotx, roty, rotz, node };
  Kind kind = Kind::trans;
  std::vector<ExpressionPtr>
      arguments;  ///< three for trans, one for a rotation (the checker counts)
  Span span;
  QualifiedName node = {};  ///< yard.bay[7]
};
struct Frame {
  std::vector<FrameElement> elements;
  Span span;
};

/// box(...), cylinder(...), sphere(...), capsule(...), prism(...), mesh("file", unit, scale 2, up
/// y, part "name", hull)
struct Shape {
  Name kind;                    ///< as written; the checker knows the kinds
  std::vector<Number> numbers;  ///< signed
  String file;                  ///< mesh
  std::optional<Name> unit;     ///< mesh
  std::optional<Number> scale;  ///< mesh
  std::optional<Name> up;       ///< mesh
  std::optional<String> part;   ///< mesh
  std::optional<Name> hull;     ///< mesh: the word
  std::optional<Frame> at;
  Span span;
};

// ---- robot files
// -----------------------------------------------------------------------------------------------

/// range(a, b), cyclic, and step, speed, loaded, accel, start, prefer of (v): `name` as written
struct Attribute {
  Name name;
  std::vector<Number> numbers;  ///< signed
  Span span;
};

/// param NAME { attr } ;   or   param NAME = expr ;
struct ParameterItem {
  Name name;
  std::vector<Attribute> attributes;
  ExpressionPtr derived;
  Span span;
};
struct RuleItem {
  Name parameter;
  ExpressionPtr value;
  Span span;
};
struct FrameItem {
  Frame frame;
  Span span;
};
struct ShapeItem {
  Shape shape;
  Span span;
};
/// behaviour "file";   or   behaviour { script }
struct BehaviourItem {
  std::optional<String> file;
  Script script;
  Span span;
};

struct BodyItem {
  Name name;
  std::optional<Name> on;
  std::vector<ParameterItem> parameters;
  std::vector<RuleItem> rules;
  std::vector<FrameItem> frames;  ///< more than one is an error of the checker
  std::vector<ShapeItem> shapes;
  std::vector<BehaviourItem> behaviours;
  Span span;
};

struct ToolItem {
  Name body;
  std::optional<Frame> at;
  Span span;
};
struct ConstItem {
  Name name;
  ExpressionPtr value;
  Span span;
};
struct TouchingItem {
  Name a, b;
  Span span;
};
/// time_step 1;  sensor 10;
struct SettingItem {
  Name name;
  Number value;
  Span span;
};
struct CapacityItem {
  std::vector<std::pair<Number, Number>> points;  ///< radius, mass
  Span span;
};

/// rope NAME(radius) from BODY at (x, y, z) to BODY at (x, y, z);
struct RopeItem {
  struct End {
    Name body;
    std::vector<Number> point;  ///< three, or none: the origin of the body
  };
  std::optional<Name> name;
  Number radius;
  End from, to;
  Span span;
};

/// buffer 0.3 m;   buffer 0.5 m of jib, mast;
struct BufferItem {
  Number distance;
  std::vector<Name> bodies;  ///< none: all that have no buffer of their own
  Span span;
};

/// seed 7;   weight x 20, boom.phi 2;
struct GuideClause {
  struct Value {
    QualifiedName parameter;
    Number number;
  };
  Name key;
  std::optional<Number> number;
  std::vector<Value> values;         ///< instead of the number
  std::vector<QualifiedName> words;  ///< instead of the number: of a choice, or parameters
  ExpressionPtr condition;           ///< keep
  std::optional<double> thinking;    ///< thinks: s for each check
  std::optional<String> setting;     ///< set: the name of what it sets to the number
  Span span;
};
/// guide NAME KIND { clauses }   of a robot or a plan
struct GuideDeclaration {
  Name name;
  Name kind;
  std::optional<String> planner;  ///< of the kind ompl
  std::vector<GuideClause> clauses;
  Span span;
};

/// `theta 30, x 20`
struct NamedValue {
  QualifiedName name;
  Number value;
};
struct Values {
  std::vector<NamedValue> values;
  Span span;
};

/// deviation 1 mm, 0.1 deg;   of a robot or a motion, and what else a motion asks beside its goals:
/// free rotz;   near elbow.phi 90;   lock base.x, base.y;   enter bit slab;
struct MotionClause {
  Name key;
  std::vector<Name> turns;                ///< free
  Values values;                          ///< near
  std::vector<QualifiedName> parameters;  ///< lock
  std::vector<Number> numbers;            ///< deviation
  std::optional<Name> body;               ///< enter
  QualifiedName component;                ///< enter
  Span span;
};

using RobotItem =
    std::variant<SettingItem, BodyItem, ToolItem, ConstItem, TouchingItem, CapacityItem, RopeItem,
                 BufferItem, MotionClause /* deviation */, GuideDeclaration, BehaviourItem>;

struct Robot {
  Name name;
  std::vector<RobotItem> items;  ///< in file order; broken items are left out (already reported)
  bool broken = false;           ///< something of it did not parse
  Span span;
};

// ---- plans
// -----------------------------------------------------------------------------------------------------

/// `at frame`, `at frame, values` or values
struct Goal {
  std::optional<Frame> at;
  Values values;
  Span span;
};

/// site shape;
struct SiteItem {
  Shape shape;
  Span span;
};
/// storage yard box(0, 0, 0, 10, 8, 3);   of a place with several shapes one item each
struct StorageItem {
  Name name;
  Shape shape;
  Span span;
};
/// contact 1 mm;  budget 500;
struct NumberItem {
  Name name;
  Number value;
  Span span;
};
/// start_at "2026-03-02 07:00";  currency "EUR";
struct StringItem {
  Name name;
  String value;
  Span span;
};
/// situation a, b;
struct SituationItem {
  std::vector<Name> names;
  Span span;
};

/// mon-fri 07:00-12:00, 12:30-16:00;   off 2026-12-25;   lost nov-feb 0.2;
struct Shift {
  Name first_day;
  std::optional<Name> last_day;
  std::vector<std::pair<String, String>> times;  ///< "07:00", "12:00" as written
  std::vector<String> off;                       ///< dates as written; then the rest is empty
  bool carry_over = false;                       ///< the item `carry_over;`
  std::optional<Number> lost = {};               ///< the share of its days, then the rest is empty
  std::optional<Name> first_month = {}, last_month = {};  ///< of `lost`
  Span span;
};
struct CalendarItem {
  Name name;
  std::vector<Shift> shifts;
  Span span;
};

/// storey "0";   attribute fire "60 min";
struct AttributeItem {
  Name key;  ///< storey; fire
  String text;
  Span span;
};

/// fixed to slab;   fixed to slab after grout;
struct Fixing {
  QualifiedName to;
  std::optional<QualifiedName> after;  ///< a task: until it is done nothing is fixed
};

struct ComponentItem {
  Name name;
  std::vector<Shape> shapes;
  std::vector<Frame> at;  ///< more than one is an error of the checker; likewise the rest
  std::vector<Frame> grip;
  std::vector<Number> mass;
  std::vector<Number> density;
  std::vector<AttributeItem> attributes;
  std::vector<Number> cost;  ///< of its material
  std::vector<Fixing> fixed_to;
  std::vector<QualifiedName> braced_by;
  bool people = false;
  Span span;
};

/// moving NAME { shape ...; path 0 s frame, 20 s frame; repeat; people; }
struct MovingItem {
  struct Place {
    Number time;
    Frame at;
  };
  Name name;
  std::vector<Shape> shapes;
  std::vector<std::vector<Place>> paths;  ///< more than one is an error of the checker
  bool repeat = false;
  bool people = false;
  Span span;
};

/// (4 m, 2.5 m)
struct FloorPlace {
  Number x, y;
};
/// area NAME { height 3 m; at rotx(90); outline (0, 0), ...; shaft ...; column (20, 10), 0.5 m;
/// beam ...; }
struct AreaItem {
  /// outline, shaft, beam; column, round_column
  struct Part {
    Name key;
    std::vector<FloorPlace> places;
    std::optional<Number> size;
    Span span;
  };
  Name name;
  std::vector<Number> height;  ///< more than one is an error of the checker
  std::vector<Frame> at;       ///< also
  std::vector<Part> parts;
  Span span;
};
/// earth NAME { grid 60, 40; cell 0.25 m; at trans(-20, -10, 0); height from "site.csv"; stands 60
/// deg; }
struct EarthItem {
  struct Clause {
    Name key;
    std::vector<Number> numbers;  ///< of a grid two
    std::optional<String> file;
    std::optional<Frame> at;
  };
  Name name;
  std::vector<Clause> clauses;
  Span span;
};
/// cover NAME { width 1 m; rate 40 m3 per h; partition beams; from (0, 0); }
struct CoverItem {
  struct Clause {
    Name key;
    std::optional<Number> number;
    std::optional<Number> second;  ///< of `holes`, which has two
    std::optional<FloorPlace> place;
    std::optional<Name> word;
    std::vector<Name> guides;  ///< of `guide`
  };
  Name area;
  std::vector<Clause> clauses;
  Span span;
};

/// policy order; policy charts { tolerance 5 s; delay 5 s; minimise time; }
struct PolicyItem {
  Name name;
  std::vector<NumberItem> numbers;
  std::vector<Name> minimise;
  Span span;
};
/// class NAME { speed 3 m/s; width 4 m; cost 0.5 per m; }
struct LaneClassItem {
  Name name;
  std::vector<Number> speed;
  std::vector<Number> width;
  std::vector<Number> cost;
  Span span;
};
/// node NAME at frame;
struct NodeItem {
  Name name;
  Frame at;
  Span span;
};
/// lane a to b [CLASS] [both] [beside c to d] [length 40 m];
struct LaneItem {
  Name from, to;
  std::vector<Name> lane_class;
  std::vector<Name> both;
  std::vector<std::pair<Name, Name>> beside;
  std::vector<Number> length;
  Span span;
};
/// errand ROBOT from a to b at 20 s [{ priority 2; speed 1 m/s; width 1 m; }]
struct ErrandItem {
  Name name, from, to;
  Number start;
  std::vector<NumberItem> numbers;
  Span span;
};
/// report lane a to b (blocked | reopened | obstacle 0 m to 2 m) at 20 s by ROBOT;
struct LaneReportItem {
  Name from, to;
  Name what;
  std::vector<Number> edges;  ///< of an obstacle: two
  Number time;
  Name by;
  Span span;
};
/// barrier lane a to b from 20 s [to 60 s];
struct BarrierItem {
  Name from, to;
  Number since;
  std::optional<Number> until;
  Span span;
};
/// explore ROBOT from a [{ speed 1 m/s; }]
struct ExploreItem {
  Name name, from;
  std::vector<NumberItem> numbers;
  Span span;
};
struct NetworkBlock;
using NetworkPart =
    std::variant<PolicyItem, LaneClassItem, NodeItem, LaneItem, ErrandItem, LaneReportItem,
                 BarrierItem, ExploreItem, std::shared_ptr<const NetworkBlock>>;
/// network NAME { class ...; node ...; lane ...; }
struct NetworkItem {
  Name name;
  std::vector<NetworkPart> parts;
  Span span;
};

/// cost 180 per h;
struct Cost {
  Number amount;
  Span span;
};

/// rental 400 per day [from "2026-03-02" to "2026-03-20"];
struct Rental {
  Number amount;
  std::optional<String> from, to;
  Span span;
};
/// overtime 1.5 [outside NAME];
struct Overtime {
  Number factor;
  std::optional<Name> outside;
  Span span;
};
/// fuel 18 l per h [idling 4 l per h] [price 1.70 per l];
struct Fuel {
  Number working;
  std::optional<Number> idling;
  std::optional<Number> price;
  Span span;
};
/// What a robot or a crew costs besides its hours; more than one of a kind is an error of the
/// checker.
struct Charges {
  std::vector<Rental> rental;
  std::vector<Number> mobilisation;
  std::vector<Overtime> overtime;
  std::vector<Fuel> fuel;
};

/// triangular(2 min, 3 min, 7 min);   measured("times.csv", min, column "hook")
struct DurationLaw {
  Name name;
  std::vector<Number> values;
  Span span;
  // measured
  std::optional<String> file = {};
  std::vector<Name> units = {};      ///< more than one is an error of the checker
  std::vector<String> columns = {};  ///< likewise; a name, or digits
  bool by_number = false;            ///< the column is given by its number, from 1
};
/// breakdown every exponential(40 h) takes uniform(1 h, 3 h);
struct Breakdown {
  Number every;
  std::optional<DurationLaw> every_law;  ///< in place of the duration
  Number takes;
  std::optional<DurationLaw> takes_law;
  Span span;
};

/// robot NAME "file" [at frame] (; | { ... })   or, short form,   robot "file" [at frame];
struct RobotUse {
  std::optional<Name> name;
  String file;
  std::optional<Frame> at;
  std::vector<String> behaviour = {};  ///< a script in place of that of the robot file
  std::vector<Values> start;
  std::vector<Cost> cost;
  std::vector<Name> calendar;
  std::vector<Values> park;
  std::vector<Breakdown> breakdowns;  ///< more than one is an error of the checker
  Charges charges;
  Span span;
};
struct CrewItem {
  Name name;
  std::vector<Number> size;
  std::vector<Cost> cost;
  std::vector<Name> calendar;
  Charges charges;
  Span span;
};
/// pool NAME { of a, b; choose least_used; }
struct PoolItem {
  Name name;
  std::vector<Name> of;
  std::vector<Name> choose;
  Span span;
};
/// workspaces { of digger_a, digger_b, lorries; reaction 1 s; braking 2 m/s2; }
struct WorkspacesItem {
  std::vector<Name> of;
  std::vector<NumberItem> numbers;
  std::vector<Span> watch = {};
  Span keyword = {};
  Span span = {};
};
/// fleet NAME { robot "FILE"; size 3; on yard; at bay[1], bay[2], bay[3]; choose nearest; }
struct FleetItem {
  Name name;
  std::vector<String> file;
  std::vector<Number> size;
  std::vector<Name> on;
  std::vector<Name> at;
  std::vector<Name> choose;
  RobotUse member;  ///< what is said of each: cost, calendar, charges
  Span span;
};
/// overhead 850 per day;
struct OverheadItem {
  Number amount;
  Span span;
};

/// NAME [FS|SS|FF|SF] [+|- duration]
struct Link {
  QualifiedName name;
  std::optional<Name> type;
  std::optional<Number> lag;  ///< signed
  Span span;
};

/// hook 4 min by riggers;   takes 2 h;
struct WorkItem {
  Name name;  ///< hook, adjust, release or takes
  Number duration;
  std::optional<Name> by;
  std::optional<Name> turning;  ///< theta: how people turn the load
  Span span;
  std::optional<DurationLaw> law = {};  ///< in place of the duration
};
/// dig 10000 m3 { load trucks takes 4 min; swell 0.25; bed 12 m3; haul takes 6 min; tip takes 1 min
/// by dozer; }
struct DigItem {
  /// load, a number by its word, or a stage by its own name.
  struct Clause {
    Name key;
    std::optional<Number> number;    ///< of swell, bed, ...
    std::optional<Name> trucks;      ///< of load
    std::optional<Number> duration;  ///< of load and of stages
    std::optional<DurationLaw> law;  ///< in place of the duration
    std::optional<Name> by;          ///< of stages: who serves
    std::optional<Frame> frame;      ///< of cut, carry, open, and dump at
    std::vector<Frame> places = {};  ///< of load at, queue at
    bool is_stage = false;
    bool is_timed = false;  ///< load takes ...
  };
  std::optional<Number> volume;
  std::optional<Name> earth;   ///< in place of a volume,
  std::optional<Shape> shape;  ///< with what is to be dug from it
  std::vector<Clause> clauses;
  Span span;

  /// Where its volume or its earth stands.
  Span place() const { return volume ? volume->span : earth->span; }
};
/// haul DIG, DIG { bed 8 m3; tip at trans(40, 0, 0); tip takes 30 s; heap dump at trans(-5, 0, 0);
/// }
struct HaulItem {
  struct Clause {
    Name key;
    std::optional<Number> number = {};    ///< of bed, payload
    std::vector<Frame> places = {};       ///< of out, tip, back
    std::optional<Number> duration = {};  ///< of tip takes
    std::optional<DurationLaw> law = {};  ///< in place of the duration: an error of the checker
    std::optional<Name> earth = {};       ///< of heap,
    std::optional<Frame> frame = {};      ///< with where it falls
    std::optional<Values> values = {};    ///< of raise
  };
  std::vector<QualifiedName> digs;
  std::vector<Clause> clauses;
  Span span;
};
/// by crane, riggers;   by all of cranes;   by same as TASK;
struct ByItem {
  std::vector<Name> names;
  std::vector<Name> all_of;
  std::vector<QualifiedName> same_as;
  Span span;
};
/// needs 2 masons, 1 helpers;
struct NeedsItem {
  struct Need {
    Number units;
    Name crew;
  };
  std::vector<Need> needs;
  Span span;
};
struct MoveItem {
  QualifiedName component;
  Frame to;
  Span span;
};
struct GoItem {
  Goal goal;
  Span span;
};
struct RemoveItem {
  QualifiedName component;
  Span span;
};
struct ViaItem {
  Goal goal;
  Span span;
};
/// guide NAME, NAME;   of a task, or of the motion of a short plan
struct GuideItem {
  std::vector<Name> names;
  Span span;
};
/// within 0.01;   within z 30, theta 5;
struct WithinItem {
  std::optional<Number> length;
  Values values;
  Span span;
};
/// whole on;   whole off;
struct WholeItem {
  std::optional<Name> value;  ///< nothing: on
  Span span;
};
/// "2026-03-02 07:00", or 30 s after the beginning of the plan
struct Moment {
  std::optional<String> date;
  std::optional<Number> after_start;
  Span span;
};
/// not_before "2026-03-02 07:00";   due 8 h;   baseline "..." to "...";
struct DateItem {
  Name name;
  std::vector<Moment> moments;  ///< of a baseline two
  Span span;
};
/// support on;   support gap 20 mm;
struct SupportItem {
  std::optional<Name> mode;
  std::optional<Number> gap;
  Span span;
};
struct ZoneItem {
  Shape shape;
  std::optional<Number> up_to;
  Span span;
};
struct AfterItem {
  std::vector<Link> links;
  Span span;
};

/// The head of `for NAME from A to B { ... }` or `when (CONDITION) { ... }`.
struct BlockHead {
  std::optional<Name> variable;  ///< for
  Number first, last;            ///< for
  ExpressionPtr condition;       ///< when
  Span keyword;
};
struct TaskBlock;
struct ModuleBlock;
struct PlanBlock;
struct NetworkBlock {
  BlockHead head;
  std::vector<NetworkPart> items;
  Span span;
};

using TaskPart =
    std::variant<ByItem, MoveItem, GoItem, RemoveItem, WorkItem, ViaItem, GuideItem, SituationItem,
                 WithinItem, NumberItem /* budget, priority */, ZoneItem, AfterItem, AttributeItem,
                 NeedsItem, std::shared_ptr<const TaskBlock>, WholeItem, DateItem, MotionClause,
                 CoverItem, DigItem, HaulItem>;
struct TaskBlock {
  BlockHead head;
  std::vector<TaskPart> items;
  Span span;
};
struct TaskItem {
  Name name;
  std::vector<TaskPart> parts;
  Span span;
};
/// touching a b;   within a b;
struct WaiverItem {
  Name kind;  ///< touching or within
  QualifiedName first, second;
  Span span;
};
using ModulePart =
    std::variant<ComponentItem, TaskItem, WaiverItem, std::shared_ptr<const ModuleBlock>>;
struct ModuleBlock {
  BlockHead head;
  std::vector<ModulePart> items;
  Span span;
};
struct ModuleItem {
  Name name;
  std::vector<ModulePart> items;
  Span span;
};
/// place NAME at frame [from frame] as NAME [after links];
struct PlaceItem {
  Name module;
  Frame at;
  std::optional<Frame> from;  ///< where its components stand at first; none: where it is built
  Name as;
  std::vector<Link> after;
  Span span;
};
/// import "file" [as NAME] { ... }
struct ImportItem {
  String file;
  std::optional<Name> as;
  Span span;
};

// short form only
struct StartItem {
  Values values;
  Span span;
};
struct GoalItem {
  Goal goal;
  Span span;
};
struct CarryItem {
  Shape shape;
  Span span;
};

/// parameter NAME = expression;   or   parameter NAME = "text";   of the plan
struct PlanParameter {
  Name name;
  ExpressionPtr value;  ///< null: a text
  String text;
  Span span;
};

using PlanItem =
    std::variant<SiteItem, NumberItem, StringItem, SituationItem, CalendarItem, ComponentItem,
                 RobotUse, CrewItem, TaskItem, ModuleItem, PlaceItem, ImportItem, StartItem,
                 GoalItem, ViaItem, CarryItem, WithinItem, WaiverItem, PlanParameter, PoolItem,
                 OverheadItem, std::shared_ptr<const PlanBlock>, WholeItem, SupportItem,
                 GuideDeclaration, GuideItem, MotionClause, StorageItem, MovingItem, NetworkItem,
                 FleetItem, AreaItem, EarthItem, WorkspacesItem>;
struct PlanBlock {
  BlockHead head;
  std::vector<PlanItem> items;
  Span span;
};

/// As it is written, or as `expand` makes it plain: without parameters, blocks and expressions.
struct Plan {
  Name name;
  std::vector<PlanItem> items;  ///< in file order; broken items are left out (already reported)
  bool broken = false;
  Span span;
};

}  // namespace rubicon::syntax
