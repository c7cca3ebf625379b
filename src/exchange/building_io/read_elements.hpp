#pragma once

#include <string>
#include <vector>

#include "interpreter/syntax/diagnostic.hpp"
#include "src/exchange/building_io/element.hpp"
#include "src/exchange/mesh_io/mesh_io.hpp"

namespace rubicon::building_io {

/// A model to read.
struct ModelFile {
  std::string path;       ///< where it is
  std::string reference;  ///< how the plan names it: relative to the plan's folder
  std::string text;       ///< of an IFC file
};

/// How models without unit (OBJ, STL, PLY) are to be understood, and where the plan will be.
struct ModelTerms {
  std::string folder;        ///< of the plan; the models must lie in it
  std::string unit;          ///< mm, cm, m; empty: as the file declares
  char up = 0;               ///< 'y', 'z', 0: as the file declares
  bool keep_meshes = false;  ///< each element with its mesh
};

/// Everything in the models that has a shape.
struct Elements {
  std::vector<Element> all;        ///< in the order of the models and, in each, of its file
  std::vector<std::string> notes;  ///< what a reader of the plan should know of the models
  Vec3 origin = Vec3::Zero();      ///< taken off all places: a round point near the building, if
                                   ///< that stands far out
};

/// Reads the models. What is there but has no shape that could be read is listed (I14); a model
/// that cannot be read is an error (I11), and the result is then of no use.
Elements read_elements(const std::vector<ModelFile>& models, const ModelTerms& terms,
                       const mesh_io::MeshReader& reader, interpreter::Diagnostics& diagnostics);

}  // namespace rubicon::building_io
