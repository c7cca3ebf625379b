#include "src/exchange/urdf/read_xml.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <pugixml.hpp>
#include <utility>

#include "src/exchange/project_io/decode_text.hpp"
#include "src/exchange/urdf/fault.hpp"
#include "src/exchange/urdf/limits.hpp"

namespace rubicon::urdf {

namespace {

using interpreter::FileId;
using interpreter::Span;

class ElementReader {
 public:
  explicit ElementReader(FileId file) : file_(file) {}

  // Recursion is bounded by kMaxDepth.
  Element read(const pugi::xml_node& node, int depth) {
    Element element;
    element.span = span(node);
    element.name = project_io::clean_text(node.name());
    if (++count_ > kMaxElements) {
      fail("I21", element.span,
           fmt::format("expected at most {} elements, found more", kMaxElements),
           "is this one machine?");
    }
    if (depth > kMaxDepth) {
      fail("I21", element.span,
           fmt::format("expected elements at most {} deep in each other, found more", kMaxDepth));
    }
    for (const pugi::xml_attribute& each : node.attributes()) {
      std::string name = project_io::clean_text(each.name());
      if (element.find(name) != nullptr) {
        fail("I20", element.span,
             fmt::format("attribute '{}' of <{}> is given twice", name, element.name));
      }
      element.attributes.push_back({std::move(name), project_io::clean_text(each.value())});
    }
    for (const pugi::xml_node& child : node) {
      if (child.type() == pugi::node_element) element.children.push_back(read(child, depth + 1));
    }
    return element;
  }

  Span span(const pugi::xml_node& node) const {
    const auto begin = static_cast<std::uint32_t>(std::max<std::ptrdiff_t>(node.offset_debug(), 0));
    return {file_, begin, begin + static_cast<std::uint32_t>(std::strlen(node.name()))};
  }

 private:
  FileId file_;
  std::size_t count_ = 0;
};

}  // namespace

Element read_xml(const interpreter::SourceMap& sources, FileId file) {
  const std::string& text = sources.file(file).text;
  pugi::xml_document document;
  const pugi::xml_parse_result result = document.load_buffer(
      text.data(), text.size(), pugi::parse_default | pugi::parse_doctype, pugi::encoding_utf8);
  const auto place = [&](std::ptrdiff_t offset) {
    const auto at = static_cast<std::uint32_t>(
        std::clamp<std::ptrdiff_t>(offset, 0, static_cast<std::ptrdiff_t>(text.size())));
    return Span{file, at, at};
  };
  // First: what follows a document type may be broken only because it means something there.
  for (const pugi::xml_node& node : document) {
    if (node.type() == pugi::node_doctype) {
      fail("I20", place(node.offset_debug()), "a document type (<!DOCTYPE ...>) is not read",
           "remove it; write what its entities stand for where they are used");
    }
  }
  if (!result) {
    std::string what = result.description();
    what.front() = static_cast<char>(what.front() | 0x20);
    fail("I20", place(result.offset), "this XML is broken: " + what, "correct it at this place");
  }
  const pugi::xml_node root = document.document_element();
  if (!root) fail("I20", place(0), "expected an XML file with the element <robot>, found none");
  ElementReader reader(file);
  for (pugi::xml_node other = root.next_sibling(); other; other = other.next_sibling()) {
    if (other.type() == pugi::node_element) {
      fail("I20", reader.span(other),
           fmt::format("expected one root element, found another: <{}>",
                       project_io::clean_text(other.name())));
    }
  }
  return reader.read(root, 1);
}

}  // namespace rubicon::urdf
