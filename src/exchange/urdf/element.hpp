#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "interpreter/syntax/source.hpp"

namespace rubicon::urdf {

struct Attribute {
  std::string name;
  std::string value;
};

/// An element of an XML file, or one that xacro made of it; text between elements is left out.
struct Element {
  std::string name;
  std::vector<Attribute> attributes;
  std::vector<Element> children;
  interpreter::Span span;  ///< its name, where it was written

  /// The value, null if the attribute is not there.
  const std::string* find(std::string_view attribute) const {
    for (const Attribute& each : attributes) {
      if (each.name == attribute) return &each.value;
    }
    return nullptr;
  }
};

}  // namespace rubicon::urdf
