#include "src/results/film/gzip.hpp"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>

namespace rubicon::film {

namespace {

/// zlib: 15 bits of window, and 16 for the frame of gzip.
constexpr int kGzipWindow = 15 + 16;
/// A film of a million steps is half as long as at 1, and no shorter at 9, which takes twice as
/// long.
constexpr int kLevel = 6;
constexpr int kMemory = 8;
/// RFC 1952: the system is not known.
constexpr int kAnySystem = 255;

}  // namespace

std::string gzip(std::string_view bytes) {
  z_stream stream{};
  if (deflateInit2(&stream, kLevel, Z_DEFLATED, kGzipWindow, kMemory, Z_DEFAULT_STRATEGY) != Z_OK) {
    throw std::runtime_error("zlib cannot compress here");
  }
  gz_header header{};
  header.os = kAnySystem;
  deflateSetHeader(&stream, &header);

  std::string result;
  std::array<char, 1 << 16> piece{};
  int state = Z_OK;
  while (state != Z_STREAM_END) {
    if (stream.avail_in == 0) {
      const std::size_t count =
          std::min<std::size_t>(bytes.size(), std::numeric_limits<uInt>::max());
      // zlib's interface has no const; it only reads.
      stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
      stream.avail_in = static_cast<uInt>(count);
      bytes.remove_prefix(count);
    }
    stream.next_out = reinterpret_cast<Bytef*>(piece.data());
    stream.avail_out = static_cast<uInt>(piece.size());
    state = deflate(&stream, bytes.empty() ? Z_FINISH : Z_NO_FLUSH);
    result.append(piece.data(), piece.size() - stream.avail_out);
  }
  deflateEnd(&stream);
  return result;
}

}  // namespace rubicon::film
