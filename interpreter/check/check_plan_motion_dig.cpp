#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "interpreter/check/check_number.hpp"
#include "interpreter/check/check_plan_parts.hpp"

namespace rubicon::interpreter::plan_check {

namespace {

constexpr double kLeastBucket = 0.001;    // m3
constexpr double kMostBucket = 1000;      // m3
constexpr double kMostMachineLoad = 1e7;  // kg
/// m, of a layer.
constexpr double kLeastLayer = 0.01;
constexpr double kMostLayer = 100;
/// m: the machine keeps so far above what it must not dig, and its straight ways waver.
constexpr double kLeastTolerance = 0.04;
constexpr double kDefaultTolerance = 0.1;
constexpr double kDefaultClearance = 0.5;
/// Buckets of one task, at most.
constexpr std::int64_t kMostBuckets = 100'000;
/// rad and m: a frame that is no more than this is a rotation, or a place.
constexpr double kNoPart = 1e-12;

hauling::CubicMillimetres whole_mm3(double cubic_metres) {
  return std::llround(cubic_metres * hauling::kPerCubicMetre);
}

/// One task in which a robot digs.
class MotionDigCheck {
 public:
  MotionDigCheck(Subject& subject, const syntax::DigItem& item, const DugSoil& soil,
                 const RobotSpec& robot, const std::vector<int>& diggers,
                 const std::function<int(int crew)>& units_of)
      : subject_(subject),
        item_(item),
        soil_(soil),
        robot_(robot),
        diggers_(diggers),
        units_of_(units_of) {}

  std::optional<MotionDigSpec> run() {
    const int errors = subject_.diagnostics.errors();
    const EarthSpec& earth = subject_.model.earths[static_cast<std::size_t>(soil_.earth)];
    dig_.earth = soil_.earth;
    dig_.soil = soil_.component;
    dig_.before = soil_.before;
    dig_.after = soil_.after;
    dig_.volume = soil_.volume;
    dig_.swell = earth.swell;
    dig_.tolerance = in_whole_mm(kDefaultTolerance);
    dig_.clearance = kDefaultClearance;
    density_ = earth.density;
    const robot::RobotModel& model = robot_.robot->model;
    if (model.bodies[static_cast<std::size_t>(model.tool_body)].shapes.empty()) {
      wrong(item_.place(),
            fmt::format("'{}' has nothing to dig with: the body of its tool, '{}', has no shape",
                        robot_.name, model.bodies[static_cast<std::size_t>(model.tool_body)].name),
            "tool bucket;");
    }
    for (const Clause& clause : item_.clauses) take(clause);
    need("bucket", "how much a bucket takes", "bucket 1.2 m3;");
    need("layer", "how deep a layer is", "layer 0.5 m;");
    need("cut", "how the tool is held where it cuts", "cut roty(90);");
    if (has("queue at") && !has("load at")) {
      wrong(place_of("queue at"), "trucks queue for a place where they are loaded",
            "load at trans(2, 6, 0);");
    }
    need("dump at", "where the bucket is emptied", "dump at trans(2, 6, 3.5);");
    if (dig_.loads_bodies()) {
      check_bodies();
    } else if (dig_.trucks < 0) {
      check_no_trucks();
    } else {
      check_trucks();
    }
    if (subject_.diagnostics.errors() != errors) return std::nullopt;
    dig_.bucket =
        std::max<soil::CubicMillimetres>(whole_mm3(bucket_ * fill_ / (1 + dig_.swell)), 1);
    if (dig_.volume / dig_.bucket > kMostBuckets) {
      wrong(place_of("bucket"),
            fmt::format("these are {} buckets; a robot fills up to {} in a task",
                        dig_.volume / dig_.bucket, kMostBuckets),
            "a larger bucket, or a smaller pit");
      return std::nullopt;
    }
    const soil::CubicMillimetres area = dig_.before->cell * dig_.before->cell;
    if (dig_.bucket < area) {
      wrong(place_of("bucket"),
            fmt::format("a bucket takes {:g} m3, less than 1 mm of a cell",
                        static_cast<double>(dig_.bucket) * 1e-9),
            "a larger bucket, or smaller cells");
      return std::nullopt;
    }
    if (dig_.trucks >= 0 && !resolve_load()) return std::nullopt;
    dig_.density = density_;
    return std::move(dig_);
  }

