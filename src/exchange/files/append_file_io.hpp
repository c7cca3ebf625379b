#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace rubicon::files {

/// A file to which whole lines are appended, one write each, so that a program that is killed loses
/// none that it has written; a line that was cut off is left without its end. One program at a time
/// may have it.
class AppendFile {
 public:
  /// Opens it, and its folders are made; `keep` leaves the lines that are there, else it is
  /// emptied. A message if that fails or somebody else has it.
  static std::variant<AppendFile, std::string> open(const std::string& path, bool keep);
  AppendFile(AppendFile&& other) noexcept;
  AppendFile& operator=(AppendFile&&) = delete;
  ~AppendFile();

  /// The lines that were there, without those that were cut off.
  const std::vector<std::string>& lines() const { return lines_; }
  void forget_lines() { lines_ = {}; }
  /// A message if it could not be written as a whole.
  std::optional<std::string> append(std::string_view line);
  /// Removes the file.
  void remove();

 private:
  AppendFile() = default;

  std::string path_;
  int file_ = -1;
  std::vector<std::string> lines_;
};

}  // namespace rubicon::files
