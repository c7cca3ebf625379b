#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>
#include <unordered_map>

#include "src/exchange/project_io/decode_text.hpp"
#include "src/exchange/project_io/plan_terms.hpp"
#include "src/exchange/project_io/read_project.hpp"
#include "src/exchange/project_io/tidy_project.hpp"
#include "src/exchange/project_io/value_text.hpp"
#include "src/exchange/project_io/xer_calendar.hpp"
#include "src/exchange/project_io/xer_columns.hpp"
#include "src/exchange/project_io/xer_number.hpp"
#include "src/exchange/project_io/xer_table.hpp"

namespace rubicon::project_io {

namespace {

using interpreter::Span;
class XerReader {
 public:
  XerReader(const XerFile& xer, Listing& listing)
      : xer_(xer),
        listing_(listing),
        currency_(currency_of(xer)),
        decimal_(decimal_symbol(currency_)) {}

  /// Null if there is no project.
  std::optional<Project> read() {
    const XerRow* project = choose_project();
    if (project == nullptr) return std::nullopt;
    project_id_ = (*project)["proj_id"];
    project_.name = text((*project)["proj_short_name"]);
    cell(*project, "PROJECT", "plan_start_date", project_.start);
    cell(*project, "PROJECT", "plan_end_date", project_.finish);
    read_currency();
    read_calendars();
    reference(*project, "PROJECT", "clndr_id", project_.calendar);
    read_resources();
    read_tasks();
    read_links();
    read_assignments();
    settle_calendars();
    cell(*project, "PROJECT", "last_recalc_date", data_date_);
    hold_to_data_date();
    tidy_project(project_, places_, listing_);
    settle_lags();
    list_unread(xer_, listing_);
    return std::move(project_);
  }

 private:
  const std::vector<XerRow>& rows(std::string_view table) const {
    static const std::vector<XerRow> none;
    const auto found = xer_.tables.find(table);
    return found == xer_.tables.end() ? none : found->second.rows;
  }

  static std::string text(std::string_view cell) {
    std::string result = clean_text(cell);
    for (char& c : result) {
      if (c == '\x7f') c = '\n';
    }
    return result.find_first_not_of(" \t\r\n") == std::string::npos ? std::string() : result;
  }

  /// Whether a schedule can do without a cell that says nothing sensible. Not without those by
  /// which its tasks have their dates.
  enum class Weight { left_out, decides };

  void refuse(Weight weight, const std::string& kind, const XerRow& row, std::string message,
              std::string hint = {}) {
    interpreter::Diagnostic diagnostic;
    diagnostic.severity =
        weight == Weight::decides ? interpreter::Severity::error : interpreter::Severity::warning;
    diagnostic.code = "I03";
    diagnostic.span = row.span();
    diagnostic.message = std::move(message) + (weight == Weight::decides ? "" : "; left out");
    diagnostic.hint = std::move(hint);
    listing_.add(std::move(diagnostic), kind);
  }

  template <typename T>
  bool read_cell(std::string_view text, T& value) const {
    return project_io::read(text, value);
  }
  bool read_cell(std::string_view text, double& value) const {
    return read_xer_number(text, decimal_, value);
  }

  template <typename T>
  void cell(const XerRow& row, const char* table, const char* column, T& value,
            Weight weight = Weight::left_out) {
    const std::string_view found = row[column];
    if (found.empty() || read_cell(found, value)) return;
    refuse(weight, fmt::format("cell {}.{}", table, column), row,
           fmt::format("expected {} in column {} of {}, found '{}'", expected(value), column, table,
                       clean_text(found)),
           std::is_same_v<T, double> ? decimal_hint(found) : std::string());
  }

  /// What to say of a number that may have the wrong decimal symbol.
  std::string decimal_hint(std::string_view found) const {
    if (found.find_first_of(",.") == std::string_view::npos) return {};
    const std::string code =
        currency_ == nullptr ? std::string() : text((*currency_)["curr_short_name"]);
    return fmt::format("the decimal symbol of this file is '{}'{}", clean_text(decimal_),
                       code.empty() ? "" : ", that of its currency " + code);
  }

  /// A number that names another row; none if there is none.
  void reference(const XerRow& row, const char* table, const char* column, std::int64_t& value) {
    cell(row, table, column, value);
  }