 private:
  using Clause = syntax::DigItem::Clause;
  using UnitKind = syntax::UnitKind;

  static soil::Millimetres in_whole_mm(double metres) { return std::llround(metres * 1e3); }

  void wrong(Span span, std::string message, std::string hint = {}) {
    subject_.error("P55", span, std::move(message), std::move(hint));
  }
  bool has(const std::string& key) const { return given_.count(key) != 0; }
  Span place_of(const std::string& key) const {
    const auto found = given_.find(key);
    return found == given_.end() ? item_.place() : found->second;
  }
  void need(const char* key, const char* what, const char* hint) {
    if (!has(key)) {
      wrong(item_.place(),
            fmt::format("robot '{}' digs, and dig does not say {}", robot_.name, what), hint);
    }
  }

  void take(const Clause& clause) {
    const bool is_place = (clause.frame && clause.key.text == "dump") || !clause.places.empty();
    const std::string key = is_place ? clause.key.text + " at" : clause.key.text;
    const auto [first, is_new] = given_.emplace(key, clause.key.span);
    if (!is_new) {
      subject_.twice(clause.key.span, key + " is given twice", first->second);
      return;
    }
    if (!clause.places.empty()) {
      take_places(key, clause);
    } else if (clause.frame) {
      take_frame(key, *clause.frame);
    } else if (clause.trucks) {
      take_trucks(clause);
    } else if (clause.is_stage) {
      take_stage(clause);
    } else {
      take_number(key, *clause.number);
    }
  }

  void take_frame(const std::string& key, const syntax::Frame& frame) {
    const math::Pose X = resolve_frame_or_identity(subject_, frame);
    if (key == "dump at") {
      if (!(X.linear() - math::Mat3::Identity()).isZero(kNoPart)) {
        wrong(frame.span, "dump at is a place: how the tool is held there is said by carry",
              "dump at trans(2, 6, 3.5); carry roty(90);");
      }
      dig_.p_WD = X.translation();
      return;
    }
    if (!X.translation().isZero(kNoPart)) {
      wrong(frame.span,
            fmt::format("{} is how the tool is held, and no place: only rotations", key),
            fmt::format("{} roty(90); about the horizontal across the way to the machine", key));
    }
    if (key == "cut") {
      dig_.X_HT_cut = X;
      if (!has("carry")) dig_.X_HT_carry = X;
    } else if (key == "carry") {
      dig_.X_HT_carry = X;
    } else {
      dig_.X_HT_open = X;
    }
  }

  /// Of trucks with bodies.
  void take_places(const std::string& key, const Clause& clause) {
    std::vector<math::Pose> places;
    for (const syntax::Frame& frame : clause.places) {
      places.push_back(resolve_placed_frame(subject_, frame, math::Pose::Identity()));
    }
    if (key == "queue at") {
      dig_.queue = std::move(places);
    } else if (places.size() > 1) {
      wrong(clause.places[1].span, "one truck is loaded at a time, and load at has several places",
            "queue at for those where trucks wait");
    } else {
      dig_.X_WL = places.front();
    }
  }

  /// What trucks with bodies take and do is said where they haul.
  void check_bodies() {
    if (dig_.trucks >= 0) {
      wrong(place_of("load"), "trucks are a crew or have bodies; dig says both",
            "either load CREW; or load at trans(2, 6, 0);");
    }
    for (const char* key : {"bed", "payload", "efficiency"}) {
      if (has(key)) {
        wrong(place_of(key), fmt::format("{} is of the tasks that haul what is loaded here", key),
              "haul DIG { bed 8 m3; }");
      }
    }
    if (dig_.hauls.stages.empty()) return;
    const std::string& name = dig_.hauls.stages.front().name;
    wrong(place_of(name),
          fmt::format("{} is a stage of a crew of trucks, and trucks with bodies drive", name));
  }

