#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "src/results/verify/input/json_fields.hpp"
#include "src/results/verify/schedule/schedule_row.hpp"

namespace rubicon::verify {

namespace {

/// The lines of a text in which objects stand in lines of their own, in order.
class LineFinder {
 public:
  explicit LineFinder(const std::string& text) : text_(text) {}

  /// The line of the next object with this member.
  int next(const char* member, const std::string& value) {
    const std::string wanted = fmt::format("\"{}\":", member) +
                               Json(value).dump(-1, ' ', false, Json::error_handler_t::replace);
    const std::size_t found = text_.find(wanted, place_);
    if (found == std::string::npos) return line_;
    line_ += static_cast<int>(std::count(text_.begin() + static_cast<std::ptrdiff_t>(place_),
                                         text_.begin() + static_cast<std::ptrdiff_t>(found), '\n'));
    place_ = found;
    return line_;
  }

 private:
  const std::string& text_;
  std::size_t place_ = 0;
  int line_ = 1;
};

/// Splits a CSV text (RFC 4180) into rows of fields, with the line of each row.
class CsvReader {
 public:
  explicit CsvReader(const std::string& text) : text_(text) {}

  bool next(std::vector<std::string>& row, int& line) {
    if (at_ >= text_.size()) return false;
    row.clear();
    line = line_;
    do {
      row.push_back(field());
    } while (take(','));
    take('\r');
    if (!take('\n') && at_ < text_.size()) {
      throw UnreadableInput(fmt::format("{}: expected the end of the line", line_));
    }
    ++line_;
    return true;
  }

 private:
  bool take(char wanted) {
    if (at_ >= text_.size() || text_[at_] != wanted) return false;
    ++at_;
    return true;
  }

  std::string field() {
    std::string value;
    if (!take('"')) {
      while (at_ < text_.size() && text_[at_] != ',' && text_[at_] != '\n' && text_[at_] != '\r') {
        value += text_[at_++];
      }
      return value;
    }
    while (at_ < text_.size()) {
      const char c = text_[at_++];
      if (c == '\n') ++line_;
      if (c == '"' && !take('"')) return value;
      value += c;
    }
    throw UnreadableInput(fmt::format("{}: expected a closing quote", line_));
  }

  const std::string& text_;
  std::size_t at_ = 0;
  int line_ = 1;
};

/// A CSV text whose first row names the columns.
class CsvTable {
 public:
  explicit CsvTable(const std::string& text) : reader_(text) {
    if (!next()) throw UnreadableInput("1: expected a line of column names");
    for (std::size_t i = 0; i < fields_.size(); ++i) columns_[fields_[i]] = i;
  }

  bool next() { return reader_.next(fields_, line_); }
  int line() const { return line_; }
  bool has(const char* name) const { return columns_.contains(name); }
  /// Of the row: throws where there is no such column.
  const std::string& field(const char* name) const {
    const auto column = columns_.find(name);
    if (column == columns_.end() || column->second >= fields_.size()) {
      throw UnreadableInput(fmt::format("{}: expected a column '{}'", line_, name));
    }
    return fields_[column->second];
  }