  /// Hours with a fraction, as whole seconds; a lag may be negative.
  void hours(const XerRow& row, const char* table, const char* column, std::int64_t& seconds,
             Weight weight = Weight::left_out) {
    constexpr double kMaxHours = 2.7e6;  // 300 years
    double value = 0;
    cell(row, table, column, value, weight);
    if (std::abs(value) > kMaxHours) {
      refuse(weight, fmt::format("hours {}", column), row,
             fmt::format("{} hours in column {} is no sensible time", value, column));
      return;
    }
    seconds = std::llround(value * 3600);
  }

  /// Hours of work or duration.
  void hours_from_0(const XerRow& row, const char* table, const char* column, std::int64_t& seconds,
                    Weight weight = Weight::left_out) {
    hours(row, table, column, seconds, weight);
    if (seconds >= 0) return;
    refuse(weight, fmt::format("cell {}.{}", table, column), row,
           fmt::format("expected 0 hours or more in column {} of {}, found '{}'", column, table,
                       clean_text(row[column])));
    seconds = 0;
  }

  /// The first with activities of those that were exported. P6 sends along what is linked to them:
  /// projects whose export_flag is not Y.
  const XerRow* choose_project() {
    const std::vector<XerRow>& projects = rows("PROJECT");
    std::set<std::string_view> with_tasks;
    for (const XerRow& row : rows("TASK")) with_tasks.insert(row["proj_id"]);
    const auto is_exported = [](const XerRow& row) { return row["export_flag"] == "Y"; };
    const bool is_told = std::any_of(projects.begin(), projects.end(), is_exported);
    const auto chosen = std::find_if(projects.begin(), projects.end(), [&](const XerRow& row) {
      return (!is_told || is_exported(row)) &&
             (with_tasks.empty() || with_tasks.contains(row["proj_id"]));
    });
    for (auto row = projects.begin(); row != projects.end(); ++row) {
      if (row == chosen) continue;
      const bool is_linked = is_told && !is_exported(*row);
      listing_.add("I07", is_linked ? "linked project" : "project", row->span(),
                   fmt::format("project '{}' is left out: {}", text((*row)["proj_short_name"]),
                               is_linked ? "it was not exported, only what is linked to another"
                                         : "one plan holds one project"),
                   "export it into a file of its own");
    }
    return chosen == projects.end() ? nullptr : &*chosen;
  }

  void read_currency() {
    if (currency_ == nullptr) return;
    project_.currency_code = text((*currency_)["curr_short_name"]);
    project_.currency_symbol = text((*currency_)["curr_symbol"]);
  }

  void read_calendars() {
    for (const XerRow& row : rows("CALENDAR")) {
      Calendar calendar;
      cell(row, "CALENDAR", "clndr_id", calendar.uid);
      reference(row, "CALENDAR", "base_clndr_id", calendar.base);
      calendar.name = text(row["clndr_name"]);
      if (!row["clndr_data"].empty() && !read_xer_calendar(row["clndr_data"], calendar)) {
        listing_.add("I03", "clndr_data", row.span(),
                     fmt::format("the working times of calendar '{}' could not be read to the end",
                                 calendar.name));
      }
      if (row["default_flag"] == "Y") {
        project_.calendar = calendar.uid;
        double day = 0, week = 0;
        cell(row, "CALENDAR", "day_hr_cnt", day);
        cell(row, "CALENDAR", "week_hr_cnt", week);
        if (day > 0 && day <= 24) project_.minutes_per_day = static_cast<int>(day * 60);
        if (week > 0 && week <= 168) project_.minutes_per_week = static_cast<int>(week * 60);
      }
      project_.calendars.push_back(std::move(calendar));
      places_.calendars.push_back(row.span());
    }
  }

