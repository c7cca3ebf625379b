#include "src/earth/soil/terrain.hpp"

#include <charconv>
#include <cmath>

namespace rubicon::soil {

namespace {

bool separates(char c) { return c == ',' || c == ';' || c == ' ' || c == '\t' || c == '\r'; }

std::string at_line(int line) { return "line " + std::to_string(line) + ": "; }

}  // namespace

Terrain flat(int columns, int rows, Millimetres cell, Millimetres height) {
  return {columns, rows, cell,
          Heights(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), height)};
}

std::variant<Terrain, std::string> terrain_of(std::string_view text, int columns, int rows,
                                              Millimetres cell) {
  Terrain result = flat(columns, rows, cell, 0);
  int row = rows;
  int line = 0;
  while (!text.empty()) {
    ++line;
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view rest = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    const auto skip = [&] {
      while (!rest.empty() && separates(rest.front())) rest.remove_prefix(1);
    };
    skip();
    if (rest.empty() || rest.front() == '#') continue;
    if (--row < 0) return at_line(line) + "more than " + std::to_string(rows) + " rows of heights";
    int column = 0;
    for (; !rest.empty(); skip()) {
      double metres = 0;
      const auto [last, error] = std::from_chars(rest.data(), rest.data() + rest.size(), metres);
      const auto length = static_cast<std::size_t>(last - rest.data());
      if (error != std::errc() || (length < rest.size() && !separates(rest[length]))) {
        return at_line(line) + "expected a height in m, found '" +
               std::string(
                   rest.substr(0, std::min<std::size_t>(rest.find_first_of(",; \t\r"), 20))) +
               "'";
      }
      if (!(std::fabs(metres) * 1e3 <= static_cast<double>(kMostHeight))) {
        return at_line(line) + "a height is up to 10000 m either way";
      }
      if (column == columns) {
        return at_line(line) + "more than " + std::to_string(columns) + " heights in a row";
      }
      result.heights.set(result.index(column++, row), std::llround(metres * 1e3));
      rest.remove_prefix(length);
    }
    if (column < columns) {
      return at_line(line) + "expected " + std::to_string(columns) + " heights, found " +
             std::to_string(column);
    }
  }
  if (row > 0) {
    return "expected " + std::to_string(rows) + " rows of heights, found " +
           std::to_string(rows - row);
  }
  return result;
}

}  // namespace rubicon::soil
