#include "src/exchange/building_io/building_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "interpreter/parse/parse.hpp"
#include "src/exchange/building_io/component_text.hpp"
#include "src/exchange/building_io/elements_table.hpp"
#include "src/exchange/building_io/matching.hpp"
#include "src/exchange/building_io/names.hpp"
#include "src/exchange/building_io/stock_layout.hpp"
#include "src/exchange/project_io/identifiers.hpp"
#include "src/exchange/project_io/plan_terms.hpp"
#include "src/exchange/project_io/plan_text.hpp"

namespace rubicon::building_io {

namespace {

/// Groups of things that a warning names before it says how many more there are.
constexpr std::size_t kGroupsShown = 20;
constexpr std::size_t kTasksShown = 40;

/// kg/m3, where nothing is said: reinforced concrete (EN 1991-1-1, table A.1: 25 kN/m3).
constexpr double kAssumedDensity = 2500;
/// kg, the most that a plan takes.
constexpr double kMostMass = 1e8;

/// What both kinds of plan have.
class PlanParts {
 public:
  PlanParts(const Elements& elements, const PlanNames& names) : elements_(elements.all) {
    for (Element& element : elements_) {
      if (!element.mesh) continue;
      element.mesh_file = fmt::format("{}/{}.obj", names.mesh_folder, element.component);
      result.meshes.push_back({element.mesh_file, mesh_text(element),
                               std::make_shared<const geometry::TriangleMesh>(*element.mesh)});
    }
    remarks = "\n";
    for (const std::string& note : elements.notes) remarks += "// " + note + "\n";
    if (elements.origin != Vec3::Zero()) {
      remarks += fmt::format(
          "// The point {}, {}, {} of the model is the origin of this plan: what lies far out "
          "loses "
          "digits.\n",
          number_text(elements.origin.x()), number_text(elements.origin.y()),
          number_text(elements.origin.z()));
    }
  }

  const std::vector<Element>& elements() const { return elements_; }

  BuildingPlan result;
  std::string remarks;  ///< at the beginning of the plan

 private:
  std::vector<Element> elements_;
};

class WorkWriter {
 public:
  WorkWriter(const Elements& elements, const BuildingTasks& tasks, const PlanNames& names,
             interpreter::Diagnostics& diagnostics)
      : origin_(elements.origin),
        tasks_(tasks),
        match_(*tasks.match),
        diagnostics_(diagnostics),
        parts_(elements, names) {}

  BuildingPlan write() {
    matching_ = match_elements(parts_.elements(), match_, *tasks_.project, diagnostics_);
    rows_.resize(elements().size());
    for (std::size_t i = 0; i < elements().size(); ++i) rows_[i].element = &elements()[i];
    insert_.workers = match_.workers;
    insert_.calendars = match_.calendars;
    // What models draw often hangs in the air, by their builder's precision; and the bearers of the
    // stock are no components.
    const bool says_support = match_.plan_items.find("support") != std::string::npos;
    const std::string support =
        fmt::format("support warn;\nsupport gap {} mm;  // what waits lies on bearers of {:g} m\n",
                    std::lround(1000 * kBearer) + 1, kBearer);
    insert_.items = parts_.remarks + (says_support ? "" : support) + match_.plan_items + "\n";
    list_idle_tasks();
    list_elements(matching_.unmatched, "unmatched", "no rule is about");
    list_elements(matching_.left_out, "left out", "a rule leaves out");
    write_standing();
    if (nobody_lifts()) return {};
    write_moved();
    parts_.result.plan = project_io::plan_text(*tasks_.project, tasks_.schedule, diagnostics_,
                                               insert_, tasks_.levelling, tasks_.baselines);
    parts_.result.elements = elements_table(rows_, origin_);
    return std::move(parts_.result);
  }

 private:
  const std::vector<Element>& elements() const { return parts_.elements(); }

  /// Tasks that put nothing into place keep the duration the schedule gives them.
  void list_idle_tasks() {
    if (matching_.idle_tasks.empty()) return;
    std::vector<std::string> names;
    insert_.items += fmt::format("// {} without an element; they keep their duration:\n",
                                 counted(matching_.idle_tasks.size(), "task"));
    for (const std::size_t i : matching_.idle_tasks) {
      names.push_back(matching_.plan_names[i]);
      insert_.items += fmt::format("//   {}\n", matching_.plan_names[i]);
    }
    diagnostics_.warning(
        "I16", {},
        fmt::format("{} of the schedule without an element; they keep their duration: {}",
                    counted(names.size(), "task"), joined(names, kTasksShown)));
  }

