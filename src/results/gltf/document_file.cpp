#include "src/results/gltf/document_file.hpp"

#include <string_view>

#include "src/exchange/encoding/base64.hpp"

namespace rubicon::gltf {

namespace {

void append_number(std::string& bytes, std::size_t number) {
  for (int shift = 0; shift < 32; shift += 8) {
    bytes += static_cast<char>((number >> shift) & 0xFF);
  }
}

void append_chunk(std::string& bytes, std::string_view type, std::string chunk, char padding) {
  while (chunk.size() % 4 != 0) chunk += padding;
  append_number(bytes, chunk.size());
  bytes += type;
  bytes += chunk;
}

std::string text_of(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

std::string glb_bytes(const Document& document) {
  std::string chunks;
  append_chunk(chunks, "JSON", text_of(document.json), ' ');
  if (!document.binary.empty()) {
    append_chunk(chunks, std::string_view("BIN\0", 4), document.binary, '\0');
  }
  constexpr std::size_t kHeader = 12;
  std::string bytes = "glTF";
  append_number(bytes, 2);
  append_number(bytes, kHeader + chunks.size());
  return bytes + chunks;
}

std::string gltf_text(const Document& document) {
  if (document.binary.empty()) return text_of(document.json) + "\n";
  Json json = document.json;
  json["buffers"][0]["uri"] =
      "data:application/octet-stream;base64," + encoding::base64(document.binary);
  return text_of(json) + "\n";
}

}  // namespace rubicon::gltf
