#include "src/exchange/project_io/write_mspdi.hpp"

#include <fmt/format.h>

#include <pugixml.hpp>

#include "src/exchange/project_io/fields.hpp"
#include "src/exchange/project_io/value_text.hpp"

namespace rubicon::project_io {

namespace {

class StringWriter : public pugi::xml_writer {
 public:
  void write(const void* data, size_t size) override {
    text.append(static_cast<const char*>(data), size);
  }
  std::string text;
};

void add(pugi::xml_node& node, const char* element, const std::string& text) {
  node.append_child(element).append_child(pugi::node_pcdata).set_value(text.c_str());
}

std::string xml_text(const Moment& moment) {
  std::string text = moment.text;
  text[10] = 'T';
  return text.size() == 16 ? text + ":00" : text;
}

/// Writes the fields of one element that differ from those of an empty one.

class FieldWriter {
 public:
  explicit FieldWriter(pugi::xml_node node) : node_(node) {}

  template <typename T>
  void operator()(const char* /*word*/, const char* element, const T& member) {
    if constexpr (std::is_same_v<T, Moment>) {
      if (!member.text.empty()) add(node_, element, xml_text(member));
    } else if constexpr (std::is_same_v<T, TimeFormat>) {
      add(node_, element, text_of(mspdi_code(member)));
    } else if constexpr (std::is_same_v<T, std::string>) {
      if (!member.empty()) add(node_, element, member);
    } else {
      add(node_, element, text_of(member));
    }
  }

 private:
  pugi::xml_node node_;
};

std::string clock_text(int minutes) {
  return fmt::format("{:02}:{:02}:00", minutes / 60 % 24, minutes % 60);
}

void write_times(pugi::xml_node node, const DayTimes& times) {
  add(node, "DayWorking", times.empty() ? "0" : "1");
  if (times.empty()) return;
  pugi::xml_node list = node.append_child("WorkingTimes");
  for (const Interval& interval : times) {
    pugi::xml_node time = list.append_child("WorkingTime");
    add(time, "FromTime", clock_text(interval.from));
    add(time, "ToTime", clock_text(interval.to));
  }
}

void write_calendar(pugi::xml_node node, const Calendar& calendar) {
  add(node, "UID", text_of(calendar.uid));
  if (!calendar.name.empty()) add(node, "Name", calendar.name);
  add(node, "IsBaseCalendar", calendar.base == kNone ? "1" : "0");
  add(node, "BaseCalendarUID", text_of(calendar.base));
  pugi::xml_node week = node.append_child("WeekDays");
  for (std::size_t i = 0; i < 7; ++i) {
    const std::size_t day = (i + 6) % 7;  // theirs starts on Sunday
    if (!calendar.week[day]) continue;
    pugi::xml_node entry = week.append_child("WeekDay");
    add(entry, "DayType", text_of(static_cast<int>(i) + 1));
    write_times(entry, *calendar.week[day]);
  }
  if (calendar.exceptions.empty()) return;
  pugi::xml_node list = node.append_child("Exceptions");
  for (const CalendarException& exception : calendar.exceptions) {
    pugi::xml_node entry = list.append_child("Exception");
    add(entry, "EnteredByOccurrences", "0");
    pugi::xml_node period = entry.append_child("TimePeriod");
    add(period, "FromDate", exception.first + "T00:00:00");
    add(period, "ToDate", exception.last + "T23:59:00");
    if (!exception.name.empty()) add(entry, "Name", exception.name);
    add(entry, "Type", "1");
    write_times(entry, exception.times);
  }
}

void write_link(pugi::xml_node node, const Link& link) {
  constexpr std::array<int, 4> kTypes = {1, 3, 0, 2};  // FS, SS, FF, SF
  add(node, "PredecessorUID", text_of(link.predecessor));
  add(node, "Type", text_of(kTypes[static_cast<std::size_t>(link.type)]));
  add(node, "CrossProject", "0");
  const bool percent = link.format.unit == TimeUnit::percent;
  add(node, "LinkLag", text_of(percent ? link.lag : link.lag / 6));  // tenths of minutes
  add(node, "LagFormat", text_of(mspdi_code(link.format)));
}

/// Project's numbers of the columns Text1 to Text30 of a task (constants pjCustomTaskText1 ... of
/// its object model).
std::string text_field_id(std::size_t index) {
  constexpr std::array<int, 10> kFirstTen = {188743731, 188743734, 188743737, 188743740, 188743743,
                                             188743746, 188743747, 188743748, 188743749, 188743750};
  constexpr int kEleventh = 188743997;
  return text_of(index < kFirstTen.size() ? kFirstTen[index]
                                          : kEleventh + static_cast<int>(index - kFirstTen.size()));
}

void write_text_fields(pugi::xml_node root, const std::vector<std::string>& names) {
  if (names.empty()) return;
  pugi::xml_node list = root.append_child("ExtendedAttributes");
  for (std::size_t i = 0; i < names.size(); ++i) {
    pugi::xml_node field = list.append_child("ExtendedAttribute");
    add(field, "FieldID", text_field_id(i));
    add(field, "FieldName", fmt::format("Text{}", i + 1));
    add(field, "Alias", names[i]);
  }
}

/// Numbers the lines of an outline: 1, 1.1, 1.2, 2.
class OutlineNumbers {
 public:
  std::string next(int level) {
    if (level == 0) return "0";
    counts_.resize(static_cast<std::size_t>(level), 0);
    ++counts_.back();
    return fmt::format("{}", fmt::join(counts_, "."));
  }

