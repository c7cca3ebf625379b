#include "src/exchange/project_io/xer_columns.hpp"

#include <fmt/format.h>

#include <set>

#include "src/exchange/project_io/decode_text.hpp"

namespace rubicon::project_io {

namespace {

using Columns = std::set<std::string_view>;

/// The columns that are read, and those that only join rows. All others are listed if any row has
/// something in them.
const std::map<std::string_view, Columns>& known_columns() {
  static const std::map<std::string_view, Columns> columns = {
      {"CURRTYPE", {"curr_id", "curr_short_name", "curr_symbol", "decimal_symbol"}},
      {"PROJECT",
       {"proj_id", "proj_short_name", "plan_start_date", "plan_end_date", "clndr_id",
        "task_code_base", "last_recalc_date", "export_flag"}},
      {"CALENDAR",
       {"clndr_id", "clndr_name", "base_clndr_id", "clndr_data", "default_flag", "day_hr_cnt",
        "week_hr_cnt", "clndr_type", "proj_id"}},
      {"PROJWBS",
       {"wbs_id", "proj_id", "parent_wbs_id", "wbs_short_name", "wbs_name", "seq_num",
        "proj_node_flag"}},
      {"TASK",
       {"task_id",
        "proj_id",
        "wbs_id",
        "clndr_id",
        "task_type",
        "task_code",
        "task_name",
        "target_drtn_hr_cnt",
        "target_start_date",
        "target_end_date",
        "act_start_date",
        "act_end_date",
        "early_end_date",
        "reend_date",
        "phys_complete_pct",
        "cstr_type",
        "cstr_date",
        "cstr_type2",
        "cstr_date2",
        "target_work_qty"}},
      {"TASKPRED",
       {"task_pred_id", "task_id", "pred_task_id", "proj_id", "pred_proj_id", "pred_type",
        "lag_hr_cnt"}},
      {"RSRC",
       {"rsrc_id", "rsrc_name", "rsrc_short_name", "clndr_id", "rsrc_type", "email_addr",
        "rsrc_notes"}},
      {"RSRCRATE", {"rsrc_rate_id", "rsrc_id", "cost_per_qty", "max_qty_per_hr", "start_date"}},
      {"TASKRSRC",
       {"taskrsrc_id", "task_id", "proj_id", "rsrc_id", "target_qty", "target_qty_per_hr",
        "target_start_date", "target_end_date"}},
  };
  return columns;
}

/// Each column that is not read, at the first row that has something in it.
void list_columns(std::string_view name, const XerTable& table, const Columns& known,
                  Listing& listing) {
  std::vector<bool> settled(table.columns.size());
  for (std::size_t i = 0; i < settled.size(); ++i) settled[i] = known.contains(table.columns[i]);
  for (const XerRow& row : table.rows) {
    for (std::size_t i = 0; i < row.cells().size(); ++i) {
      if (settled[i] || row.cells()[i].empty()) continue;
      settled[i] = true;
      listing.add(
          "I07", fmt::format("column {}.{}", name, table.columns[i]), row.span(),
          fmt::format("column {} of {} is not taken over, here '{}'", clean_text(table.columns[i]),
                      clean_text(name), clean_text(row.cells()[i])));
    }
  }
}

}  // namespace

void list_unread(const XerFile& xer, Listing& listing) {
  for (const auto& [name, table] : xer.tables) {
    const auto known = known_columns().find(name);
    if (known == known_columns().end()) {
      if (table.rows.empty()) continue;
      if (name == "SCHEDOPTIONS") {
        listing.add("I07", "options", table.span,
                    "of table SCHEDOPTIONS only the calendar of lags is taken over");
        continue;
      }
      listing.add(
          "I07", fmt::format("table {}", name), table.span,
          fmt::format("table {} is not taken over ({} rows)", clean_text(name), table.rows.size()));
      continue;
    }
    list_columns(name, table, known->second, listing);
  }
}

}  // namespace rubicon::project_io
