#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "src/exchange/project_io/decode_text.hpp"
#include "src/exchange/project_io/plan_text.hpp"
#include "src/exchange/project_io/project_of.hpp"
#include "src/exchange/project_io/read_project.hpp"
#include "src/exchange/project_io/write_mspdi.hpp"
#include "tests/support/memory_files.hpp"

namespace {

using rubicon::interpreter::Diagnostics;
using rubicon::interpreter::SourceMap;
using rubicon::project_io::Project;

[[noreturn]] void fail(const char* what, const std::string& text) {
  std::fprintf(stderr, "%s:\n%s\n", what, text.c_str());
  std::abort();
}

std::optional<Project> read(const std::string& bytes) {
  SourceMap sources;
  Diagnostics diagnostics;
  const auto file = sources.add("schedule", rubicon::project_io::decode_text(bytes).text);
  return rubicon::project_io::read_project(sources, file, diagnostics);
}

/// The project that the plan of a project stands for.
Project by_plan(const Project& project) {
  Diagnostics doubts;
  const std::string text = rubicon::project_io::plan_text(project, "schedule.xml", doubts);
  SourceMap sources;
  Diagnostics diagnostics;
  rubicon::test::MemoryFiles files({{"s.plan", text}});
  const auto plan = load_plan("s.plan", sources, files, diagnostics);
  if (!plan) fail("the plan of this schedule has mistakes", text);
  return rubicon::project_io::project_of(*plan, sources, diagnostics);
}

}  // namespace

/// Any bytes as a schedule of another program: no crash, no hang; and what could be read comes back
/// whole as Microsoft Project XML and as a plan.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto project = read(std::string(reinterpret_cast<const char*>(data), size));
  if (!project) return 0;
  const std::string xml = rubicon::project_io::write_mspdi(*project);
  if (read(xml) != project) fail("read and written again it is another schedule", xml);
  if (by_plan(*project) != *project) fail("by its plan it is another schedule", xml);
  return 0;
}
