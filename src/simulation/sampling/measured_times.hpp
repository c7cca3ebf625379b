#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace rubicon::sampling {

/// Times that were measured: each is as likely as any other.
struct MeasuredTimes {
  std::string file;                      ///< as sources call it
  std::string unit;                      ///< of the file: s, min, h
  int column = 1;                        ///< of the file, from 1
  std::vector<double> times;             ///< s, as in the file; not empty
  double mean = 0, least = 0, most = 0;  ///< s
};

/// What to read of a table of times.
struct MeasuredColumn {
  std::optional<std::string> name;  ///< as the first line calls it
  std::optional<int> number;        ///< from 1; neither: there is only one
  double seconds_per_unit = 1;
};

/// What is wrong with a table, and where in the text.
struct MeasuredFault {
  std::size_t begin = 0, end = 0;
  std::string message;
  std::string hint = {};
  std::vector<std::string> headings = {};  ///< of columns, where none has the wanted name
};

/// More times than this are not read.
inline constexpr std::size_t kMostMeasured = 1'000'000;
/// A measured time takes at most so long, s: 126 years.
inline constexpr double kLongestMeasured = 4e9;

/// Reads a column of times. Fields are parted by `;` where the first line has one, else by tabs,
/// else by commas; they may stand in double quotes. The first line is a heading where what stands
/// in the column is no number. Empty lines and fields are no times; lines that begin with # are
/// comments. Between commas no line has more fields than the first: its decimal point would be a
/// comma. `file` and `unit` of the result are left to the caller.
std::variant<MeasuredTimes, MeasuredFault> read_measured(std::string_view text,
                                                         const MeasuredColumn& column);

}  // namespace rubicon::sampling
