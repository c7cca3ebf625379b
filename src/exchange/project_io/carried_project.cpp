#include "src/exchange/project_io/carried_project.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "src/exchange/project_io/dates.hpp"

namespace rubicon::project_io {

namespace {

class BlockReader {
 public:
  explicit BlockReader(Listing& listing) : listing_(listing) {}

  CarriedProject run(const std::vector<CarriedRecord>& records) {
    for (const CarriedRecord& record : records) read_record(record);
    return std::move(result_);
  }

 private:
  template <typename Record, typename Visit>
  Record read_fields(const CarriedRecord& record, const Visit& visit) {
    Record result;
    CarriedReader reader(record);
    visit(result, reader);
    for (const std::string& word : reader.wrong()) {
      listing_.add(
          "I10", "field " + word, record.span,
          fmt::format("the value of '{}' in this import is not understood; left out", word));
    }
    return result;
  }

  void not_understood(const CarriedRecord& record) {
    listing_.add("I10", "statement " + record.keyword, record.span,
                 fmt::format("'{}' in this import is not understood; left out", record.keyword));
  }

  void read_record(const CarriedRecord& record) {
    const std::string& keyword = record.keyword;
    if (keyword == "project") {
      result_.project = read_fields<Project>(
          record, [](Project& project, CarriedReader& reader) { visit_project(project, reader); });
    } else if (keyword == "calendar") {
      CarriedCalendar& carried = result_.calendars[record.name];
      CarriedReader reader(record);
      reader("uid", "", carried.calendar.uid);
      reader("name", "", carried.calendar.name);
      reader("base", "", carried.calendar.base);
      reader("whole", "", carried.whole);
      result_.calendar_order.push_back(record.name);
    } else if (keyword == "week") {
      CarriedReader reader(record);
      for (std::size_t day = 0; day < 7; ++day) {
        DayTimes times;
        if (record.value(kDays[day]) == nullptr) continue;
        reader(kDays[day], "", times);
        result_.calendars[record.name].calendar.week[day] = times;
      }
    } else if (keyword == "exceptions") {
      for (const CarriedItem& item : record.items) {
        if (!read_exception(item.text, result_.calendars[record.name].calendar))
          not_understood(record);
      }
    } else if (keyword == "resource") {
      result_.resources[record.name] = read_fields<Resource>(
          record,
          [](Resource& resource, CarriedReader& reader) { visit_resource(resource, reader); });
      result_.resource_order.push_back(record.name);
    } else if (keyword == "milestone") {
      result_.milestones.insert(record.name);
    } else if (keyword == "own_crew") {
      result_.own_crews.insert(record.name);
    } else if (keyword == "free_crew") {
      CarriedReader reader(record);
      reader("calendar", "", result_.free_crews.emplace(record.name, kNone).first->second);
    } else if (keyword == "crew_of") {
      CarriedReader reader(record);
      reader("resource", "", result_.crews_of[record.name]);
    } else if (keyword == "task" || keyword == "row") {
      CarriedTask& carried = result_.tasks[record.name];
      carried.task = read_fields<Task>(
          record, [](Task& task, CarriedReader& reader) { visit_task(task, reader); });
      carried.planned = keyword == "task";
      result_.task_order.push_back(record.name);
    } else if (keyword == "fixed") {
      CarriedReader reader(record);
      CarriedTask::Fixed fixed;
      reader("start", "", fixed.start);
      reader("takes", "", fixed.takes);
      result_.tasks[record.name].fixed = fixed;
    } else if (keyword == "link") {
      read_link(record);
    } else if (keyword == "assignment") {
      result_.assignments.push_back(
          read_fields<Assignment>(record, [](Assignment& assignment, CarriedReader& reader) {
            visit_assignment(assignment, reader);
          }));
    } else {
      not_understood(record);
    }
  }

  static bool read_exception(std::string text, Calendar& calendar) {
    CalendarException exception;
    const std::size_t bar = text.find('|');
    if (bar != std::string::npos) exception.name = text.substr(bar + 1);
    text.resize(std::min(bar, text.size()));
    const std::size_t sign = text.find('=');
    if (sign != std::string::npos && !read(text.substr(sign + 1), exception.times)) return false;
    text.resize(std::min(sign, text.size()));
    exception.first = text.substr(0, 10);
    exception.last = text.size() > 10 ? text.substr(std::min<std::size_t>(12, text.size())) : text;
    const auto first = day_number(exception.first), last = day_number(exception.last);
    if (!first || !last || *last < *first) return false;
    calendar.exceptions.push_back(std::move(exception));
    return true;
  }

  void read_link(const CarriedRecord& record) {
    Link link;
    CarriedReader reader(record);
    std::string type;
    reader("predecessor", "", link.predecessor);
    reader("type", "", type);
    reader("lag", "", link.lag);
    reader("format", "", link.format);
    bool held = false;
    reader("held", "", held);
    const auto parsed = schedule::parse_link_type(type);
    if (!parsed) return not_understood(record);
    link.type = *parsed;
    CarriedTask& task = result_.tasks[record.name];
    (held ? task.held : task.links).push_back(link);
  }

  Listing& listing_;
  CarriedProject result_;
};

}  // namespace

CarriedProject read_carried_project(const std::vector<CarriedRecord>& records, Listing& listing) {
  return BlockReader(listing).run(records);
}

}  // namespace rubicon::project_io
