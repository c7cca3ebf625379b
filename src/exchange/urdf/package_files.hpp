#pragma once

#include <string>
#include <variant>

namespace rubicon::urdf {

/// A file of a machine, found.
struct FoundFile {
  std::string path;    ///< resolved: no links, no ".."
  std::string folder;  ///< the folder of the machine or the package that it lies in, resolved
  std::string note;    ///< what was assumed to find it; empty: nothing
};

/// Why a file could not be had: what was expected, what was found; and what to do.
struct PackageFailure {
  std::string message;
  std::string hint;
};

/// The only way this module reaches files. Each lies in the folder of the machine or in one of its
/// packages.
class PackageFiles {
 public:
  virtual ~PackageFiles() = default;
  /// `package://NAME/...`, `file://...` or a path relative to the folder of `from`.
  virtual std::variant<FoundFile, PackageFailure> find(const std::string& reference,
                                                       const std::string& from) = 0;
  virtual std::variant<std::string, PackageFailure> read_text(const std::string& path) = 0;
};

}  // namespace rubicon::urdf
