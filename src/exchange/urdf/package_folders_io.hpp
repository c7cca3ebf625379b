#pragma once

#include <map>
#include <string>

#include "src/exchange/urdf/package_files.hpp"

namespace rubicon::urdf {

/// The folder of a machine and its packages on disk. Links are followed and must end in there.
class PackageFolders : public PackageFiles {
 public:
  /// `machine` is the path of the file; `packages` the folder of each named package.
  PackageFolders(const std::string& machine, const std::map<std::string, std::string>& packages);

  /// A package that is not there as a folder; empty: all are.
  const std::string& missing_package() const { return missing_; }

  std::variant<FoundFile, PackageFailure> find(const std::string& reference,
                                               const std::string& from) override;
  std::variant<std::string, PackageFailure> read_text(const std::string& path) override;

 private:
  struct Folder {
    std::string path;
    bool guessed = false;
  };
  std::variant<FoundFile, PackageFailure> find_in_package(const std::string& reference,
                                                          const std::string& name,
                                                          const std::string& rest);
  std::string folder_above(const std::string& name, const std::string& rest) const;

  std::string folder_;  ///< of the machine, resolved
  std::map<std::string, Folder> packages_;
  std::string missing_;
};

}  // namespace rubicon::urdf
