#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

namespace rubicon::mesh_io {

/// Values by name, up to a number of bytes; what has not been asked for longest goes first. For
/// several threads at once.
template <class Value>
class BoundedCache {
 public:
  explicit BoundedCache(std::size_t most_bytes) : most_bytes_(most_bytes) {}

  std::optional<Value> find(const std::string& key) {
    const std::scoped_lock lock(mutex_);
    const auto found = entries_.find(key);
    if (found == entries_.end()) return std::nullopt;
    found->second.last_use = ++clock_;
    return found->second.value;
  }

  void drop(const std::string& key) {
    const std::scoped_lock lock(mutex_);
    const auto found = entries_.find(key);
    if (found == entries_.end()) return;
    bytes_ -= found->second.bytes;
    entries_.erase(found);
  }

  /// Keeps `value` under `key` unless it is too large by itself or something is there already.
  void put(const std::string& key, Value value, std::size_t bytes) {
    const std::scoped_lock lock(mutex_);
    if (bytes > most_bytes_ || entries_.count(key) != 0) return;
    while (bytes_ + bytes > most_bytes_) drop_oldest();
    entries_.emplace(key, Entry{std::move(value), bytes, ++clock_});
    bytes_ += bytes;
  }

 private:
  struct Entry {
    Value value;
    std::size_t bytes = 0;
    std::uint64_t last_use = 0;
  };

  void drop_oldest() {
    auto oldest = entries_.begin();
    for (auto each = entries_.begin(); each != entries_.end(); ++each) {
      if (each->second.last_use < oldest->second.last_use) oldest = each;
    }
    bytes_ -= oldest->second.bytes;
    entries_.erase(oldest);
  }

  std::mutex mutex_;
  std::map<std::string, Entry> entries_;
  std::size_t most_bytes_;
  std::size_t bytes_ = 0;
  std::uint64_t clock_ = 0;
};

}  // namespace rubicon::mesh_io
