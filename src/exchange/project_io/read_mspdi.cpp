#include <array>
#include <cstdlib>

#include "src/exchange/project_io/fields.hpp"
#include "src/exchange/project_io/mspdi_calendar_pugixml.hpp"
#include "src/exchange/project_io/read_project.hpp"
#include "src/exchange/project_io/tidy_project.hpp"

namespace rubicon::project_io {

namespace {

using interpreter::Span;

/// What Project computes from the rest whenever it opens a file.
constexpr std::array<const char*, 15> kComputed = {
    "IsNull",         "OutlineNumber", "WBSLevel",   "Critical",     "Estimated",
    "EarlyStart",     "EarlyFinish",   "LateStart",  "LateFinish",   "StartVariance",
    "FinishVariance", "FreeSlack",     "TotalSlack", "DurationText", "StartText"};

/// LinkLag counts tenths of minutes.
constexpr std::int64_t kSecondsPerLagUnit = 6;

/// Largest lag, in LinkLag's units: 300 years, or as many percent.
constexpr std::int64_t kMaxLag = 1600000000;

class MspdiReader {
 public:
  explicit MspdiReader(interpreter::FileId file) { reading_.file = file; }

  std::optional<Project> read(const pugi::xml_node& root, interpreter::Diagnostics& diagnostics) {
    XmlElement element(root, reading_);
    visit_project(project_, element);
    element.take("SaveVersion");
    for (const pugi::xml_node& list : element.take_all("Calendars")) {
      each(list, "Calendar", [&](const pugi::xml_node& node) {
        places_.calendars.push_back(reading_.span(node));
        project_.calendars.push_back(read_mspdi_calendar(node, reading_));
      });
    }
    for (const pugi::xml_node& list : element.take_all("Tasks")) {
      each(list, "Task", [&](const pugi::xml_node& node) { read_task(node); });
    }
    for (const pugi::xml_node& list : element.take_all("Resources")) {
      each(list, "Resource", [&](const pugi::xml_node& node) { read_resource(node); });
    }
    for (const pugi::xml_node& list : element.take_all("Assignments")) {
      each(list, "Assignment", [&](const pugi::xml_node& node) { read_assignment(node); });
    }
    element.finish();
    tidy_project(project_, places_, reading_.listing);
    reading_.listing.report(diagnostics);
    if (reading_.listing.has_errors()) return std::nullopt;
    return std::move(project_);
  }

 private:
  /// Every element of a list; what else stands in it is listed.
  template <typename Read>
  void each(const pugi::xml_node& list, const char* name, const Read& read) {
    XmlElement element(list, reading_);
    for (const pugi::xml_node& node : element.take_all(name)) read(node);
    element.finish();
  }

  void read_task(const pugi::xml_node& node) {
    XmlElement element(node, reading_);
    if (text_in(node.child("IsNull")) == "1") {
      reading_.listing.add("I07", "blank", reading_.span(node), "a blank row is left out");
      return;
    }
    Task task;
    require_duration(node, element);
    visit_task(task, element);
    for (const char* name : kComputed) element.take(name);
    if (text_in(node.child("Estimated")) == "1") task.format.estimated = true;
    std::vector<Span> places;
    for (const pugi::xml_node& link : element.take_all("PredecessorLink")) {
      if (read_link(link, task)) places.push_back(reading_.span(link));
    }
    for (const pugi::xml_node& baseline : element.take_all("Baseline")) {
      read_baseline(baseline, task);
    }
    element.finish();
    project_.tasks.push_back(std::move(task));
    places_.tasks.push_back(reading_.span(node));
    places_.links.push_back(std::move(places));
  }

  /// A task whose duration cannot be read is no task of 0 h. That of a heading counts for nothing.
  void require_duration(const pugi::xml_node& node, XmlElement& element) {
    const pugi::xml_node child = node.child("Duration");
    const std::string text = text_in(child);
    Duration duration;
    if (text.find_first_not_of(" \t\r\n") == std::string::npos ||
        project_io::read(text, duration) || text_in(node.child("Summary")) == "1") {
      return;
    }
    element.take("Duration");
    interpreter::Diagnostic diagnostic;
    diagnostic.severity = interpreter::Severity::error;
    diagnostic.code = "I03";
    diagnostic.span = reading_.span(child);
    diagnostic.message = fmt::format("expected {} in Duration of Task, found '{}'",
                                     expected_for(text, duration), text);
    diagnostic.hint = "correct it in the schedule";
    reading_.listing.add(std::move(diagnostic), "duration");
  }