  void read_resources() {
    std::unordered_map<std::int64_t, std::size_t> index;
    for (const XerRow& row : rows("RSRC")) {
      Resource resource;
      cell(row, "RSRC", "rsrc_id", resource.uid);
      reference(row, "RSRC", "clndr_id", resource.calendar);
      resource.name = text(row["rsrc_name"]);
      resource.code = text(row["rsrc_short_name"]);
      resource.email = text(row["email_addr"]);
      resource.notes = text(row["rsrc_notes"]);
      resource.id = static_cast<std::int64_t>(project_.resources.size()) + 1;
      if (row["rsrc_type"] == "RT_Mat") resource.type = ResourceType::material;
      index.emplace(resource.uid, project_.resources.size());
      project_.resources.push_back(std::move(resource));
      places_.resources.push_back(row.span());
    }
    std::unordered_map<std::int64_t, Moment> since;  // by resource, from when its rate is
    for (const XerRow& row : rows("RSRCRATE")) {
      std::int64_t uid = kNone;
      cell(row, "RSRCRATE", "rsrc_id", uid);
      const auto found = index.find(uid);
      if (found == index.end()) continue;
      Resource& resource = project_.resources[found->second];
      Moment from;
      cell(row, "RSRCRATE", "start_date", from);
      const auto [known, is_first] = since.try_emplace(uid, from);
      if (!is_first) {
        listing_.add("I07", "rates", row.span(),
                     fmt::format("resource '{}' has several rates: the one at the beginning of the "
                                 "project is taken for all of it",
                                 resource.name));
        // The last that has begun by then, else the first.
        const bool has_begun = from.text <= project_.start.text;
        const bool better = known->second.text <= project_.start.text
                                ? has_begun && from.text > known->second.text
                                : has_begun || from.text < known->second.text;
        if (!better) continue;
        known->second = from;
      }
      cell(row, "RSRCRATE", "cost_per_qty", resource.standard_rate);
      cell(row, "RSRCRATE", "max_qty_per_hr", resource.max_units);
    }
  }

  // ---- the outline: the work breakdown and its activities --------------------------------------

  struct Branch {
    const XerRow* row = nullptr;
    std::vector<std::size_t> below;  ///< branches
    std::vector<const XerRow*> tasks;
    bool has_parent = false;
  };

  void read_tasks() {
    std::vector<Branch> branches;
    std::unordered_map<std::string_view, std::size_t> index;
    for (const XerRow& row : rows("PROJWBS")) {
      if (row["proj_id"] != project_id_) continue;
      if (!index.emplace(row["wbs_id"], branches.size()).second) {
        listing_.add("I04", "wbs twice", row.span(),
                     fmt::format("wbs_id {} is there twice; the second is left out",
                                 clean_text(row["wbs_id"])));
        continue;
      }
      branches.push_back({&row, {}, {}, false});
    }
    for (std::size_t i = 0; i < branches.size(); ++i) {
      const auto parent = index.find((*branches[i].row)["parent_wbs_id"]);
      if (parent == index.end() || parent->second == i) continue;
      branches[i].has_parent = true;
      branches[parent->second].below.push_back(i);
    }
    std::vector<const XerRow*> without;
    for (const XerRow& row : rows("TASK")) {
      largest_uid_ = std::max(largest_uid_, uid_of(row));
      if (row["proj_id"] != project_id_) continue;
      const auto branch = index.find(row["wbs_id"]);
      if (branch == index.end()) {
        without.push_back(&row);
      } else {
        branches[branch->second].tasks.push_back(&row);
      }
    }
    std::vector<bool> done(branches.size(), false);
    for (std::size_t i = 0; i < branches.size(); ++i) {
      if (!branches[i].has_parent) add_branch(branches, i, done);
    }
    // Branches that are each other's parents hang on nothing.
    for (std::size_t i = 0; i < branches.size(); ++i) {
      if (done[i]) continue;
      listing_.add("I06", "wbs ring", branches[i].row->span(),
                   fmt::format("the work breakdown of '{}' runs in a ring; it is put at the top",
                               text((*branches[i].row)["wbs_name"])));
      add_branch(branches, i, done);
    }
    for (const XerRow* row : without) add_task(*row, 1);
  }

  /// A branch with all that is below it; without recursion, and each branch once.
  void add_branch(const std::vector<Branch>& branches, std::size_t root, std::vector<bool>& done) {
    std::vector<std::pair<std::size_t, int>> open = {{root, 1}};
    while (!open.empty()) {
      const auto [at, level] = open.back();
      open.pop_back();
      if (done[at]) continue;
      done[at] = true;
      const Branch& branch = branches[at];
      const XerRow& row = *branch.row;
      // The node of the project itself stands for no work.
      const bool is_project = row["proj_node_flag"] == "Y";
      const int below = is_project ? level : level + 1;
      if (!is_project) {
        Task task;
        task.uid = ++largest_uid_;
        task.name = text(row["wbs_name"]);
        task.code = text(row["wbs_short_name"]);
        task.level = level;
        task.summary = true;
        push(std::move(task), row.span());
      }
      for (const XerRow* each : branch.tasks) add_task(*each, below);
      for (auto next = branch.below.rbegin(); next != branch.below.rend(); ++next) {
        open.emplace_back(*next, below);
      }
    }
  }

