#pragma once

#include <string>
#include <string_view>

/// The text of an attribute (`storey "0"`) as it stands in a plan, and what it says.
namespace rubicon::interpreter {

/// What a text between the quotation marks of a plan says: `&quot;`, `&amp;` and `&lbrace;` are
/// `"`,
/// `&` and `{`, everything else is itself.
std::string plain_attribute(std::string_view written);

/// The same the other way: `plain_attribute` of it is `text`, but for what no attribute takes:
/// control characters are blanks, and a text that is too long is cut. Empty if nothing is left.
std::string written_attribute(std::string_view text);

/// What is wrong with what an attribute says, to follow its name ("is empty"); empty: nothing.
std::string attribute_mistake(std::string_view text);

}  // namespace rubicon::interpreter