  void take_trucks(const Clause& clause) {
    if (clause.is_timed) {
      wrong(clause.key.span,
            fmt::format("robot '{}' loads by its motions, which take their time: no takes",
                        robot_.name),
            fmt::format("load {};", clause.trucks->text));
    }
    const auto found = subject_.crews.find(clause.trucks->text);
    if (found != subject_.crews.end()) dig_.trucks = found->second;
  }

  hauling::StageTime time_of(const Clause& clause) {
    hauling::StageTime time;
    if (clause.law) {
      time.law = resolve_law(subject_, *clause.law);
      if (time.law) time.seconds = time.law->mean();
    } else if (const auto seconds = resolve_duration(subject_, *clause.duration, clause.key.text)) {
      time.seconds = *seconds;
    }
    return time;
  }

  void take_stage(const Clause& clause) {
    const std::string& key = clause.key.text;
    if (key == "pass") {
      wrong(clause.key.span,
            fmt::format("robot '{}' makes its passes itself: pass has no duration", robot_.name),
            "fill takes 3 s; what filling takes beside the motion");
      return;
    }
    const hauling::StageTime time = time_of(clause);
    if (key == "fill" || key == "dump") {
      if (clause.law || clause.by) {
        wrong(clause.law ? clause.law->span : clause.by->span,
              fmt::format("{} is a certain duration of the robot alone", key), key + " takes 3 s;");
      }
      WorkSpec& work = key == "fill" ? dig_.fill : dig_.dump;
      work.duration = time.seconds;
      work.span = clause.key.span;
      return;
    }
    hauling::Stage stage;
    stage.name = key;
    stage.time = time;
    if (key == "tip") dig_.hauls.tip = dig_.hauls.stages.size();
    if (clause.by) {
      const auto found = subject_.crews.find(clause.by->text);
      if (found != subject_.crews.end()) {
        servers_.emplace_back(found->second, clause.by->span);
        stage.by = clause.by->text;
        stage.servers = units_of_(found->second);
      }
    }
    dig_.hauls.stages.push_back(std::move(stage));
  }

  std::optional<double> number(const syntax::Number& value, UnitKind kind, const std::string& what,
                               double least, double most) {
    return bounded(subject_, value, kind, what, least, most);
  }

  double cubic_metres(const syntax::Number& value, const std::string& what, double least,
                      double most) {
    const bool is_volume =
        value.dimension == syntax::Dimension{} || value.dimension == syntax::Dimension{3, 0, 0, 0};
    if (is_volume && value.value >= least && value.value <= most) return value.value;
    wrong(value.span,
          fmt::format("expected a volume from {:g} to {:g} m3 as {}{}", least, most, what,
                      is_volume ? fmt::format(", found {:g} m3", value.value) : ""),
          "1.2 m3");
    return least;
  }

  void take_number(const std::string& key, const syntax::Number& value) {
    if (key == "bucket") {
      bucket_ = cubic_metres(value, key, kLeastBucket, kMostBucket);
    } else if (key == "bed") {
      bed_ = cubic_metres(value, key, kLeastBucket, 1e6);
    } else if (key == "layer") {
      dig_.layer = in_whole_mm(
          number(value, UnitKind::length, "the layer", kLeastLayer, kMostLayer).value_or(1));
    } else if (key == "tolerance") {
      dig_.tolerance = in_whole_mm(
          number(value, UnitKind::length, "the tolerance", kLeastTolerance, 10).value_or(1));
    } else if (key == "clearance") {
      dig_.clearance = number(value, UnitKind::length, "the clearance", 0.01, 100).value_or(1);
    } else if (key == "swell") {
      dig_.swell = number(value, UnitKind::none, key, 0, kMostSwell).value_or(0);
    } else if (key == "fill_factor") {
      fill_ = number(value, UnitKind::none, key, 0.01, 2).value_or(1);
    } else if (key == "efficiency") {
      dig_.hauls.efficiency = number(value, UnitKind::none, key, 0.01, 1).value_or(1);
    } else if (key == "density") {
      density_ = number(value, UnitKind::density, key, 1, kMostDensity);
    } else if (key == "payload") {
      payload_ = number(value, UnitKind::mass, key, 0.1, kMostMachineLoad);
    } else {
      wrong(place_of(key),
            fmt::format("{} is of a dig by durations, and here robot '{}' digs", key, robot_.name));
    }
  }