  void list_elements(const std::vector<std::size_t>& which, const char* fate, const char* why) {
    if (which.empty()) return;
    std::map<std::string, int> groups;
    insert_.items +=
        fmt::format("// {} that {}; no part of the plan:\n", counted(which.size(), "element"), why);
    for (const std::size_t i : which) {
      const Element& element = elements()[i];
      rows_[i].fate = fate;
      insert_.items += fmt::format("//   {}\n", element_remark(element));
      std::string group = element.type.empty() ? "" : element.type + " ";
      group += remark_name(element.name);
      if (!element.storey.empty()) group += " of " + remark_name(element.storey);
      ++groups[group];
    }
    std::vector<std::string> names;
    for (const auto& [group, count] : groups) names.push_back(fmt::format("{} {}", count, group));
    diagnostics_.warning(
        "I15", {},
        fmt::format("{} that {}; no part of the plan: {}", counted(which.size(), "element"), why,
                    joined(names, kGroupsShown)));
  }

  void write_standing() {
    for (const std::size_t i : matching_.standing) {
      rows_[i].fate = "stands";
      ComponentTerms terms;
      terms.at = elements()[i].frame.origin - origin_;
      terms.turn_deg = elements()[i].frame.turn_deg;
      insert_.items += component_text(elements()[i], terms);
    }
  }

  /// Whether a rule with elements does not say who lifts them; told of the first.
  bool nobody_lifts() {
    std::optional<std::size_t> first;
    for (const Activity& activity : matching_.activities) {
      for (const Activity::Move& move : activity.moves) {
        if (!match_.rules[move.rule].terms.by.empty()) continue;
        first = std::min(first.value_or(move.rule), move.rule);
      }
    }
    if (!first) return false;
    diagnostics_.error("I12", match_.rules[*first].span,
                       "this rule does not say who lifts its elements",
                       "above the rules or in their braces: by ROBOT, CREW;");
    return true;
  }

  void write_moved() {
    std::vector<StockItem> items;
    for (std::size_t a = 0; a < matching_.activities.size(); ++a) {
      for (const Activity::Move& move : matching_.activities[a].moves) {
        items.push_back(
            {elements()[move.element].frame.size, match_.rules[move.rule].terms.stock, a});
      }
    }
    const auto places = lay_out(items, match_.stocks);
    report_room(items, places);
    std::size_t item = 0;
    for (const Activity& activity : matching_.activities) {
      for (const Activity::Move& move : activity.moves) {
        write_move(activity, move, places[item++].value_or(StockPlace{}));
      }
    }
    report_masses();
  }

  void write_move(const Activity& activity, const Activity::Move& move, const StockPlace& place) {
    const project_io::Task& task = tasks_.project->tasks[activity.task];
    const double hours = static_cast<double>(project_io::plan_seconds(task)) / 3600;
    const Element& element = elements()[move.element];
    const MoveTerms& how = match_.rules[move.rule].terms;
    ComponentTerms terms;
    terms.at = place.origin;
    terms.turn_deg = place.turn_deg;
    terms.grip = how.grip;
    terms.mass = mass_of(element, how);
    terms.mass_source = mass_source_;
    insert_.items += component_text(element, terms);
    project_io::PlanInsert::Part part;
    part.name = std::string(kPartPrefix) + element.component;
    part.awaited = !how.unlinked;
    parts_.result.rules.emplace(element.component, move.rule);
    part.items =
        fmt::format("by {};\nmove {} to {};\n", how.by, element.component, target_text(element));
    for (const auto& [word, text] : {std::pair("hook", &how.hook),
                                     {"adjust", &how.adjust},
                                     {"release", &how.release},
                                     {"priority", &how.priority}}) {
      if (!text->empty()) part.items += fmt::format("{} {};\n", word, *text);
    }
    ElementRow& row = rows_[move.element];
    row.fate = "moved";
    row.activity = activity.plan_name;
    row.hours = number_text(hours);
    row.task = part.name;
    row.mass = terms.mass;
    insert_.parts[task.uid].push_back(std::move(part));
  }

