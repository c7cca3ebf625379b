#pragma once

#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "src/exchange/encoding/sha256.hpp"

namespace rubicon::mesh_io {

using encoding::Digest;

/// Where the user's cache of meshes belongs: $XDG_CACHE_HOME/rubicon/meshes, else
/// ~/.cache/rubicon/meshes; empty when neither is known or RUBICON_CACHE is "off".
std::string default_cache_folder();

/// Bytes by digest in a folder of the user's. It may be read-only, missing, full, damaged, and in
/// use by several programs: then there is simply nothing in it, or nothing is kept.
///
/// An entry is written to a temporary file and renamed; its own SHA-256 is checked when it is read,
/// so one that is cut short or changed counts as missing and is written anew. No fsync: what a
/// power cut does to an entry, the check finds.
///
/// Rule of size: before an entry would bring the folder above kMostBytes, those not used for
/// longest are removed until it holds seven eighths of that. Larger than kLargestEntry is not kept.
class DiskCache {
 public:
  static constexpr std::uint64_t kMostBytes = 512'000'000;
  static constexpr std::uint64_t kLargestEntry = kMostBytes / 4;

  /// `folder` is made when the first entry is kept. Empty: nothing is found or kept.
  explicit DiskCache(std::string folder, std::uint64_t most_bytes = kMostBytes);

  bool is_on() const { return !folder_.empty(); }

  std::optional<std::string> find(const Digest& key);
  void put(const Digest& key, std::string_view payload);

 private:
  std::string path_of(const Digest& key) const;
  bool make_room(std::uint64_t bytes);
  std::uint64_t trim(std::uint64_t down_to);

  std::string folder_;
  std::uint64_t most_bytes_;
  std::mutex mutex_;                   // guards what follows
  std::optional<std::uint64_t> used_;  // bytes in the folder when last counted, and ours since
};

}  // namespace rubicon::mesh_io
