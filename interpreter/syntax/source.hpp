#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace rubicon::interpreter {

/// A file that was read: its name as users wrote it and its text (UTF-8, a leading BOM removed).
struct SourceFile {
  std::string path;  ///< as shown in messages and traces
  std::string text;
  std::vector<std::uint32_t> line_starts;  ///< byte offset of every line
  std::vector<std::uint32_t> code_points;  ///< code points before every 1024th byte, for columns
};

using FileId = std::uint16_t;
inline constexpr FileId kNoFile = 0xffff;

/// A range of bytes of one source file, end exclusive.
struct Span {
  FileId file = kNoFile;
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  std::uint32_t copy = 0;  ///< of a `for` in a plan: SourceMap::copy_text; 0 is none
  bool operator==(const Span&) const = default;
};

/// Line and column from 1; columns count code points (a tab is one, a byte order mark none).
struct Position {
  int line = 1;
  int column = 1;
};

/// All source files of one run. Files are added, never removed; references stay valid.
class SourceMap {
 public:
  /// Adds a file; removes a leading byte order mark. At most 65534 files.
  FileId add(std::string path, std::string text);
  const SourceFile& file(FileId id) const { return files_[id]; }
  std::size_t size() const { return files_.size(); }
  Position position(FileId file, std::uint32_t offset) const;
  Position position(const Span& span) const { return position(span.file, span.begin); }
  /// The text of a line without its end; 1-based.
  std::string_view line(FileId file, int line) const;
  std::string_view text(const Span& span) const;

  /// One more pass of a `for`, inside the pass `outer` of another (0: of none): its Span::copy.
  std::uint32_t add_copy(std::uint32_t outer, std::string variable, std::int64_t value);
  /// "line 6, i = 3" of a span in a copy; empty of any other.
  std::string copy_text(const Span& span) const;

 private:
  struct Copy {
    std::uint32_t outer = 0;
    std::string variable;
    std::int64_t value = 0;
  };
  std::deque<SourceFile> files_;
  std::vector<Copy> copies_;
};

}  // namespace rubicon::interpreter
