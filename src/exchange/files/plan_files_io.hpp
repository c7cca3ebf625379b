#pragma once

#include <set>
#include <string>

#include "interpreter/syntax/file_provider.hpp"
#include "interpreter/syntax/source.hpp"
#include "src/exchange/files/disk_io.hpp"

namespace rubicon::files {

/// The disk as the files of one plan see it: every path is relative to the folder of the plan. So
/// what a run writes is the same, however the path of its plan was typed, and names no folder of a
/// user.
class PlanFiles : public interpreter::FileProvider {
 public:
  /// `typed` is the path of the plan as the user gave it.
  explicit PlanFiles(std::string typed);

  /// The plan: its file's name; where the path is a link, that of the file it leads to.
  const std::string& plan() const { return name_; }
  /// A path as the user would type it.
  std::string typed(const std::string& path) const;
  /// The same files by these paths: for messages.
  interpreter::SourceMap typed(const interpreter::SourceMap& sources) const;
  /// The files that were asked for so far, by these paths.
  const std::set<std::string>& read() const { return disk_.read(); }

  std::variant<std::string, interpreter::FileFailure> read_text(const std::string& path) override;
  std::variant<std::shared_ptr<const geometry::TriangleMesh>, interpreter::FileFailure> read_mesh(
      const interpreter::MeshRequest& request) override;

 private:
  std::string typed_;
  std::string name_;
  DiskFiles disk_;
};

}  // namespace rubicon::files
