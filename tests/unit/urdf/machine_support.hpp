#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>

#include "interpreter/check/check.hpp"
#include "src/exchange/urdf/import_machine.hpp"

namespace rubicon::urdf::testing {

/// Files of a machine that exist only in a test: `package://NAME/FILE` and `FILE` are both FILE.
class MemoryPackage : public PackageFiles {
 public:
  std::map<std::string, std::string> texts;

  std::variant<FoundFile, PackageFailure> find(const std::string& reference,
                                               const std::string& from) override;
  std::variant<std::string, PackageFailure> read_text(const std::string& path) override;
};

/// An import with all that was said.
struct Imported {
  interpreter::SourceMap sources;
  interpreter::Diagnostics diagnostics;
  std::optional<MachineImport> machine;

  /// "CODE line: message" of each, in order.
  std::string said() const;
};

struct Asked {
  std::string text;
  std::string path = "machine.urdf";
  std::string tool = {};
  std::map<std::string, std::string> arguments = {};
  std::map<std::string, std::string> files = {};
};

Imported import(const Asked& asked);

/// What `import` makes of the content of a <robot>; fails the test on an error.
std::string robot_of(const std::string& content);

/// The first error of a file, as in `said`; "" if there is none.
std::string error_of(const Asked& asked);
inline std::string error_of(const std::string& text) { return error_of(Asked{text}); }

/// The checked robot of a text without meshes; fails the test where it has errors or is not
/// canonical.
std::shared_ptr<const interpreter::CheckedRobot> checked(const std::string& robot);

}  // namespace rubicon::urdf::testing
