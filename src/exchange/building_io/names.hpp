#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace rubicon::building_io {

/// What the task that puts a component into place is called, before the component's name.
inline constexpr std::string_view kPartPrefix = "set_";

/// A name out of a model for a plan, a table or a message: UTF-8 on one line, without control
/// characters.
std::string clean(std::string_view name);

/// Whether a text can stand between the quotation marks of a plan.
bool can_be_quoted(std::string_view text);

/// "1 element", "3 elements".
std::string counted(std::size_t count, const std::string& thing);

/// "a, b and 3 more": no more than `most` by name.
std::string joined(const std::vector<std::string>& names, std::size_t most);

/// Between quotation marks for a remark, shortened where it is long; "-" if it is empty.
std::string remark_name(std::string_view name);

}  // namespace rubicon::building_io