 private:
  CsvReader reader_;
  std::vector<std::string> fields_;
  std::map<std::string, std::size_t> columns_;
  int line_ = 0;
};

/// Seconds in a table: moments of a plan lie within 126 years.
constexpr double kLongestInTable = 4e9;
/// Attempts in a table; more is none.
constexpr double kMostAttempts = 2e9;

double number_in(const std::string& field, int line, double largest) {
  double value = 0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (error != std::errc() || end != field.data() + field.size() ||
      !(std::fabs(value) <= largest)) {
    throw UnreadableInput(fmt::format("{}: expected a number, found '{}'", line, field));
  }
  return value;
}

Ticks ticks_of(double seconds) {
  return static_cast<Ticks>(std::floor(seconds * static_cast<double>(kSecond) + 0.5));
}

std::optional<double> money_if_any(const JsonFields& fields, const char* name) {
  return fields.has(name) ? std::optional(fields.money(name)) : std::nullopt;
}

std::optional<double> number_if_any(const JsonFields& fields, const char* name) {
  return fields.has(name) ? std::optional(fields.number(name)) : std::nullopt;
}

RowJoints read_joints(const JsonFields& fields) {
  RowJoints joints;
  joints.after = fields.time("after");
  joints.count = fields.integer("count");
  joints.length = fields.number("length");
  joints.oldest = fields.time("oldest");
  for (const Json& object : fields.array("places")) {
    const JsonFields place(object, "a cold joint");
    const auto number = [&](const char* name, std::size_t i) {
      const Json& values = place.array(name);
      if (values.size() != 2) place.fail("x and y of a place");
      return number_of(values[i], "a place");
    };
    joints.places.push_back({number("from", 0), number("from", 1), number("to", 0), number("to", 1),
                             place.time("age"), place.time("laid"), place.time("joined")});
  }
  return joints;
}

RowCover read_row_cover(const JsonFields& fields) {
  const auto whole = [&](const char* name) {
    return fields.has(name) ? std::optional(fields.integer(name)) : std::nullopt;
  };
  return {fields.text("area"),
          number_if_any(fields, "covered"),
          number_if_any(fields, "covered_area"),
          number_if_any(fields, "volume"),
          number_if_any(fields, "length"),
          number_if_any(fields, "depth"),
          whole("turns"),
          whole("holes")};
}

std::int64_t count_of(const JsonFields& fields, const char* name) {
  const Json& value = fields.any(name);
  if (!value.is_number_integer()) fields.fail(fmt::format("a whole number as '{}'", name));
  return value.get<std::int64_t>();
}

RowDig read_row_dig(const JsonFields& fields) {
  RowDig dig;
  dig.volume = fields.number("volume");
  dig.tipped = fields.number("tipped");
  dig.load = fields.number("load");
  dig.loads = count_of(fields, "loads");
  if (fields.has("passes")) dig.passes = count_of(fields, "passes");
  dig.working = fields.time("working");
  dig.per_hour = fields.number("per_hour");
  dig.cost_per_m3 = number_if_any(fields, "cost_per_m3");
  dig.fuel_per_m3 = number_if_any(fields, "fuel_per_m3");
  dig.trucks = fields.integer("trucks");
  dig.mean_loading = fields.number("mean_loading");
  dig.mean_round = fields.number("mean_round");
  dig.match_factor = fields.number("match_factor");
  for (const Json& object : fields.array("queues")) {
    const JsonFields queue(object, "a queue of a dig");
    dig.queues.push_back({queue.text("stage"), queue.text("by"), queue.integer("servers"),
                          count_of(queue, "served"), queue.number("mean_wait"),
                          queue.time("longest_wait"), queue.number("mean_length"),
                          queue.number("utilisation")});
  }
  return dig;
}

RowMotionDig read_row_motion_dig(const JsonFields& fields) {
  RowMotionDig dig;
  dig.volume = fields.number("volume");
  dig.dug = fields.number("dug");
  dig.bucket = fields.number("bucket");
  dig.buckets = count_of(fields, "buckets");
  dig.working = fields.time("working");
  dig.per_hour = fields.number("per_hour");
  dig.cost_per_m3 = number_if_any(fields, "cost_per_m3");
  dig.fuel_per_m3 = number_if_any(fields, "fuel_per_m3");
  const JsonFields mean = fields.object("mean");
  dig.cycle = mean.number("cycle");
  dig.to_the_cut = mean.number("to_the_cut");
  dig.cut = mean.number("cut");
  dig.swing = mean.number("swing");
  dig.dump = mean.number("dump");
  if (!fields.has("trucks")) return dig;
  dig.trucks = count_of(fields, "trucks");
  dig.loads = count_of(fields, "loads");
  dig.load = number_if_any(fields, "load");
  dig.waited = fields.time("waited");
  return dig;
}

RowHaul read_row_haul(const JsonFields& fields) {
  RowHaul haul;
  haul.hauled = fields.number("hauled");
  haul.working = fields.time("working");
  const JsonFields mean = fields.object("mean");
  haul.queue = mean.number("queue");
  haul.loading = mean.number("loading");
  haul.haul = mean.number("haul");
  haul.tip = mean.number("tip");
  haul.back = mean.number("back");
  for (const Json& object : fields.array("loads")) {
    const JsonFields load(object, "a load");
    haul.loads.push_back({load.text("dig"), load.number("volume"), load.time("arrived"),
                          load.time("began"), load.time("loaded"), load.time("at_tip"),
                          load.time("tipped")});
  }
  return haul;
}

HaulingRow read_hauling(const JsonFields& fields) {
  return {fields.number("hauled"),
          fields.number("working"),
          fields.number("per_hour"),
          number_if_any(fields, "cost_per_m3"),
          number_if_any(fields, "fuel_per_m3"),
          number_if_any(fields, "match_factor")};
}

ScheduleRow read_row(const JsonFields& fields) {
  ScheduleRow row;
  row.task = fields.text("task");
  row.robot = fields.text("robot");
  row.crew = fields.text("crew");
  row.start = fields.time("start");
  row.duration = fields.time("duration");
  const JsonFields waited = fields.object("waited");
  row.split = {fields.time("motion"),   fields.time("work"),    waited.time("predecessor"),
               waited.time("resource"), waited.time("machine"), waited.time("shift")};
  if (waited.has("repair")) row.split.repair = waited.time("repair");
  if (fields.has("thinking")) row.split.thinking = fields.time("thinking");
  if (fields.has("workspaces")) {
    const JsonFields workspaces = fields.object("workspaces");
    if (workspaces.has("foreseen")) {
      row.foreseen = std::pair(workspaces.integer("foreseen"), workspaces.integer("rounds"));
    }
  }
  row.cost = money_if_any(fields, "cost");
  row.fuel = number_if_any(fields, "fuel");
  row.begins = fields.text_or("begins", "");
  row.ends = fields.text_or("ends", "");
  row.tried = fields.integer("tried");
  row.accepted = fields.integer("accepted");
  row.result = fields.text("result");
  row.reason = fields.text("reason");
  if (fields.has("due")) row.due = fields.time("due");
  if (fields.has("late")) row.late = fields.time("late");
  if (fields.has("baseline")) {
    const JsonFields baseline = fields.object("baseline");
    row.baseline = std::pair(baseline.time("start"), baseline.time("finish"));
    row.baseline_begins = baseline.text_or("begins", "");
    row.baseline_ends = baseline.text_or("ends", "");
  }
  row.attributes = fields.texts("attributes");
  row.component = fields.text_or("component", "");
  row.parking = fields.has("parking") && fields.truth("parking");
  row.choice = fields.text_or("choice", "");
  if (fields.has("dig")) row.dig = read_row_dig(fields.object("dig"));
  if (fields.has("motion_dig")) {
    row.motion_dig = read_row_motion_dig(fields.object("motion_dig"));
  }
  if (fields.has("haul")) row.haul = read_row_haul(fields.object("haul"));
  if (fields.has("cover")) {
    const JsonFields cover = fields.object("cover");
    row.cover = read_row_cover(cover);
    if (cover.has("cold_joints")) row.joints = read_joints(cover.object("cold_joints"));
  }
  if (fields.has("float")) {
    const JsonFields floats = fields.object("float");
    row.floats = RowFloat{floats.time("total"), floats.time("free"), floats.time("latest_start"),
                          floats.time("latest_finish")};
  }
  return row;
}

UseRow read_use(const JsonFields& fields) {
  UseRow use;
  use.name = fields.text("name");
  use.kind = fields.text("kind");
  if (fields.has("size")) use.size = fields.integer("size");
  use.tasks = fields.integer("tasks");
  use.held = fields.time("held");
  use.busy = fields.time("busy");
  use.shifts = fields.time("shifts");
  use.utilisation = fields.number("utilisation");
  use.rate = money_if_any(fields, "cost_per_hour");
  use.cost = money_if_any(fields, "cost");
  use.fuel = number_if_any(fields, "fuel");
  return use;
}

}  // namespace

ScheduleJson read_schedule_json(const std::string& text) {
  const Json json = parse_json(text);
  const JsonFields schedule(json, "the schedule");
  ScheduleJson read;
  read.process_time = schedule.time("process_time");
  read.cost = money_if_any(schedule, "cost");
  read.fuel = number_if_any(schedule, "fuel");
  if (schedule.has("hauling")) read.hauling = read_hauling(schedule.object("hauling"));
  if (schedule.has("cost_by_kind")) {
    for (const auto& [kind, amount] : schedule.object("cost_by_kind").json().items()) {
      read.cost_by_kind[kind] = number_of(amount, "'cost_by_kind'", kLargestMoney);
    }
  }
  read.start_at = schedule.text_or("start_at", "");
  read.ends = schedule.text_or("ends", "");
  read.currency = schedule.text_or("currency", "");
  LineFinder lines(text);
  for (const Json& object : schedule.array("tasks")) {
    read.rows.push_back(read_row(JsonFields(object, "a task of the schedule")));
    read.rows.back().line = lines.next("task", read.rows.back().task);
  }
  for (const Json& object : schedule.array("resources")) {
    read.uses.push_back(read_use(JsonFields(object, "a robot or crew of the schedule")));
    read.uses.back().line = lines.next("name", read.uses.back().name);
  }
  for (const Json& object : schedule.array("critical")) {
    const JsonFields fields(object, "a task of the critical path");
    read.critical.push_back(
        {0, fields.text("task"), fields.truth("work_counts"), fields.text("text")});
    read.critical.back().line = lines.next("task", read.critical.back().task);
  }
  if (schedule.has("breakdowns")) {
    for (const Json& object : schedule.array("breakdowns")) {
      const JsonFields fields(object, "a breakdown");
      read.breakdowns.push_back({fields.text("robot"), fields.text("during"), fields.time("worked"),
                                 fields.time("repair"), fields.time("from"), fields.time("to")});
    }
  }
  if (schedule.has("lost_days")) {
    for (const Json& object : schedule.array("lost_days")) {
      const JsonFields fields(object, "lost days of a calendar");
      LostDaysRecord& lost = read.lost_days.emplace_back();
      lost.calendar = fields.text("calendar");
      lost.of = fields.integer("working_days");
      for (const Json& day : fields.array("dates")) lost.days.push_back(text_of(day, "a date"));
      if (fields.integer("lost") != static_cast<int>(lost.days.size())) {
        fields.fail("as many dates as days lost");
      }
    }
  }
  if (schedule.has("components")) {
    for (const Json& object : schedule.array("components")) {
      const JsonFields fields(object, "a component");
      read.components[fields.text("component")] = fields.texts("attributes");
    }
  }
  return read;
}

std::vector<ScheduleRow> read_schedule_csv(const std::string& text) {
  CsvTable table(text);
  const auto field = [&](const char* name) { return table.field(name); };
  const auto ticks = [&](const char* name) {
    return ticks_of(number_in(field(name), table.line(), kLongestInTable));
  };
  std::vector<ScheduleRow> rows;
  while (table.next()) {
    const int line = table.line();
    ScheduleRow row;
    row.line = line;
    row.task = field("task");
    row.robot = field("robot");
    row.crew = field("crew");
    row.start = ticks("start");
    row.duration = ticks("duration");
    row.split = {ticks("motion"),          ticks("work"),           ticks("waited_predecessor"),
                 ticks("waited_resource"), ticks("waited_machine"), ticks("waited_shift")};
    if (table.has("waited_repair")) row.split.repair = ticks("waited_repair");
    if (table.has("thinking")) row.split.thinking = ticks("thinking");
    if (!field("cost").empty()) row.cost = number_in(field("cost"), line, kLargestMoney);
    row.begins = field("begins");
    row.ends = field("ends");
    row.tried = static_cast<int>(number_in(field("tried"), line, kMostAttempts));
    row.accepted = static_cast<int>(number_in(field("accepted"), line, kMostAttempts));
    row.result = field("result");
    row.reason = field("reason");
    if (!field("due").empty()) row.due = ticks("due");
    if (!field("late").empty()) row.late = ticks("late");
    if (!field("baseline_start").empty()) {
      row.baseline = std::pair(ticks("baseline_start"), ticks("baseline_finish"));
    }
    if (!field("total_float").empty())
      row.floats = RowFloat{ticks("total_float"), ticks("free_float"), 0, 0};
    if (table.has("component_name")) {
      row.texts =
          RowTexts{field("name"), field("component"), field("component_name"), field("storey"),
                   field("type"), field("guid"),      field("attributes")};
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<LoadRow> read_loads_csv(const std::string& text) {
  std::vector<LoadRow> rows;
  if (text.empty()) return rows;
  CsvTable table(text);
  const auto number = [&](const char* name) {
    return number_in(table.field(name), table.line(), kLongestInTable);
  };
  while (table.next()) {
    rows.push_back({table.line(), table.field("task"), table.field("by"),
                    static_cast<std::int64_t>(number("load")),
                    static_cast<std::int64_t>(number("truck")), number("arrived"), number("began"),
                    number("loaded"), number("tipped"), number("volume")});
  }
  return rows;
}

}  // namespace rubicon::verify