  std::string target_text(const Element& element) const {
    return frame_or_identity(element.frame.origin - origin_, element.frame.turn_deg);
  }

  std::string mass_of(const Element& element, const MoveTerms& how) {
    mass_source_.clear();
    if (!how.mass.empty()) return how.mass;
    if (!how.density) {
      mass_source_ = fmt::format("assumed: reinforced concrete, {:g} kg/m3", kAssumedDensity);
    }
    if (!how.density) assumed_.push_back(element.component);
    const double density = how.density.value_or(kAssumedDensity);
    const double mass = std::round(element.frame.volume * density);
    if (mass >= 1) return fmt::format("{:.0f}", mass);
    without_mass_.push_back(element.component);
    // More than it can be.
    mass_source_ = fmt::format("the box around it, filled: {:g} kg/m3", density);
    const double full = std::ceil(element.frame.size.prod() * density);
    return fmt::format("{:.0f}", std::clamp(full, 1.0, kMostMass));
  }

  void report_masses() {
    if (!assumed_.empty()) {
      diagnostics_.warning(
          "I18", {},
          fmt::format("{} without a mass or a density in {} rule: taken as reinforced concrete, "
                      "{:g} kg/m3: {}",
                      counted(assumed_.size(), "element"), assumed_.size() == 1 ? "its" : "their",
                      kAssumedDensity, joined(assumed_, kGroupsShown)),
          "give one in their rule: { density 1750; } or { mass 120; }");
    }
    if (without_mass_.empty()) return;
    diagnostics_.warning(
        "I18", {},
        fmt::format("{} without a mass, for the surface is not closed; taken as the box around "
                    "it, filled: {}",
                    counted(without_mass_.size(), "element"), joined(without_mass_, kGroupsShown)),
        "give one in their rule: { mass 120; }");
  }

  void report_room(const std::vector<StockItem>& items,
                   const std::vector<std::optional<StockPlace>>& places) {
    std::map<std::string, std::vector<std::string>> without;  // by area
    std::size_t item = 0;
    for (const Activity& activity : matching_.activities) {
      for (const Activity::Move& move : activity.moves) {
        if (!places[item]) without[items[item].stock].push_back(elements()[move.element].component);
        ++item;
      }
    }
    for (const auto& [area, names] : without) {
      const std::string where = match_.stocks.empty() ? "for there is no stock area"
                                : area.empty()        ? "in the stock areas"
                                                      : fmt::format("in stock area '{}'", area);
      diagnostics_.error(
          "I17", {},
          fmt::format("{} of {} without room {}: {}", names.size(),
                      counted(places.size(), "element"), where, joined(names, kGroupsShown)),
          "in the match file: stock box(x0, y0, z0, x1, y1, z1) stack 5 gap 0.5 m; as high as what "
          "waits there");
    }
  }

  Vec3 origin_;
  const BuildingTasks& tasks_;
  const MatchFile& match_;
  interpreter::Diagnostics& diagnostics_;
  PlanParts parts_;
  Matching matching_;
  project_io::PlanInsert insert_;
  std::vector<ElementRow> rows_;
  std::vector<std::string> without_mass_, assumed_;
  std::string mass_source_;  ///< of the last one, where nobody gave it
};

}  // namespace

BuildingPlan standing_building(const Elements& elements, const PlanNames& names) {
  PlanParts parts(elements, names);
  std::string text = fmt::format(
      "plan {} {{\n{}\n", project_io::Identifiers().make(names.plan, "building"), parts.remarks);
  std::vector<ElementRow> rows;
  for (const Element& element : parts.elements()) {
    ComponentTerms terms;
    terms.at = element.frame.origin - elements.origin;
    terms.turn_deg = element.frame.turn_deg;
    text += component_text(element, terms);
    rows.push_back({&element, "stands", "", "", "", ""});
  }
  parts.result.plan = interpreter::format_text(text + "}\n", interpreter::TextKind::plan);
  parts.result.elements = elements_table(rows, elements.origin);
  return std::move(parts.result);
}

BuildingPlan building_under_work(const Elements& elements, const BuildingTasks& tasks,
                                 const PlanNames& names, interpreter::Diagnostics& diagnostics) {
  return WorkWriter(elements, tasks, names, diagnostics).write();
}

}  // namespace rubicon::building_io
