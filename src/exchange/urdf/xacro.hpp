#pragma once

#include <map>
#include <string>

#include "interpreter/syntax/source.hpp"
#include "src/exchange/urdf/element.hpp"
#include "src/exchange/urdf/findings.hpp"
#include "src/exchange/urdf/package_files.hpp"

namespace rubicon::urdf {

/// What the expansion of a xacro file has at hand.
struct XacroContext {
  std::map<std::string, std::string> arguments;  ///< for $(arg NAME)
  std::string path;                              ///< of the file, for what it includes
  interpreter::SourceMap* sources = nullptr;     ///< included files are added
  PackageFiles* files = nullptr;
  Findings* findings = nullptr;
};

/// Whether a file wants to be expanded.
bool is_xacro(const Element& root, const std::string& path);

/// The URDF that a xacro file means: properties, macros, blocks, includes, arguments, conditionals
/// and expressions of ROS 2's xacro. What it cannot do it names. Throws a Fault.
Element expand_xacro(const Element& root, const XacroContext& context);

}  // namespace rubicon::urdf