  /// Of up to eleven baselines the first; its work and cost are left out.
  void read_baseline(const pugi::xml_node& node, Task& task) {
    XmlElement element(node, reading_);
    int number = 0;
    element("", "Number", number);
    if (number != 0) return;
    element("", "Start", task.baseline_start);
    element("", "Finish", task.baseline_finish);
  }

  bool read_link(const pugi::xml_node& node, Task& task) {
    constexpr std::array<LinkType, 4> kTypes = {LinkType::FF, LinkType::FS, LinkType::SF,
                                                LinkType::SS};
    XmlElement element(node, reading_);
    Link link;
    int type = 1;
    bool other_project = false;
    element("", "PredecessorUID", link.predecessor);
    element("", "Type", type);
    element("", "CrossProject", other_project);
    element("", "LinkLag", link.lag);
    element("", "LagFormat", link.format);
    element.finish();
    if (other_project) {
      reading_.listing.add("I07", "cross project", reading_.span(node),
                           fmt::format("task '{}' waits for a task of another project; the link is "
                                       "left out",
                                       task.name));
      return false;
    }
    if (type < 0 || type > 3) {
      reading_.listing.add("I03", "link type", reading_.span(node),
                           fmt::format("expected a type of link from 0 to 3, found {}; taken as 1, "
                                       "finish to start",
                                       type));
      type = 1;
    }
    link.type = kTypes[static_cast<std::size_t>(type)];
    if (std::abs(link.lag) > kMaxLag) {
      reading_.listing.add("I03", "lag", reading_.span(node),
                           fmt::format("{} is no sensible lag; left out", link.lag));
      link.lag = 0;
    }
    if (link.format.unit != TimeUnit::percent) link.lag *= kSecondsPerLagUnit;
    task.after.push_back(link);
    return true;
  }

  void read_resource(const pugi::xml_node& node) {
    XmlElement element(node, reading_);
    Resource resource;
    visit_resource(resource, element);
    bool blank = false, cost = false;
    element("", "IsNull", blank);
    element("", "IsCostResource", cost);  // its type is then 0, as of a material
    if (cost) resource.type = ResourceType::cost;
    // Project keeps a row without a name for work that nobody does.
    if (blank || (resource.uid == 0 && resource.name.empty())) return;
    element.finish();
    project_.resources.push_back(std::move(resource));
    places_.resources.push_back(reading_.span(node));
  }

  void read_assignment(const pugi::xml_node& node) {
    XmlElement element(node, reading_);
    Assignment assignment;
    visit_assignment(assignment, element);
    element.finish();
    project_.assignments.push_back(std::move(assignment));
    places_.assignments.push_back(reading_.span(node));
  }

  XmlReading reading_;
  Project project_;
  ProjectPlaces places_;
};

void report_broken(const pugi::xml_parse_result& result, const std::string& text,
                   interpreter::FileId file, interpreter::Diagnostics& diagnostics) {
  const auto offset = static_cast<std::size_t>(std::max<std::ptrdiff_t>(result.offset, 0));
  const auto begin = static_cast<std::uint32_t>(std::min(offset, text.size()));
  std::string reason = result.description();
  if (!reason.empty() && reason.front() >= 'A' && reason.front() <= 'Z') {
    reason.front() = static_cast<char>(reason.front() - 'A' + 'a');
  }
  diagnostics.error("I01", {file, begin, begin + 1}, fmt::format("this XML is broken: {}", reason),
                    "the file may be cut off; export it again");
}

}  // namespace

std::optional<Project> read_mspdi(const interpreter::SourceMap& sources, interpreter::FileId file,
                                  interpreter::Diagnostics& diagnostics) {
  const std::string& text = sources.file(file).text;
  pugi::xml_document document;
  const pugi::xml_parse_result result =
      document.load_buffer(text.data(), text.size(), pugi::parse_default, pugi::encoding_utf8);
  if (!result) {
    report_broken(result, text, file, diagnostics);
    return std::nullopt;
  }
  MspdiReader reader(file);
  const pugi::xml_node root = document.document_element();
  const std::string space = root.attribute("xmlns").value();
  const bool is_project = std::strcmp(root.name(), "Project") == 0 &&
                          (space.empty() || space == "http://schemas.microsoft.com/project");
  if (!is_project) {
    XmlReading place{file, {}};
    diagnostics.error("I02", place.span(root),
                      fmt::format("expected the element Project of Microsoft Project XML, found "
                                  "'{}'{}",
                                  root.name(), space.empty() ? "" : " of " + space),
                      "in Microsoft Project: save as XML");
    return std::nullopt;
  }
  return reader.read(root, diagnostics);
}

}  // namespace rubicon::project_io
