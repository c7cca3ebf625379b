#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "interpreter/check/check_number.hpp"
#include "interpreter/check/check_plan_parts.hpp"

namespace rubicon::interpreter::plan_check {

namespace {

using syntax::UnitKind;

/// Largest volume of soil, m3; below it whole mm3 add up within 64 bits.
constexpr double kMostSoil = 1e9;
constexpr double kLeastSoil = 1e-6;
constexpr double kMostPayload = 1e7;  // kg

/// m3; nothing after P55.
std::optional<double> volume(Subject& subject, const syntax::Number& number,
                             const std::string& what) {
  const bool is_volume =
      number.dimension == syntax::Dimension{} || number.dimension == syntax::Dimension{3, 0, 0, 0};
  if (is_volume && number.value >= kLeastSoil && number.value <= kMostSoil) return number.value;
  subject.error("P55", number.span,
                fmt::format("expected a volume above 0 and up to 1e9 m3 as {}{}", what,
                            is_volume ? fmt::format(", found {:g} m3", number.value) : ""),
                "12 m3");
  return std::nullopt;
}

hauling::CubicMillimetres in_mm3(double cubic_metres) {
  return static_cast<hauling::CubicMillimetres>(
      std::llround(cubic_metres * hauling::kPerCubicMetre));
}

/// One task that digs.
class DigCheck {
 public:
  DigCheck(Subject& subject, const syntax::DigItem& item, const std::optional<DugSoil>& soil,
           const std::vector<CrewUnits>& diggers, const std::function<int(int crew)>& units_of)
      : subject_(subject), item_(item), soil_(soil), diggers_(diggers), units_of_(units_of) {}

  std::optional<DigSpec> run() {
    const int errors = subject_.diagnostics.errors();
    take_volume();
    for (const syntax::DigItem::Clause& clause : item_.clauses) take(clause);
    check_who();
    check_stages();
    check_load();
    if (subject_.diagnostics.errors() != errors) return std::nullopt;
    if (operation().loads() > hauling::kMostLoads) {
      wrong(item_.place(), fmt::format("these are {} loads; a task has up to {}",
                                       operation().loads(), hauling::kMostLoads));
      return std::nullopt;
    }
    const std::int64_t passes = operation().loads() * operation().passes(operation().load);
    if (passes > hauling::kMostPasses) {
      wrong(place_of("bucket"),
            fmt::format("these are {} passes; a task has up to {}", passes, hauling::kMostPasses),
            "load CREW takes, the time for a whole truck");
      return std::nullopt;
    }
    if (!takes_time()) return std::nullopt;
    dig_.result = simulate(operation(), std::nullopt);
    if (!dig_.result.is_complete && !operation().until) {
      wrong(item_.place(), "digging takes longer than 1e8 s of working time, some three years",
            "more diggers and trucks; or limit 40 h; for what is done in that time");
      return std::nullopt;
    }
    return std::move(dig_);
  }

 private:
  using Clause = syntax::DigItem::Clause;

  /// Of an earth come the volume, and swell and density unless they are given.
  void take_volume() {
    if (!soil_) {
      const auto given = volume(subject_, *item_.volume, "what is dug");
      if (given) operation().volume = in_mm3(*given);
      return;
    }
    const EarthSpec& earth = subject_.model.earths[static_cast<std::size_t>(soil_->earth)];
    operation().volume = soil_->volume;
    dig_.earth = soil_->earth;
    dig_.soil = soil_->component;
    dig_.before = soil_->before;
    dig_.after = soil_->after;
    dig_.swell = earth.swell;
    density_ = earth.density;
  }

  hauling::Operation& operation() { return dig_.operation; }

  void wrong(Span span, std::string message, std::string hint = {}) {
    subject_.error("P55", span, std::move(message), std::move(hint));
  }

  const std::string& crew_name(int crew) const {
    return subject_.model.crews[static_cast<std::size_t>(crew)].name;
  }

  void take(const Clause& clause) {
    const std::string& key = clause.key.text;
    const auto [first, is_new] = given_.emplace(key, clause.key.span);
    if (!is_new) {
      subject_.twice(clause.key.span, key + " is given twice", first->second);
      return;
    }
    if (clause.frame || !clause.places.empty() || key == "layer" || key == "tolerance" ||
        key == "clearance") {
      wrong(clause.key.span,
            fmt::format("{} is of a dig by a robot, and here crews dig by durations", key),
            "by EXCAVATOR; where EXCAVATOR is a robot");
    } else if (clause.is_stage) {
      take_stage(clause);
    } else if (clause.trucks) {
      const auto found = subject_.crews.find(clause.trucks->text);
      if (found != subject_.crews.end()) dig_.trucks = found->second;
      if (clause.is_timed) operation().loading = time_of(clause);
    } else {
      take_number(key, *clause.number);
    }
  }