  static std::int64_t uid_of(const XerRow& row) {
    std::int64_t uid = kNone;
    return project_io::read(row["task_id"], uid) ? uid : kNone;
  }

  void add_task(const XerRow& row, int level) {
    const std::string_view type = row["task_type"];
    if (row.is_short() && !type.empty() && !type.starts_with("TT_")) {
      listing_.add("I03", "shifted row", row.span(),
                   fmt::format("cells are missing before the end of this row: its task_type is "
                               "'{}'; the activity is left out",
                               clean_text(type)),
                   "export the schedule again, or put the missing cell in");
      return;
    }
    Task task;
    task.level = level;
    cell(row, "TASK", "task_id", task.uid);
    reference(row, "TASK", "clndr_id", task.calendar);
    task.name = text(row["task_name"]);
    task.code = text(row["task_code"]);
    cell(row, "TASK", "target_start_date", task.start);
    cell(row, "TASK", "target_end_date", task.finish);
    cell(row, "TASK", "act_start_date", task.actual_start);
    cell(row, "TASK", "act_end_date", task.actual_finish);
    // Of an activity under way the target is how it was planned; the rest is dated anew.
    if (!task.actual_start.text.empty() && task.actual_finish.text.empty()) {
      Moment expected;
      cell(row, "TASK", "early_end_date", expected);
      cell(row, "TASK", "reend_date", expected);
      if (!expected.text.empty()) task.finish = expected;
    }
    hours_from_0(row, "TASK", "target_drtn_hr_cnt", task.duration.seconds, Weight::decides);
    hours_from_0(row, "TASK", "target_work_qty", task.work.seconds);
    task.format.unit = TimeUnit::hours;
    double complete = 0;
    cell(row, "TASK", "phys_complete_pct", complete);
    task.percent_complete = static_cast<int>(std::clamp(complete, 0.0, 100.0));
    task.milestone = type == "TT_Mile" || type == "TT_FinMile";
    if (type == "TT_LOE" || type == "TT_WBS") {
      listing_.add(
          "I07", "level of effort", row.span(),
          fmt::format("activity '{}' lasts as long as others (level of effort or summary); "
                      "it is taken with the duration it has now",
                      task.name));
    }
    if (type == "TT_Rsrc") goes_by_resources_.insert(task.uid);
    read_constraint(row, task);
    push(std::move(task), row.span());
  }

  struct DatedConstraint {
    Constraint constraint = Constraint::as_soon_as_possible;
    Moment date;
  };

  DatedConstraint constraint_in(const XerRow& row, const char* type, const char* date) {
    static const std::map<std::string_view, Constraint> kTypes = {
        {"CS_ALAP", Constraint::as_late_as_possible},
        {"CS_MSO", Constraint::must_start_on},
        {"CS_MANDSTART", Constraint::must_start_on},
        {"CS_MEO", Constraint::must_finish_on},
        {"CS_MANDFIN", Constraint::must_finish_on},
        {"CS_MSOA", Constraint::start_no_earlier_than},
        {"CS_MSOB", Constraint::start_no_later_than},
        {"CS_MEOA", Constraint::finish_no_earlier_than},
        {"CS_MEOB", Constraint::finish_no_later_than}};
    DatedConstraint read;
    const std::string_view name = row[type];
    if (name.empty()) return read;
    const auto found = kTypes.find(name);
    if (found == kTypes.end()) {
      listing_.add("I03", "constraint", row.span(),
                   fmt::format("unknown constraint '{}'; left out", clean_text(name)));
      return read;
    }
    read.constraint = found->second;
    cell(row, "TASK", date, read.date);
    return read;
  }

  /// Whether it says when a task starts or finishes at the earliest.
  static bool bounds_below(Constraint constraint) {
    return constraint == Constraint::must_start_on || constraint == Constraint::must_finish_on ||
           constraint == Constraint::start_no_earlier_than ||
           constraint == Constraint::finish_no_earlier_than;
  }

