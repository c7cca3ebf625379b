#pragma once

#include <assimp/IOStream.hpp>
#include <assimp/IOSystem.hpp>
#include <string>
#include <vector>

#include "src/exchange/mesh_io/guarded_file_io.hpp"

namespace rubicon::mesh_io {

/// What assimp may open: the mesh itself, and, where its format may lie in several files, regular
/// files in the folder. Materials, textures and whatever else a file names do not exist for it.
/// Only the helper program includes this header.
class GuardedAssimpFiles : public Assimp::IOSystem {
 public:
  /// `mesh` is open; `name` is what assimp calls it. With `others`, files inside `folder` may be
  /// opened too; `asked_for` outlives this object and gets the name of each that was asked for.
  GuardedAssimpFiles(GuardedFile mesh, std::string name, std::string folder, bool others,
                     std::vector<std::string>& asked_for);

  bool Exists(const char* file) const override;
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char* file, const char* mode) override;
  void Close(Assimp::IOStream* stream) override;

 private:
  GuardedFile mesh_;
  std::string name_;
  std::string folder_;
  bool others_;
  std::vector<std::string>& asked_for_;
};

}  // namespace rubicon::mesh_io
