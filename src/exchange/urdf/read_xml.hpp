#pragma once

#include "interpreter/syntax/source.hpp"
#include "src/exchange/urdf/element.hpp"

namespace rubicon::urdf {

/// The root element of a file in `sources`. A document type is refused, so no entity is ever
/// expanded. Throws a Fault.
Element read_xml(const interpreter::SourceMap& sources, interpreter::FileId file);

}  // namespace rubicon::urdf