  /// Who hauls nothing has nothing to say of it.
  void check_no_trucks() {
    if (has("load")) return;  // said where the crew is looked up
    for (const char* key : {"bed", "payload", "efficiency"}) {
      if (has(key)) {
        wrong(place_of(key), fmt::format("{} is of trucks, and dig loads none", key),
              "load trucks;");
      }
    }
    if (!dig_.hauls.stages.empty()) {
      const std::string& name = dig_.hauls.stages.front().name;
      wrong(place_of(name), fmt::format("{} is a stage of trucks, and dig loads none", name),
            "load trucks;");
    }
  }

  void check_trucks() {
    dig_.hauls.trucks = units_of_(dig_.trucks);
    if (!has("tip")) {
      wrong(item_.place(), "the trucks never tip: a stage of their round is called tip",
            "haul takes 6 min; tip takes 1 min; return takes 5 min;");
    }
    if (!has("bed") && !has("payload")) {
      wrong(item_.place(), "dig does not say how much a truck takes",
            "bed 12 m3; or payload 20 t; density 1.8 t per m3;");
    }
    std::set<int> busy(diggers_.begin(), diggers_.end());
    busy.insert(dig_.trucks);
    for (const auto& [crew, span] : servers_) {
      if (busy.insert(crew).second) continue;
      wrong(span,
            fmt::format("crew '{}' does something else in this task already: each crew does one "
                        "thing in a dig",
                        subject_.model.crews[static_cast<std::size_t>(crew)].name),
            "give what serves here a crew of its own");
    }
  }

  /// By volume and by mass, whichever is full first.
  bool resolve_load() {
    if (payload_ && !density_) {
      wrong(place_of("payload"), "payload needs the density of the soil as it lies",
            "payload 20 t; density 1.8 t per m3;");
      return false;
    }
    const double loose = 1 + dig_.swell;
    double load = bed_ ? *bed_ / loose : 1e9;
    if (payload_) load = std::min(load, *payload_ / *density_);
    dig_.hauls.load = std::max<hauling::CubicMillimetres>(whole_mm3(load), 1);
    dig_.hauls.volume = dig_.volume;
    dig_.hauls.bucket = dig_.bucket;
    if (dig_.hauls.load >= dig_.bucket) return true;
    wrong(place_of(has("bed") ? "bed" : "payload"),
          fmt::format("a truck takes {:.3f} m3 as it lies, less than a bucket of {:.3f} m3",
                      static_cast<double>(dig_.hauls.load) * 1e-9,
                      static_cast<double>(dig_.bucket) * 1e-9),
          "larger trucks, or a smaller bucket");
    return false;
  }

  Subject& subject_;
  const syntax::DigItem& item_;
  const DugSoil& soil_;
  const RobotSpec& robot_;
  const std::vector<int>& diggers_;  ///< crews that work with it
  const std::function<int(int crew)>& units_of_;
  MotionDigSpec dig_;
  std::map<std::string, Span> given_;
  std::vector<std::pair<int, Span>> servers_;
  std::optional<double> bed_, density_, payload_;
  double bucket_ = 1, fill_ = 1;
};

}  // namespace

std::optional<MotionDigSpec> resolve_motion_dig(Subject& subject, const syntax::DigItem& item,
                                                const DugSoil& soil, const RobotSpec& robot,
                                                const std::vector<int>& diggers,
                                                const std::function<int(int crew)>& units_of) {
  return MotionDigCheck(subject, item, soil, robot, diggers, units_of).run();
}

}  // namespace rubicon::interpreter::plan_check
