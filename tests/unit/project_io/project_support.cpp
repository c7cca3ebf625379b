#include "tests/unit/project_io/project_support.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "src/exchange/project_io/decode_text.hpp"
#include "src/exchange/project_io/plan_text.hpp"
#include "src/exchange/project_io/project_of.hpp"
#include "src/exchange/project_io/read_project.hpp"
#include "tests/support/memory_files.hpp"

namespace rubicon::test {

namespace {

std::vector<std::string> texts(const interpreter::Diagnostics& diagnostics,
                               const interpreter::SourceMap& sources) {
  std::vector<std::string> result;
  for (const auto& each : diagnostics.sorted()) {
    interpreter::Position position;
    if (each.span.file < sources.size()) position = sources.position(each.span);
    result.push_back(
        fmt::format("{} {}:{} {}", each.code, position.line, position.column, each.message));
  }
  return result;
}

}  // namespace

bool Reading::says(const std::string& code, const std::string& words) const {
  return std::any_of(said.begin(), said.end(), [&](const std::string& text) {
    return text.starts_with(code + " ") && text.find(words) != std::string::npos;
  });
}

Reading read_schedule(const std::string& bytes) {
  interpreter::SourceMap sources;
  interpreter::Diagnostics diagnostics;
  const interpreter::FileId file = sources.add("schedule", project_io::decode_text(bytes).text);
  Reading reading;
  reading.project = project_io::read_project(sources, file, diagnostics);
  reading.said = texts(diagnostics, sources);
  reading.has_errors = diagnostics.has_errors();
  EXPECT_EQ(reading.project.has_value(), !reading.has_errors);
  return reading;
}

Planned plan_of(const project_io::Project& project) {
  Planned planned;
  interpreter::Diagnostics doubts;
  planned.text = project_io::plan_text(project, "schedule.xml", doubts);
  interpreter::SourceMap sources;
  planned.said = texts(doubts, sources);
  interpreter::Diagnostics diagnostics;
  MemoryFiles files({{"s.plan", planned.text}});
  load_plan("s.plan", sources, files, diagnostics);
  planned.mistakes = fmt::format("{}", fmt::join(texts(diagnostics, sources), "\n"));
  return planned;
}

Reading project_of_plan(const std::string& text) {
  interpreter::SourceMap sources;
  interpreter::Diagnostics diagnostics;
  MemoryFiles files({{"s.plan", text}});
  const auto plan = load_plan("s.plan", sources, files, diagnostics);
  Reading reading;
  if (plan) reading.project = project_io::project_of(*plan, sources, diagnostics);
  reading.said = texts(diagnostics, sources);
  reading.has_errors = diagnostics.has_errors();
  EXPECT_TRUE(plan) << fmt::format("{}", fmt::join(reading.said, "\n"));
  return reading;
}

std::string mspdi(const std::string& inside) {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
         "<Project xmlns=\"http://schemas.microsoft.com/project\">" +
         inside + "</Project>";
}

std::string mspdi_task(int uid, const std::string& name, const std::string& elements) {
  return fmt::format("<Task><UID>{}</UID><ID>{}</ID><Name>{}</Name>{}</Task>", uid, uid, name,
                     elements);
}

}  // namespace rubicon::test
