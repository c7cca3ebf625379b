#pragma once

#include <cstdio>
#include <optional>
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

 private:
  mesh_io::MeshReader meshes_ = mesh_io::MeshReader::beside_command();
};

/// Everything on standard input, up to the size cap of a text.
std::variant<std::string, interpreter::FileFailure> read_standard_input();

/// A file that appears whole or not at all: written beside its target, synced, renamed over it on
/// `commit`. A kill at any moment leaves the old file or the complete new one. Devices, pipes and
/// standard output ("-") are written on `commit`.
class AtomicFile {
 public:
  /// Opens for writing; a message if that fails.
  static std::variant<AtomicFile, std::string> open(const std::string& path);
  AtomicFile(AtomicFile&& other) noexcept;
  AtomicFile& operator=(AtomicFile&&) = delete;
  ~AtomicFile();

  void write(std::string_view bytes);
  /// Forgets all that was written so far.
  void restart();
  /// Finishes the file; a message if any byte did not reach the disk (then the target is as it
  /// was).
  std::optional<std::string> commit();

 private:
  AtomicFile() = default;
  void copy_to_target();
  std::string path_;
  std::string temporary_;        ///< empty where the target is no regular file
  std::FILE* file_ = nullptr;    ///< what is written to: beside the target, or without a name
  std::FILE* target_ = nullptr;  ///< a device, a pipe or standard output
  int error_ = 0;
};

/// Writes a whole file through AtomicFile; a message on failure.
std::optional<std::string> write_file(const std::string& path, std::string_view bytes);

/// Creates a folder and its parents; a message on failure.
std::optional<std::string> make_folder(const std::string& path);

bool is_folder(const std::string& path);

/// Whether colour may be used on this stream: a terminal, and NO_COLOR not set.
bool wants_colour(std::FILE* stream);

}  // namespace rubicon::files
