#include "src/exchange/encoding/gzip.hpp"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>
#include <utility>

namespace rubicon::encoding {

namespace {

/// zlib: 15 bits of window, and 16 for the frame of gzip.
constexpr int kGzipWindow = 15 + 16;
/// A film of a million steps is half as long as at 1, and no shorter at 9, which takes twice as
/// long.
constexpr int kLevel = 6;
constexpr int kMemory = 8;
/// RFC 1952: the system is not known.
constexpr int kAnySystem = 255;

/// A trace shrinks to a tenth or, where machines go round and round, a fiftieth; deflate can do
/// 1,032. What grows by more than this, and is longer than the floor, is refused.
constexpr std::uint64_t kMostGrowth = 400;
constexpr std::uint64_t kAlwaysFine = std::uint64_t{64} << 20;

using Piece = std::array<char, 1 << 16>;

/// Hands the next part of `bytes` to zlib, whose counts are 32 bits wide and whose interface has no
/// const.
void next_input(z_stream& stream, std::string_view& bytes) {
  const std::size_t count = std::min<std::size_t>(bytes.size(), std::numeric_limits<uInt>::max());
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(count);
  bytes.remove_prefix(count);
}

void next_output(z_stream& stream, Piece& piece) {
  stream.next_out = reinterpret_cast<Bytef*>(piece.data());
  stream.avail_out = static_cast<uInt>(piece.size());
}

std::string_view output(const z_stream& stream, const Piece& piece) {
  return {piece.data(), piece.size() - stream.avail_out};
}

}  // namespace

struct GzipWriter::Stream {
  Stream() {
    if (deflateInit2(&zlib, kLevel, Z_DEFLATED, kGzipWindow, kMemory, Z_DEFAULT_STRATEGY) != Z_OK) {
      throw std::runtime_error("zlib cannot compress here");
    }
    header.os = kAnySystem;
    deflateSetHeader(&zlib, &header);
  }
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;
  ~Stream() { deflateEnd(&zlib); }

  z_stream zlib{};
  gz_header header{};
  Piece piece{};
};

GzipWriter::GzipWriter(TakeBytes take)
    : take_(std::move(take)), stream_(std::make_unique<Stream>()) {}
GzipWriter::GzipWriter(GzipWriter&&) noexcept = default;
GzipWriter& GzipWriter::operator=(GzipWriter&&) noexcept = default;
GzipWriter::~GzipWriter() = default;

void GzipWriter::deflate(std::string_view bytes, int flush) {
  z_stream& zlib = stream_->zlib;
  do {
    next_input(zlib, bytes);
    const int mode = bytes.empty() ? flush : Z_NO_FLUSH;
    do {
      next_output(zlib, stream_->piece);
      ::deflate(&zlib, mode);
      const std::string_view packed = output(zlib, stream_->piece);
      if (!packed.empty()) take_(packed);
    } while (zlib.avail_out == 0);
  } while (!bytes.empty());
}

void GzipWriter::write(std::string_view bytes) { deflate(bytes, Z_NO_FLUSH); }
void GzipWriter::finish() { deflate({}, Z_FINISH); }

std::string gzip(std::string_view bytes) {
  std::string result;
  GzipWriter writer([&](std::string_view packed) { result += packed; });
  writer.write(bytes);
  writer.finish();
  return result;
}

bool is_gzip(std::string_view bytes) { return bytes.starts_with("\x1f\x8b"); }

struct GzipReader::Stream {
  Stream() {
    if (inflateInit2(&zlib, kGzipWindow) != Z_OK) {
      throw std::runtime_error("zlib cannot unpack here");
    }
  }
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;
  ~Stream() { inflateEnd(&zlib); }

  z_stream zlib{};
  Piece piece{};
  std::uint64_t in = 0;   ///< bytes so far
  std::uint64_t out = 0;  ///< unpacked
  bool begun = false;     ///< a part has begun and is not over
};

GzipReader::GzipReader(TakeBytes take)
    : take_(std::move(take)), stream_(std::make_unique<Stream>()) {}
GzipReader::GzipReader(GzipReader&&) noexcept = default;
GzipReader& GzipReader::operator=(GzipReader&&) noexcept = default;
GzipReader::~GzipReader() = default;

void GzipReader::read(std::string_view packed) {
  z_stream& zlib = stream_->zlib;
  stream_->in += packed.size();
  if (packed.empty()) return;
  next_input(zlib, packed);
  while (zlib.avail_in > 0 || zlib.avail_out == 0) {
    stream_->begun = true;
    next_output(zlib, stream_->piece);
    const int state = inflate(&zlib, Z_NO_FLUSH);
    const std::string_view unpacked = output(zlib, stream_->piece);
    stream_->out += unpacked.size();
    if (stream_->out > kAlwaysFine && stream_->out / kMostGrowth > stream_->in) {
      throw std::invalid_argument("it unpacks to more than 400 times its size: this is no trace");
    }
    if (!unpacked.empty()) take_(unpacked);
    if (state == Z_STREAM_END) {
      // Several packed files one after the other are the pack of all.
      stream_->begun = false;
      if (inflateReset(&zlib) != Z_OK) throw std::runtime_error("zlib cannot unpack here");
      zlib.avail_out = 1;  // nothing is held back
    } else if (state != Z_OK && state != Z_BUF_ERROR) {
      throw std::invalid_argument("the gzip data is damaged");
    }
    if (zlib.avail_in == 0 && !packed.empty()) next_input(zlib, packed);
  }
}

void GzipReader::finish() {
  if (stream_->begun) throw std::invalid_argument("the gzip data ends too soon");
}

}  // namespace rubicon::encoding
