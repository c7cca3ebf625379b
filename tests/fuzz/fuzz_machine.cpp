#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "interpreter/parse/parse.hpp"
#include "src/exchange/project_io/decode_text.hpp"
#include "src/exchange/urdf/import_machine.hpp"

namespace {

using namespace rubicon;

/// Every file is there, and is this one.
class SameFile : public urdf::PackageFiles {
 public:
  explicit SameFile(const std::string& text) : text_(text) {}
  std::variant<urdf::FoundFile, urdf::PackageFailure> find(const std::string& reference,
                                                           const std::string& /*from*/) override {
    return urdf::FoundFile{reference, "", ""};
  }
  std::variant<std::string, urdf::PackageFailure> read_text(const std::string& /*path*/) override {
    return text_;
  }

 private:
  const std::string& text_;
};

[[noreturn]] void fail(const char* what, const std::string& robot) {
  std::fprintf(stderr, "%s:\n%s\n", what, robot.c_str());
  std::abort();
}

}  // namespace

/// Any bytes as a robot description: no crash, no hang; a robot file or an error; and the robot
/// file is one, in its canonical form.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text =
      project_io::decode_text({reinterpret_cast<const char*>(data), size}).text;
  SameFile files(text);
  interpreter::SourceMap sources;
  interpreter::Diagnostics diagnostics;
  urdf::MachineTerms terms;
  terms.path = "machine.xacro";
  terms.meshes = "meshes";
  const auto file = sources.add(terms.path, text);
  const auto machine = urdf::import_machine(terms, sources, file, files, diagnostics);
  if (machine.has_value() == diagnostics.has_errors()) fail("neither or both", text);
  if (!machine) return 0;
  interpreter::Diagnostics mistakes;
  interpreter::parse_robot(sources, sources.add("machine.robot", machine->robot), mistakes);
  if (mistakes.has_errors()) fail("the robot file has mistakes", machine->robot);
  if (interpreter::format_text(machine->robot, interpreter::TextKind::robot) != machine->robot) {
    fail("the robot file is not canonical", machine->robot);
  }
  return 0;
}
