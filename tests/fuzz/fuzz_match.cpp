#include <cstdint>

#include "src/exchange/building_io/match_file.hpp"
#include "src/exchange/project_io/decode_text.hpp"

/// Any bytes as a match file: no crash, no hang.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  rubicon::interpreter::SourceMap sources;
  rubicon::interpreter::Diagnostics diagnostics;
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  const auto file = sources.add("building.match", rubicon::project_io::decode_text(bytes).text);
  rubicon::building_io::read_match_file(sources, file, diagnostics);
  return 0;
}
