#include "src/exchange/mesh_io/helper_job.hpp"

#include <array>
#include <charconv>

namespace rubicon::mesh_io {

namespace {

// Words end with a zero byte, which no path holds. The first names the version: a helper of another
// one then refuses.
constexpr std::string_view kVersion = "rubicon-mesh job 1";
constexpr std::string_view kMeshWord = "mesh";
constexpr std::string_view kHullWord = "hull";
constexpr std::string_view kWritten = "written";
constexpr std::string_view kDeclared = "declared";

std::optional<std::uint64_t> number(std::string_view text) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value == 0) return std::nullopt;
  return value;
}

}  // namespace

std::string encode_job(const HelperJob& job) {
  std::string message;
  const auto put = [&](std::string_view word) {
    message += word;
    message += '\0';
  };
  put(kVersion);
  put(job.kind == HelperJob::Kind::kMesh ? kMeshWord : kHullWord);
  put(job.extension);
  put(job.ignore_declared_up ? kWritten : kDeclared);
  put(job.folder);
  put(job.path);
  put(std::to_string(job.seconds));
  put(std::to_string(job.bytes));
  return message;
}

std::optional<HelperJob> decode_job(std::string_view message) {
  std::array<std::string_view, 8> words;
  for (std::string_view& word : words) {
    const std::size_t end = message.find('\0');
    if (end == std::string_view::npos) return std::nullopt;
    word = message.substr(0, end);
    message.remove_prefix(end + 1);
  }
  const auto& [version, kind, extension, up, folder, path, seconds_word, bytes_word] = words;
  const std::optional<std::uint64_t> seconds = number(seconds_word);
  const std::optional<std::uint64_t> bytes = number(bytes_word);
  if (!message.empty() || version != kVersion || (kind != kMeshWord && kind != kHullWord) ||
      (up != kWritten && up != kDeclared) || !seconds || !bytes) {
    return std::nullopt;
  }
  HelperJob job;
  job.kind = kind == kMeshWord ? HelperJob::Kind::kMesh : HelperJob::Kind::kHull;
  job.extension = extension;
  job.ignore_declared_up = up == kWritten;
  job.folder = folder;
  job.path = path;
  job.seconds = *seconds;
  job.bytes = *bytes;
  return job;
}

}  // namespace rubicon::mesh_io
