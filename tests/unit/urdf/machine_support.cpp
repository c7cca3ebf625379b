#include "tests/unit/urdf/machine_support.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "interpreter/parse/parse.hpp"
#include "tests/support/memory_files.hpp"

namespace rubicon::urdf::testing {

std::variant<FoundFile, PackageFailure> MemoryPackage::find(const std::string& reference,
                                                            const std::string& /*from*/) {
  std::string name = reference;
  if (name.starts_with("package://")) name.erase(0, name.find('/', 10) + 1);
  if (!texts.contains(name)) return PackageFailure{"there is no file '" + name + "'", ""};
  return FoundFile{name, "", ""};
}

std::variant<std::string, PackageFailure> MemoryPackage::read_text(const std::string& path) {
  return texts.at(path);
}

std::string Imported::said() const {
  std::string result;
  for (const interpreter::Diagnostic& each : diagnostics.all()) {
    result += fmt::format("{} {}: {}\n", each.code, sources.position(each.span).line, each.message);
  }
  return result;
}

Imported import(const Asked& asked) {
  Imported result;
  MemoryPackage files;
  files.texts = asked.files;
  MachineTerms terms;
  terms.path = asked.path;
  terms.arguments = asked.arguments;
  terms.tool = asked.tool;
  terms.meshes = "machine_meshes";
  const interpreter::FileId file = result.sources.add(asked.path, asked.text);
  result.machine = import_machine(terms, result.sources, file, files, result.diagnostics);
  return result;
}

std::string robot_of(const std::string& content) {
  const Imported imported = import({"<robot name=\"r\">" + content + "</robot>"});
  EXPECT_TRUE(imported.machine) << imported.said();
  return imported.machine ? imported.machine->robot : "";
}

std::string error_of(const Asked& asked) {
  const Imported imported = import(asked);
  for (const interpreter::Diagnostic& each : imported.diagnostics.all()) {
    if (each.severity != interpreter::Severity::error) continue;
    EXPECT_FALSE(imported.machine);
    return fmt::format("{} {}: {}", each.code, imported.sources.position(each.span).line,
                       each.message);
  }
  return "";
}

std::shared_ptr<const interpreter::CheckedRobot> checked(const std::string& robot) {
  test::MemoryFiles files({{"machine.robot", robot}});
  interpreter::SourceMap sources;
  interpreter::Diagnostics diagnostics;
  auto result = interpreter::load_robot("machine.robot", sources, files, nullptr, diagnostics);
  for (const interpreter::Diagnostic& each : diagnostics.all()) {
    EXPECT_NE(each.severity, interpreter::Severity::error) << each.message << "\n" << robot;
  }
  EXPECT_EQ(interpreter::format_text(robot, interpreter::TextKind::robot), robot);
  return result;
}

}  // namespace rubicon::urdf::testing
