#include "interpreter/syntax/source.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace rubicon::interpreter {

namespace {

/// Bytes between two entries of SourceFile::code_points. Small enough that a column costs next to
/// nothing even in a file that is one line of megabytes, large enough that the table stays small.
constexpr std::size_t kCodePointBlock = 1024;

/// Bytes that start a code point: all but the continuation bytes 10xxxxxx. A byte that is not UTF-8
/// counts one, too.
std::uint32_t count_code_points(std::string_view text) {
  return static_cast<std::uint32_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xc0u) != 0x80u;
  }));
}

/// Code points in text[0, offset).
std::uint32_t code_points_before(const SourceFile& file, std::size_t offset) {
  const std::size_t block = offset / kCodePointBlock;
  const std::size_t begin = block * kCodePointBlock;
  return file.code_points[block] +
         count_code_points(std::string_view(file.text).substr(begin, offset - begin));
}

}  // namespace

FileId SourceMap::add(std::string path, std::string text) {
  assert(files_.size() < kNoFile);
  if (text.starts_with("\xef\xbb\xbf")) text.erase(0, 3);
  SourceFile& file = files_.emplace_back();
  file.path = std::move(path);
  file.text = std::move(text);
  file.line_starts.push_back(0);
  for (std::size_t at = file.text.find('\n'); at != std::string::npos;
       at = file.text.find('\n', at + 1)) {
    file.line_starts.push_back(static_cast<std::uint32_t>(at + 1));
  }
  file.code_points.reserve(file.text.size() / kCodePointBlock + 1);
  std::uint32_t count = 0;
  for (std::size_t at = 0; at <= file.text.size(); at += kCodePointBlock) {
    file.code_points.push_back(count);
    count += count_code_points(std::string_view(file.text).substr(at, kCodePointBlock));
  }
  return static_cast<FileId>(files_.size() - 1);
}

Position SourceMap::position(FileId id, std::uint32_t offset) const {
  if (id >= files_.size()) return {};
  const SourceFile& source = files_[id];
  const std::size_t at = std::min<std::size_t>(offset, source.text.size());
  const auto next = std::upper_bound(source.line_starts.begin(), source.line_starts.end(), at);
  const std::uint32_t begin = *(next - 1);
  return {static_cast<int>(next - source.line_starts.begin()),
          static_cast<int>(code_points_before(source, at) - code_points_before(source, begin)) + 1};
}

std::string_view SourceMap::line(FileId id, int number) const {
  if (id >= files_.size()) return {};
  const SourceFile& source = files_[id];
  if (number < 1 || static_cast<std::size_t>(number) > source.line_starts.size()) return {};
  const auto index = static_cast<std::size_t>(number - 1);
  const std::size_t begin = source.line_starts[index];
  std::size_t end = index + 1 < source.line_starts.size() ? source.line_starts[index + 1] - 1u
                                                          : source.text.size();
  if (end > begin && source.text[end - 1] == '\r') --end;
  return std::string_view(source.text).substr(begin, end - begin);
}

std::string_view SourceMap::text(const Span& span) const {
  if (span.file >= files_.size()) return {};
  const std::string& text = files_[span.file].text;
  const std::size_t begin = std::min<std::size_t>(span.begin, text.size());
  const std::size_t end = std::clamp<std::size_t>(span.end, begin, text.size());
  return std::string_view(text).substr(begin, end - begin);
}

std::uint32_t SourceMap::add_copy(std::uint32_t outer, std::string variable, std::int64_t value) {
  copies_.push_back({outer, std::move(variable), value});
  return static_cast<std::uint32_t>(copies_.size());
}

std::string SourceMap::copy_text(const Span& span) const {
  if (span.copy == 0) return {};
  std::string text;
  for (std::uint32_t at = span.copy; at != 0; at = copies_[at - 1].outer) {
    const Copy& copy = copies_[at - 1];
    text.insert(0, ", " + copy.variable + " = " + std::to_string(copy.value));
  }
  return "line " + std::to_string(position(span).line) + text;
}

}  // namespace rubicon::interpreter
