#include "src/exchange/mesh_io/ply_head.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>

namespace rubicon::mesh_io {

namespace {

/// The next line, without its end; takes it off the front.
std::string_view take_line(std::string_view& text) {
  const std::size_t end = text.find_first_of("\r\n");
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  return line;
}

/// The count of `element vertex 8`; 0 where there is none that is a number.
std::uint64_t announced(std::string_view line) {
  const std::size_t digits = line.find_last_of(" \t") + 1;
  std::uint64_t count = 0;
  const auto [end, error] = std::from_chars(line.data() + digits, line.data() + line.size(), count);
  if (error == std::errc::result_out_of_range) return UINT64_MAX;
  return end == line.data() + line.size() ? count : 0;
}

}  // namespace

std::string ply_fault(std::string_view head, std::uint64_t size) {
  while (!head.empty()) {
    std::string_view line = take_line(head);
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    if (line.starts_with("end_header")) return {};
    // Each element takes a byte at least.
    if (line.starts_with("element") && announced(line) > size) {
      return fmt::format("it cannot be read as PLY: it announces {} elements and has {} bytes",
                         announced(line), size);
    }
  }
  return "it cannot be read as PLY: its header has no end";
}

}  // namespace rubicon::mesh_io
