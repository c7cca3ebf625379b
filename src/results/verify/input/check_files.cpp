#include "src/results/verify/input/check_files.hpp"

#include <fmt/format.h>

#include "src/exchange/encoding/sha256.hpp"

namespace rubicon::verify {

void check_files(const Trace& trace, Faults& faults) {
  for (const SceneFile& file : trace.scene.files) {
    if (encoding::sha256_hex(file.text) == file.sha256) continue;
    faults.push_back({FaultKind::order, ResultFile::trace, 1, "", -1,
                      fmt::format("the text of '{}' is not the one of its checksum", file.path)});
  }
}

}  // namespace rubicon::verify
