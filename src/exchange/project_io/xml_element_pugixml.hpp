#pragma once

#include <fmt/format.h>

#include <cstring>
#include <pugixml.hpp>
#include <string>
#include <type_traits>
#include <vector>

#include "src/exchange/project_io/decode_text.hpp"
#include "src/exchange/project_io/listing.hpp"
#include "src/exchange/project_io/value_text.hpp"

namespace rubicon::project_io {

/// What reading an XML file needs everywhere.
struct XmlReading {
  interpreter::FileId file = interpreter::kNoFile;
  Listing listing;

  /// The name of an element.
  interpreter::Span span(const pugi::xml_node& node) const {
    const auto begin = static_cast<std::uint32_t>(std::max<std::ptrdiff_t>(node.offset_debug(), 0));
    return {file, begin, begin + static_cast<std::uint32_t>(std::strlen(node.name()))};
  }
};

/// All text directly in an element, whatever comments stand between.
inline std::string text_in(const pugi::xml_node& node) {
  std::string text;
  for (const pugi::xml_node& child : node) {
    if (child.type() == pugi::node_pcdata || child.type() == pugi::node_cdata)
      text += child.value();
  }
  return clean_text(text);
}

/// One element whose children are fields. Takes them one by one; what was not taken in the end is
/// listed, so nothing is passed over by mistake.
class XmlElement {
 public:
  XmlElement(const pugi::xml_node& node, XmlReading& reading) : node_(node), reading_(reading) {
    for (const pugi::xml_node& child : node) {
      if (child.type() == pugi::node_element) children_.push_back({child, false});
    }
  }

  /// Reads a field if it is there; a wrong value is listed and left out.
  template <typename T>
  void operator()(const char* /*word*/, const char* element, T& member) {
    const pugi::xml_node child = take(element);
    if (!child) return;
    const std::string text = text_in(child);
    if (text.find_first_not_of(" \t\r\n") == std::string::npos) return;
    if (accept(text, member)) return;
    reading_.listing.add("I03", fmt::format("value {}/{}", node_.name(), element),
                         reading_.span(child),
                         fmt::format("expected {} in {} of {}, found '{}'; left out",
                                     expected_for(text, member), element, node_.name(), text));
  }

  /// The first child of that name that was not taken yet; a null node if there is none.
  pugi::xml_node take(const char* element) {
    for (Child& child : children_) {
      if (child.taken || std::strcmp(child.node.name(), element) != 0) continue;
      child.taken = true;
      return child.node;
    }
    return {};
  }

  std::vector<pugi::xml_node> take_all(const char* element) {
    std::vector<pugi::xml_node> result;
    for (Child& child : children_) {
      if (child.taken || std::strcmp(child.node.name(), element) != 0) continue;
      child.taken = true;
      result.push_back(child.node);
    }
    return result;
  }

  /// Lists what is left; empty elements say nothing.
  void finish() {
    for (const Child& child : children_) {
      if (child.taken) continue;
      const bool has_children = !child.node
                                     .find_child([](const pugi::xml_node& inner) {
                                       return inner.type() == pugi::node_element;
                                     })
                                     .empty();
      const std::string text = has_children ? std::string() : text_in(child.node);
      if (!has_children && text.find_first_not_of(" \t\r\n") == std::string::npos) continue;
      reading_.listing.add(
          "I07", fmt::format("element {}/{}", node_.name(), child.node.name()),
          reading_.span(child.node),
          has_children ? fmt::format("{} of {} is not taken over", child.node.name(), node_.name())
                       : fmt::format("{} of {} is not taken over, here '{}'", child.node.name(),
                                     node_.name(), text));
    }
  }

 private:
  struct Child {
    pugi::xml_node node;
    bool taken = false;
  };

  template <typename T>
  static bool accept(const std::string& text, T& member) {
    if constexpr (std::is_same_v<T, TimeFormat>) {
      std::int64_t code = 0;
      if (!read(text, code)) return false;
      // 21 and 53 say that no unit was chosen.
      if (code == 21 || code == 53) return true;
      const auto format = format_of_code(code);
      if (format) member = *format;
      return format.has_value();
    } else {
      return read(text, member);
    }
  }

  pugi::xml_node node_;
  XmlReading& reading_;
  std::vector<Child> children_;
};

}  // namespace rubicon::project_io
