#pragma once

#include <cstdio>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <variant>

#include "interpreter/syntax/file_provider.hpp"
#include "src/exchange/mesh_io/mesh_io.hpp"

namespace rubicon::files {

/// The disk as the interpreter may see it: regular files up to a size cap, meshes through the
/// guarded reader.
class DiskFiles : public interpreter::FileProvider {
 public:
  std::variant<std::string, interpreter::FileFailure> read_text(const std::string& path) override;
  std::variant<std::shared_ptr<const geometry::TriangleMesh>, interpreter::FileFailure> read_mesh(
      const interpreter::MeshRequest& request) override;

  /// The reader itself, for whole models.
  const mesh_io::MeshReader& meshes() const { return meshes_; }
  /// The files that were asked for so far, texts and meshes: nothing may be written over them.
  const std::set<std::string>& read() const { return read_; }

 private:
  std::set<std::string> read_;
  mesh_io::MeshReader meshes_ = mesh_io::MeshReader::beside_command();
};

/// Everything on standard input, up to the size cap of a text.
std::variant<std::string, interpreter::FileFailure> read_standard_input();

/// Creates a folder and its parents; a message on failure.
std::optional<std::string> make_folder(const std::string& path);

bool is_folder(const std::string& path);

/// Whether colour may be used on this stream: a terminal, and NO_COLOR not set.
bool wants_colour(std::FILE* stream);

}  // namespace rubicon::files
