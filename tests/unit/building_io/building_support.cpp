#include "tests/unit/building_io/building_support.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "tests/unit/mesh_io/mesh_files_io.hpp"

namespace rubicon::test {

std::vector<std::string> said(const interpreter::Diagnostics& diagnostics,
                              const interpreter::SourceMap& sources) {
  std::vector<std::string> lines;
  for (const interpreter::Diagnostic& each : diagnostics.sorted()) {
    std::string line = each.code + " ";
    if (each.span.file < sources.size()) {
      const auto place = sources.position(each.span);
      line += fmt::format("{}:{} ", place.line, place.column);
    }
    lines.push_back(line + each.message + (each.hint.empty() ? "" : " | " + each.hint));
  }
  return lines;
}

bool says(const std::vector<std::string>& lines, const std::string& words) {
  return std::any_of(lines.begin(), lines.end(), [&](const std::string& line) {
    return line.find(words) != std::string::npos;
  });
}

ReadMatch read_match(const std::string& text) {
  interpreter::SourceMap sources;
  interpreter::Diagnostics diagnostics;
  ReadMatch result;
  result.match = building_io::read_match_file(sources, sources.add("a.match", text), diagnostics);
  result.said = said(diagnostics, sources);
  return result;
}

building_io::Element element_at(const std::string& storey, const std::string& type,
                                const std::string& name, const building_io::Vec3& at) {
  building_io::Element element;
  element.component = name;
  element.model = "a.ifc";
  element.part = "0block$_00000000000000";
  element.guid = element.part;
  element.storey = storey;
  element.type = type;
  element.name = name;
  element.frame.origin = at;
  element.frame.size = {2, 0.2, 2.5};
  element.frame.volume = 1;
  return element;
}

project_io::Project schedule_of(const std::vector<std::string>& names) {
  project_io::Project project;
  project.name = "house";
  for (const std::string& name : names) {
    project_io::Task task;
    task.uid = static_cast<std::int64_t>(project.tasks.size()) + 1;
    task.name = name;
    task.duration.seconds = 8 * 3600;
    project.tasks.push_back(task);
  }
  return project;
}

ReadModels read_models(const std::vector<std::pair<std::string, std::string>>& files,
                       const std::string& unit, char up) {
  const mesh_io::testing::TemporaryFolder folder;
  std::vector<building_io::ModelFile> models;
  for (const auto& [name, text] : files) models.push_back({folder.write(name, text), name, text});
  building_io::ModelTerms terms;
  terms.folder = folder.path().string();
  terms.unit = unit;
  terms.up = up;
  interpreter::SourceMap sources;
  interpreter::Diagnostics diagnostics;
  ReadModels result;
  result.elements =
      building_io::read_elements(models, terms, mesh_io::testing::reader(), diagnostics);
  result.said = said(diagnostics, sources);
  return result;
}

}  // namespace rubicon::test
