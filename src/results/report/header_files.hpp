#pragma once

#include <map>
#include <string>

#include "interpreter/expand/expand.hpp"
#include "interpreter/syntax/file_provider.hpp"

namespace rubicon::report {

/// The texts of a plan, its robots and their behaviours, as the header of a trace carries them: so
/// that a plan can be read again as it was when it was run. Meshes it does not have as files; in
/// their place it gives a stand-in, which is good for all that looks at no shapes.
class HeaderFiles : public interpreter::FileProvider {
 public:
  /// Throws std::invalid_argument, with a message for the user, for what is no header of a trace.
  explicit HeaderFiles(const std::string& header);

  const std::string& plan_path() const { return plan_path_; }
  /// What parameters of the plan were given from outside.
  const interpreter::ParameterTexts& set() const { return set_; }

  std::variant<std::string, interpreter::FileFailure> read_text(const std::string& path) override;
  std::variant<std::shared_ptr<const geometry::TriangleMesh>, interpreter::FileFailure> read_mesh(
      const interpreter::MeshRequest& request) override;

 private:
  std::string plan_path_;
  interpreter::ParameterTexts set_;
  std::map<std::string, std::string> texts_;  ///< by path
};

}  // namespace rubicon::report