  /// An activity has up to two constraints, in either order; a task has one. That is the one which
  /// moves the work. "Finish on or before" beside it moves nothing, as a deadline.
  void read_constraint(const XerRow& row, Task& task) {
    DatedConstraint first = constraint_in(row, "cstr_type", "cstr_date");
    DatedConstraint second = constraint_in(row, "cstr_type2", "cstr_date2");
    const bool has_first = first.constraint != Constraint::as_soon_as_possible;
    if (!has_first || (bounds_below(second.constraint) && !bounds_below(first.constraint))) {
      std::swap(first, second);
    }
    task.constraint = first.constraint;
    task.constraint_date = first.date;
    if (second.constraint == Constraint::as_soon_as_possible) return;
    if (second.constraint == Constraint::finish_no_later_than) {
      task.deadline = second.date;
      return;
    }
    listing_.add("I07", "second constraint", row.span(),
                 fmt::format("activity '{}' has two constraints: that of {} holds, that of {} is "
                             "left out",
                             task.name, shown(first), shown(second)));
  }

  static std::string shown(const DatedConstraint& constraint) {
    return constraint.date.text.empty() ? "no date" : constraint.date.text;
  }

  void push(Task task, Span span) {
    task.id = static_cast<std::int64_t>(project_.tasks.size()) + 1;
    index_.emplace(task.uid, project_.tasks.size());
    project_.tasks.push_back(std::move(task));
    places_.tasks.push_back(span);
    places_.links.emplace_back();
  }

  void read_links() {
    static const std::map<std::string_view, LinkType> kTypes = {{"PR_FS", LinkType::FS},
                                                                {"PR_SS", LinkType::SS},
                                                                {"PR_FF", LinkType::FF},
                                                                {"PR_SF", LinkType::SF}};
    for (const XerRow& row : rows("TASKPRED")) {
      if (!row["proj_id"].empty() && row["proj_id"] != project_id_) continue;
      std::int64_t uid = kNone;
      Link link;
      link.format.unit = TimeUnit::hours;
      cell(row, "TASKPRED", "task_id", uid);
      cell(row, "TASKPRED", "pred_task_id", link.predecessor);
      hours(row, "TASKPRED", "lag_hr_cnt", link.lag, Weight::decides);
      link.lag = link.lag / 6 * 6;  // tenths of a minute, as the way out has them
      const auto type = kTypes.find(row["pred_type"]);
      if (type == kTypes.end()) {
        listing_.add(
            "I03", "pred_type", row.span(),
            fmt::format("expected PR_FS, PR_SS, PR_FF or PR_SF, found '{}'; taken as PR_FS",
                        clean_text(row["pred_type"])));
      } else {
        link.type = type->second;
      }
      const auto task = index_.find(uid);
      if (task == index_.end()) {
        listing_.add("I05", "link of nobody", row.span(),
                     fmt::format("there is no activity {} for this link; it is left out", uid));
        continue;
      }
      project_.tasks[task->second].after.push_back(link);
      places_.links[task->second].push_back(row.span());
    }
  }

  void read_assignments() {
    for (const XerRow& row : rows("TASKRSRC")) {
      if (!row["proj_id"].empty() && row["proj_id"] != project_id_) continue;
      Assignment assignment;
      cell(row, "TASKRSRC", "taskrsrc_id", assignment.uid);
      cell(row, "TASKRSRC", "task_id", assignment.task);
      cell(row, "TASKRSRC", "rsrc_id", assignment.resource);
      hours(row, "TASKRSRC", "target_qty", assignment.work.seconds);
      assignment.work.seconds = std::max<std::int64_t>(assignment.work.seconds, 0);
      cell(row, "TASKRSRC", "target_qty_per_hr", assignment.units);
      cell(row, "TASKRSRC", "target_start_date", assignment.start);
      cell(row, "TASKRSRC", "target_end_date", assignment.finish);
      project_.assignments.push_back(std::move(assignment));
      places_.assignments.push_back(row.span());
    }
  }

  /// An activity goes by the calendars of its resources if it is resource dependent and has any;
  /// else by its own alone.
  void settle_calendars() {
    std::set<std::int64_t> workers, busy;
    for (const Resource& each : project_.resources) {
      if (each.type == ResourceType::work) workers.insert(each.uid);
    }
    for (const Assignment& each : project_.assignments) {
      if (workers.contains(each.resource)) busy.insert(each.task);
    }
    for (Task& task : project_.tasks) {
      if (!busy.contains(task.uid)) continue;
      if (goes_by_resources_.contains(task.uid)) {
        task.calendar = kNone;
      } else {
        if (task.calendar == kNone) task.calendar = project_.calendar;
        task.ignores_resource_calendars = task.calendar != kNone;
      }
    }
  }

