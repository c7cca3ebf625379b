#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "src/exchange/urdf/findings.hpp"
#include "src/exchange/urdf/machine.hpp"
#include "src/exchange/urdf/package_files.hpp"

namespace rubicon::urdf {

/// A mesh file to put beside the robot file.
struct MeshCopy {
  std::string source;           ///< resolved path
  std::string folder;           ///< that it lies in: of the machine or of a package
  std::string target;           ///< relative to the robot file
  std::optional<Triple> scale;  ///< factors to be put into the mesh; nothing: copied as it is
  interpreter::Span span;
};

/// Gives each mesh of a machine its place beside the robot file. Equal files are copied once.
class MeshShapes {
 public:
  /// `machine` is the path of the file, `folder` the name of the one for meshes.
  MeshShapes(PackageFiles& files, std::string machine, std::string folder, Findings& findings)
      : files_(files),
        machine_(std::move(machine)),
        folder_(std::move(folder)),
        findings_(findings) {}

  /// `mesh("FOLDER/arm.stl", m)`; empty where the format is not known, which is listed. Throws a
  /// Fault where there is no such file.
  std::string shape(const Geometry& geometry);

  std::vector<MeshCopy> take() { return std::move(copies_); }

 private:
  const MeshCopy& copy_of(const FoundFile& file, const std::string& extension,
                          const std::optional<Triple>& scale, interpreter::Span span);
  bool says_z_up(const FoundFile& file, const std::string& extension);

  PackageFiles& files_;
  std::string machine_;
  std::string folder_;
  Findings& findings_;
  std::vector<MeshCopy> copies_;
  std::map<std::pair<std::string, std::optional<Triple>>, std::size_t> known_;
  std::map<std::string, bool> z_up_;
  std::set<std::string> targets_;
};

}  // namespace rubicon::urdf