 private:
  std::vector<int> counts_;
};

void write_baseline(pugi::xml_node node, const Task& task) {
  if (task.baseline_start.text.empty() && task.baseline_finish.text.empty()) return;
  pugi::xml_node baseline = node.append_child("Baseline");
  add(baseline, "Number", "0");
  FieldWriter fields(baseline);
  fields("", "Start", task.baseline_start);
  fields("", "Finish", task.baseline_finish);
}

void write_tasks(pugi::xml_node list, const Project& project) {
  OutlineNumbers numbers;
  for (std::size_t i = 0; i < project.tasks.size(); ++i) {
    Task task = project.tasks[i];
    task.summary = task.summary || project.is_heading(i);
    pugi::xml_node node = list.append_child("Task");
    FieldWriter fields(node);
    visit_task(task, fields);
    pugi::xml_node number = node.insert_child_before("OutlineNumber", node.child("OutlineLevel"));
    number.append_child(pugi::node_pcdata).set_value(numbers.next(task.level).c_str());
    write_baseline(node, task);
    for (const Link& link : task.after) write_link(node.append_child("PredecessorLink"), link);
    for (const auto& [field, text] : task.texts) {
      pugi::xml_node value = node.append_child("ExtendedAttribute");
      add(value, "FieldID", text_field_id(static_cast<std::size_t>(field)));
      add(value, "Value", text);
    }
  }
}

void write_resource(pugi::xml_node node, const Resource& resource) {
  Resource written = resource;
  // A cost is a material with a mark of its own.
  if (resource.type == ResourceType::cost) written.type = ResourceType::material;
  FieldWriter fields(node);
  visit_resource(written, fields);
  if (resource.type != ResourceType::cost) return;
  add(node, "IsCostResource", "1");
}

void write_assignment(pugi::xml_node node, const Assignment& assignment) {
  // Project's number for work that nobody does.
  constexpr std::int64_t kUnassigned = -65535;
  Assignment written = assignment;
  if (written.resource == kNone) written.resource = kUnassigned;
  FieldWriter fields(node);
  visit_assignment(written, fields);
}

}  // namespace

std::string write_mspdi(const Project& project) {
  pugi::xml_document document;
  pugi::xml_node declaration = document.append_child(pugi::node_declaration);
  declaration.append_attribute("version") = "1.0";
  declaration.append_attribute("encoding") = "UTF-8";
  declaration.append_attribute("standalone") = "yes";
  pugi::xml_node root = document.append_child("Project");
  root.append_attribute("xmlns") = "http://schemas.microsoft.com/project";
  add(root, "SaveVersion", "14");
  FieldWriter fields(root);
  visit_project(project, fields);
  write_text_fields(root, project.text_fields);
  pugi::xml_node calendars = root.append_child("Calendars");
  for (const Calendar& calendar : project.calendars) {
    write_calendar(calendars.append_child("Calendar"), calendar);
  }
  write_tasks(root.append_child("Tasks"), project);
  pugi::xml_node resources = root.append_child("Resources");
  for (const Resource& resource : project.resources) {
    write_resource(resources.append_child("Resource"), resource);
  }
  pugi::xml_node assignments = root.append_child("Assignments");
  for (const Assignment& assignment : project.assignments) {
    write_assignment(assignments.append_child("Assignment"), assignment);
  }
  StringWriter writer;
  document.save(writer, "  ", pugi::format_default, pugi::encoding_utf8);
  return std::move(writer.text);
}

}  // namespace rubicon::project_io
