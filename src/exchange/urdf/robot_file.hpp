#pragma once

#include <string>

#include "src/exchange/urdf/findings.hpp"
#include "src/exchange/urdf/machine.hpp"
#include "src/exchange/urdf/mesh_shapes.hpp"

namespace rubicon::urdf {

/// What is not in the machine's own file.
struct RobotTerms {
  std::string file;  ///< that it was made of, for the remark at the top
  std::string tool;  ///< link of the tool frame; empty: the last of the longest chain
};

/// The text of a robot file in its canonical form. Links that no joint moves against each other are
/// one body, in the frame of the first of them. Throws a Fault.
std::string robot_file(const Machine& machine, const RobotTerms& terms, MeshShapes& meshes,
                       Findings& findings);

}  // namespace rubicon::urdf
