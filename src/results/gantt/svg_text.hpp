#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rubicon::gantt {

/// Text as the content of an XML element or attribute: markup is escaped; what XML does not allow
/// (control characters, bytes that are not UTF-8) and what would turn the direction of text around
/// becomes U+FFFD. Line breaks stay.
std::string xml_text(std::string_view text);

/// How wide a text is, estimated for a plain sans-serif font of this size, rather too wide.
double text_width(std::string_view text, double size);

/// The text on one line, cut to a width, with an ellipsis where something is missing; "" if not
/// even a few characters fit.
std::string clipped(std::string_view text, double width, double size);

/// The text in lines of a width, the last cut if it needs more than `most` lines.
std::vector<std::string> wrapped(std::string_view text, double width, double size,
                                 std::size_t most);

/// A length with two digits after the point at most.
std::string length_text(double length);

}  // namespace rubicon::gantt
