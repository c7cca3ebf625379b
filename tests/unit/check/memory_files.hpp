#pragma once

#include <map>
#include <string>
#include <vector>

#include "interpreter/syntax/file_provider.hpp"

namespace rubicon::test {

/// Files from memory. A mesh is there if `meshes` names it; it is a single triangle. One whose name
/// contains "bad" is refused.
class MemoryFiles : public interpreter::FileProvider {
 public:
  std::variant<std::string, interpreter::FileFailure> read_text(const std::string& path) override;
  std::variant<std::shared_ptr<const geometry::TriangleMesh>, interpreter::FileFailure> read_mesh(
      const interpreter::MeshRequest& request) override;

  std::map<std::string, std::string> texts;
  std::vector<std::string> meshes;
  std::vector<interpreter::MeshRequest> requests;  ///< meshes that were asked for, in order
  std::vector<std::string> reads;                  ///< texts that were asked for, in order
};

/// The robots, behaviours and meshes that the cases name: the files of tests/unit/check/site, as
/// "site/NAME".
MemoryFiles case_files();

}  // namespace rubicon::test
