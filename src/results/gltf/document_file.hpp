#pragma once

#include <string>

#include "src/results/gltf/document.hpp"

namespace rubicon::gltf {

/// The document as one binary file (.glb).
std::string glb_bytes(const Document& document);

/// The document as one text (.gltf), its buffer within it as base64.
std::string gltf_text(const Document& document);

}  // namespace rubicon::gltf
