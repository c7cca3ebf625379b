#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace rubicon::encoding {

/// Takes bytes piece by piece.
using TakeBytes = std::function<void(std::string_view)>;

/// Compresses (gzip, RFC 1952), without a time and the name of a system: the same bytes on the same
/// library, however they come in pieces.
class GzipWriter {
 public:
  /// What is packed goes to `take`.
  explicit GzipWriter(TakeBytes take);
  GzipWriter(GzipWriter&&) noexcept;
  GzipWriter& operator=(GzipWriter&&) noexcept;
  ~GzipWriter();

  void write(std::string_view bytes);
  /// Nothing may be written after it.
  void finish();

 private:
  struct Stream;
  void deflate(std::string_view bytes, int flush);

  TakeBytes take_;
  std::unique_ptr<Stream> stream_;
};

/// All of it at once.
std::string gzip(std::string_view bytes);

/// Whether bytes begin as gzip does; no JSON and no plan begins so.
bool is_gzip(std::string_view bytes);

/// Unpacks what GzipWriter or any other gzip packed, and refuses what unpacks to so much more than
/// it is that only harm can be meant. Throws std::invalid_argument, with a message for the user.
class GzipReader {
 public:
  /// What is unpacked goes to `take`.
  explicit GzipReader(TakeBytes take);
  GzipReader(GzipReader&&) noexcept;
  GzipReader& operator=(GzipReader&&) noexcept;
  ~GzipReader();

  void read(std::string_view packed);
  /// To be called when nothing follows.
  void finish();

 private:
  struct Stream;

  TakeBytes take_;
  std::unique_ptr<Stream> stream_;
};

}  // namespace rubicon::encoding