  /// Lags count in a calendar that the schedule chooses, the predecessor's if it does not say:
  /// where that one never stops they are elapsed time.
  void settle_lags() {
    // Primavera writes rcal_24Hour, others in lower case.
    const std::set<std::string> known = {"rcal_predecessor", "rcal_successor", "rcal_projdefault",
                                         "rcal_24hour"};
    std::string choice = "rcal_predecessor";
    for (const XerRow& row : rows("SCHEDOPTIONS")) {
      const std::string_view said = row["sched_calendar_on_relationship_lag"];
      if (row["proj_id"] != project_id_ || said.empty()) continue;
      std::string lower(said);
      std::transform(lower.begin(), lower.end(), lower.begin(), [](char letter) {
        return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
      });
      if (known.contains(lower)) {
        choice = lower;
      } else {
        listing_.add("I03", "lag calendar", row.span(),
                     fmt::format("'{}' names no calendar of lags: they count in that of the "
                                 "predecessor",
                                 clean_text(said)));
      }
    }
    std::unordered_map<std::int64_t, std::int64_t> calendars;  // by task
    for (const Task& task : project_.tasks) calendars.emplace(task.uid, task.calendar);
    for (Task& task : project_.tasks) {
      for (Link& link : task.after) {
        if (link.lag == 0) continue;
        const std::int64_t calendar = choice == "rcal_successor" ? task.calendar
                                      : choice == "rcal_projdefault"
                                          ? project_.calendar
                                          : calendars.at(link.predecessor);
        link.format.elapsed = choice == "rcal_24hour" || works_always(project_, calendar);
      }
    }
  }

  /// What has not begun does not begin before the data date. Said of those that wait for nothing
  /// else that has not begun.
  void hold_to_data_date() {
    if (data_date_.text <= project_.start.text) return;
    const auto has_begun = [](const Task& task) {
      return !task.actual_start.text.empty() || !task.actual_finish.text.empty();
    };
    for (Task& task : project_.tasks) {
      if (task.summary || has_begun(task)) continue;
      const bool waits = std::any_of(task.after.begin(), task.after.end(), [&](const Link& link) {
        const auto from = index_.find(link.predecessor);
        const bool to_start = link.type == LinkType::FS || link.type == LinkType::SS;
        return to_start && link.lag >= 0 && from != index_.end() &&
               !has_begun(project_.tasks[from->second]);
      });
      const bool is_due = task.constraint == Constraint::finish_no_later_than;
      const bool is_free = task.constraint == Constraint::as_soon_as_possible || is_due ||
                           (task.constraint == Constraint::start_no_earlier_than &&
                            task.constraint_date.text < data_date_.text);
      if (waits || !is_free) continue;
      if (is_due) task.deadline = task.constraint_date;
      task.constraint = Constraint::start_no_earlier_than;
      task.constraint_date = data_date_;
    }
  }

  const XerFile& xer_;
  Listing& listing_;
  const XerRow* currency_;    ///< of the file; null if it has none
  std::string_view decimal_;  ///< in its numbers
  Project project_;
  Moment data_date_;  ///< up to which the schedule knows what has been done
  ProjectPlaces places_;
  std::string_view project_id_;
  std::unordered_map<std::int64_t, std::size_t> index_;
  std::int64_t largest_uid_ = 0;
  std::set<std::int64_t> goes_by_resources_;  ///< uids of resource dependent activities
};

}  // namespace

std::optional<Project> read_xer(const interpreter::SourceMap& sources, interpreter::FileId file,
                                interpreter::Diagnostics& diagnostics) {
  Listing listing;
  const std::string& text = sources.file(file).text;
  const XerFile xer = read_xer_tables(text, file, listing);
  std::optional<Project> project = XerReader(xer, listing).read();
  if (!project) {
    diagnostics.error("I02", {file, 0, 6}, "this XER file holds no project",
                      "export a project from Primavera P6 with its activities");
    return std::nullopt;
  }
  if (!xer.complete) {
    const auto end = static_cast<std::uint32_t>(text.size());
    listing.add("I01", "no end", {file, end, end},
                "this file has no last line %E: it may be cut off");
  }
  listing.report(diagnostics);
  if (listing.has_errors()) return std::nullopt;
  return project;
}

}  // namespace rubicon::project_io
