#include "interpreter/syntax/file_provider.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

namespace rubicon::interpreter {

std::string resolve_path(const std::string& naming_file, const std::string& written) {
  if (!written.empty() && written.front() == '/') return written;
  const std::size_t slash = naming_file.rfind('/');
  const std::string joined =
      slash == std::string::npos ? written : naming_file.substr(0, slash + 1) + written;

  const bool absolute = !joined.empty() && joined.front() == '/';
  std::vector<std::string_view> parts;
  const std::string_view text = joined;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find('/', begin), text.size());
    const std::string_view part = text.substr(begin, end - begin);
    begin = end + 1;
    if (part.empty() || part == ".") continue;
    const bool is_up = part == "..";
    if (is_up && !parts.empty() && parts.back() != "..") {
      parts.pop_back();
    } else if (!is_up || !absolute) {
      parts.push_back(part);
    }
  }
  std::string result = absolute ? "/" : "";
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i > 0) result += '/';
    result += parts[i];
  }
  return result.empty() ? "." : result;
}

}  // namespace rubicon::interpreter