  void take_stage(const Clause& clause) {
    if (clause.key.text == "pass") {
      operation().loading = time_of(clause);
      if (clause.by) wrong(clause.by->span, "a pass is made by those who dig");
      return;
    }
    hauling::Stage stage;
    stage.name = clause.key.text;
    stage.time = time_of(clause);
    if (stage.name == "tip") operation().tip = operation().stages.size();
    if (clause.by) {
      const auto found = subject_.crews.find(clause.by->text);
      if (found != subject_.crews.end()) {
        servers_.push_back({found->second, clause.by->span});
        stage.by = clause.by->text;
        stage.servers = units_of_(found->second);
      }
    }
    operation().stages.push_back(std::move(stage));
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

  std::optional<double> number(const syntax::Number& value, UnitKind kind, const std::string& what,
                               double least, double most) {
    return bounded(subject_, value, kind, what, least, most);
  }

  void take_number(const std::string& key, const syntax::Number& value) {
    if (key == "swell") {
      dig_.swell = number(value, UnitKind::none, key, 0, kMostSwell).value_or(0);
    } else if (key == "fill_factor") {
      fill_ = number(value, UnitKind::none, key, 0.01, 2).value_or(1);
    } else if (key == "efficiency") {
      operation().efficiency = number(value, UnitKind::none, key, 0.01, 1).value_or(1);
    } else if (key == "density") {
      density_ = number(value, UnitKind::density, key, 1, kMostDensity);
    } else if (key == "payload") {
      payload_ = number(value, UnitKind::mass, key, 0.1, kMostPayload);
    } else if (key == "limit") {
      const auto seconds = resolve_duration(subject_, value, key);
      if (!seconds) return;
      operation().until = std::llround(*seconds * hauling::kPerSecond);
      if (soil_) wrong(value.span, "what is dug of an earth is dug to its end: no limit");
      if (*seconds <= 0) wrong(value.span, "the limit of a dig is 0: nothing is done");
    } else if (key == "loaded") {
      const auto count = number(value, UnitKind::none, key, 0, 1e6);
      operation().loaded = static_cast<int>(count.value_or(0));
      if (count && std::floor(*count) != *count) {
        wrong(value.span, fmt::format("expected a whole number of trucks, found {:g}", *count));
      }
    } else {
      (key == "bed" ? bed_ : bucket_) = volume(subject_, value, key);
    }
  }

  Span place_of(const std::string& key) const {
    const auto found = given_.find(key);
    return found == given_.end() ? item_.place() : found->second;
  }
  bool is_given(const std::string& key) const { return given_.count(key) != 0; }

  void check_who() {
    if (!is_given("load")) {
      wrong(item_.place(), "dig does not say who hauls the soil", "load trucks takes 4 min;");
    }
    if (diggers_.empty()) {
      wrong(item_.place(), "nobody digs: by names the crew of diggers", "by excavator;");
    }
    if (dig_.trucks >= 0) operation().trucks = units_of_(dig_.trucks);
    for (const CrewUnits& each : diggers_) {
      operation().diggers.push_back({crew_name(each.crew), each.units});
      if (each.crew == dig_.trucks) {
        wrong(place_of("load"),
              fmt::format("crew '{}' digs and hauls; expected two crews", crew_name(each.crew)));
      }
    }
    std::map<int, Span> serve;
    for (const auto& [crew, span] : servers_) {
      const auto digs = [&, c = crew](const CrewUnits& each) { return each.crew == c; };
      const bool is_busy =
          crew == dig_.trucks || std::any_of(diggers_.begin(), diggers_.end(), digs);
      if (is_busy || !serve.emplace(crew, span).second) {
        wrong(span,
              fmt::format("crew '{}' does something else in this task already: each crew "
                          "does one thing in a dig",
                          crew_name(crew)),
              "give what serves here a crew of its own");
      }
    }
    if (is_given("loaded") && dig_.trucks >= 0 && operation().loaded > operation().trucks) {
      wrong(place_of("loaded"),
            fmt::format("{} trucks are loaded at the beginning, and there are {}",
                        operation().loaded, operation().trucks));
    }
  }

  void check_stages() {
    if (!is_given("tip")) {
      wrong(item_.place(), "the trucks never tip: a stage of their round is called tip",
            "haul takes 6 min; tip takes 1 min; return takes 5 min;");
    }
    const bool is_timed = std::any_of(item_.clauses.begin(), item_.clauses.end(),
                                      [](const Clause& each) { return each.is_timed; });
    const bool has_pass = is_given("pass");
    if (is_given("load") && is_timed == has_pass) {
      wrong(has_pass ? place_of("pass") : place_of("load"),
            is_timed ? "loading has a duration for a truck and one for a pass; expected one of them"
                     : "dig does not say how long loading takes",
            "load trucks takes 4 min;, or bucket 1.2 m3; pass takes 20 s;");
    }
    if (has_pass != bucket_.has_value() && has_pass != is_given("bucket")) {
      wrong(
          has_pass ? place_of("pass") : place_of("bucket"),
          has_pass ? "pass needs the bucket that is filled" : "bucket needs how long a pass takes",
          "bucket 1.2 m3; pass takes 20 s;");
    }
    if (is_given("fill_factor") && !is_given("bucket")) {
      wrong(place_of("fill_factor"), "fill_factor is of a bucket, and dig has none",
            "bucket 1.2 m3; pass takes 20 s;");
    }
  }

  /// By volume and by mass, whichever is full first.
  void check_load() {
    if (!is_given("bed") && !is_given("payload")) {
      wrong(item_.place(), "dig does not say how much a truck takes",
            "bed 12 m3; or payload 20 t; density 1.8 t per m3;");
    }
    if (is_given("payload") ? !density_ : is_given("density")) {
      wrong(is_given("payload") ? place_of("payload") : place_of("density"),
            is_given("payload") ? "payload needs the density of the soil as it lies"
                                : "density is for the payload of trucks, and dig has none",
            "payload 20 t; density 1.8 t per m3;");
      return;
    }
    const double loose = 1 + dig_.swell;
    double load = bed_ ? *bed_ / loose : kMostSoil;
    if (payload_ && density_) load = std::min(load, *payload_ / *density_);
    operation().load = std::max<hauling::CubicMillimetres>(in_mm3(load), 1);
    if (!bucket_) return;
    operation().bucket = std::max<hauling::CubicMillimetres>(in_mm3(*bucket_ * fill_ / loose), 1);
  }

  /// Rounds that take no time would never end before the limit.
  bool takes_time() {
    const auto takes = [](const hauling::StageTime& time) {
      return time.law ? time.law->most() > 0 : time.seconds > 0;
    };
    bool found = takes(operation().loading);
    for (const hauling::Stage& stage : operation().stages) found = found || takes(stage.time);
    if (!found) wrong(item_.place(), "nothing in the rounds of the trucks takes time");
    return found;
  }

  Subject& subject_;
  const syntax::DigItem& item_;
  const std::optional<DugSoil>& soil_;
  const std::vector<CrewUnits>& diggers_;
  const std::function<int(int crew)>& units_of_;
  DigSpec dig_;
  std::map<std::string, Span> given_;
  std::vector<std::pair<int, Span>> servers_;
  std::optional<double> bed_, bucket_, density_, payload_;
  double fill_ = 1;
};

}  // namespace

std::optional<sampling::DurationLaw> resolve_law(Subject& subject,
                                                 const syntax::DurationLaw& written) {
  sampling::DurationLaw law;
  law.law = *sampling::find_law(written.name.text);
  if (law.law == sampling::Law::measured) {
    law.measured = resolve_measured(subject, written);
    return law.measured ? std::optional(std::move(law)) : std::nullopt;
  }
  for (const syntax::Number& value : written.values) {
    const auto seconds = resolve_duration(subject, value, "a value of " + written.name.text);
    if (!seconds) return std::nullopt;
    law.values.push_back(*seconds);
  }
  const std::string fault = law.fault();
  if (fault.empty()) return law;
  subject.error("P52", written.span, fault);
  return std::nullopt;
}

std::vector<int> crews_of_dig(Subject& subject, const syntax::DigItem& item) {
  std::vector<int> result;
  const auto add = [&](const syntax::Name& name, const char* what) {
    if (subject.robots.count(name.text) != 0 || subject.pools.count(name.text) != 0) {
      subject.error("P55", name.span,
                    fmt::format("{} is done by a crew, but '{}' is a {}", what, name.text,
                                subject.pools.count(name.text) != 0 ? "pool" : "robot"),
                    "crew trucks { size 4; cost 85 per h; }");
      return;
    }
    const int crew = subject.find(subject.crews, name, "crew");
    if (crew >= 0) result.push_back(crew);
  };
  for (const syntax::DigItem::Clause& clause : item.clauses) {
    if (clause.trucks) add(*clause.trucks, "hauling");
    if (clause.by) add(*clause.by, clause.key.text.c_str());
  }
  return result;
}

std::optional<DigSpec> resolve_dig(Subject& subject, const syntax::DigItem& item,
                                   const std::optional<DugSoil>& soil,
                                   const std::vector<CrewUnits>& diggers,
                                   const std::function<int(int crew)>& units_of) {
  return DigCheck(subject, item, soil, diggers, units_of).run();
}

}  // namespace rubicon::interpreter::plan_check
