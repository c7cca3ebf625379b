#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "interpreter/syntax/diagnostic.hpp"
#include "src/exchange/urdf/mesh_shapes.hpp"
#include "src/exchange/urdf/package_files.hpp"

namespace rubicon::urdf {

/// What a user says beside the file.
struct MachineTerms {
  std::string path;                              ///< of the file, as the user wrote it
  std::map<std::string, std::string> arguments;  ///< of xacro
  std::string tool;                              ///< a link; empty: the last of the longest chain
  std::string meshes;                            ///< the folder for meshes beside the robot file
};

struct MachineImport {
  std::string robot;  ///< the text of the robot file
  std::vector<MeshCopy> meshes;
};

/// A robot file of the URDF or xacro file `file` of `sources`. Nothing after an error; what was
/// assumed, mended or left out are warnings and notes.
std::optional<MachineImport> import_machine(const MachineTerms& terms,
                                            interpreter::SourceMap& sources,
                                            interpreter::FileId file, PackageFiles& files,
                                            interpreter::Diagnostics& diagnostics);

}  // namespace rubicon::urdf
