#pragma once

#include <cstdio>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "src/exchange/files/temporaries_io.hpp"

namespace rubicon::files {

/// A file that appears whole or not at all: written beside its target, without a name where the
/// file system can, synced, and put in its place on `commit`. A stop at any moment leaves the old
/// file or the complete new one. Devices, pipes and standard output ("-") are written on `commit`.
/// A link is followed, and stays one. A file that is replaced hands on its mode, its owner and its
/// access list, as far as we may set them; a second name of it (a hard link) keeps the old one.
class AtomicFile {
 public:
  /// Opens for writing; a message if that fails.
  static std::variant<AtomicFile, std::string> open(const std::string& path);
  /// The same for a file that is changed where it is: one of several names is written over in its
  /// place, so that all of them show the change. Only this is no single step.
  static std::variant<AtomicFile, std::string> open_for_change(const std::string& path);
  /// A new file in a folder that is itself temporary: at once under its name. Messages call it
  /// `shown`.
  static std::variant<AtomicFile, std::string> create(const std::string& path, std::string shown);
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
  enum class Place { unnamed, named, target, stream };

  AtomicFile() = default;
  void open_unnamed();
  void open_named();
  int copy_to_target();
  /// Gives the new file the rights of `old`.
  void take_rights(const std::string& old);
  /// Puts the finished file in its place; an error number, 0: none.
  int put_in_place();
  int sync();
  std::string path_;
  std::string shown_;
  Place place_ = Place::target;  ///< where its bytes are until `commit`
  std::string temporary_;        ///< the name of a named one
  Temporaries guard_;            ///< of that name
  std::FILE* file_ = nullptr;    ///< what is written to
  std::FILE* target_ = nullptr;  ///< a device, a pipe or standard output
  int error_ = 0;
};

/// Writes a whole file through AtomicFile; a message on failure.
std::optional<std::string> write_file(const std::string& path, std::string_view bytes);
/// The same through AtomicFile::open_for_change.
std::optional<std::string> change_file(const std::string& path, std::string_view bytes);

}  // namespace rubicon::files
