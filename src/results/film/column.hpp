#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace rubicon::film {

/// Whole numbers as a film writes them (docs/film.md): zigzag, seven bits a byte, each as it is or
/// as the difference to the one before. Only these bytes are kept.
class Column {
 public:
  explicit Column(double scale = 1, bool delta = false) : scale_(scale), delta_(delta) {}

  void add(std::int64_t value);
  /// As if all values of another column of the same kind were added.
  void add(const Column& more);

  std::size_t count() const { return count_; }
  double scale() const { return scale_; }
  bool delta() const { return delta_; }
  void append_to(std::string& out) const;

 private:
  double scale_;
  bool delta_;
  std::size_t count_ = 0;
  std::int64_t first_ = 0;
  std::int64_t last_ = 0;
  std::string rest_;  ///< all but the first, which is another difference after another column
};

/// Metres, degrees and seconds per whole number.
inline constexpr double kMillionth = 1e-6;

/// No length (m) or angle (degrees) of a film is larger: the page reads whole numbers as doubles,
/// and twice a difference of two such values in millionths must stay below 2^53.
inline constexpr double kLargestValue = 1e9;

/// No time (s) of a film is later, by the same measure, as none is before 0; moments of a plan lie
/// within 126 years.
inline constexpr double kLatestTime = 4e9;

/// Rounded to millionths; throws std::invalid_argument for what is not finite or too large, `what`
/// says what it is.
std::int64_t millionths(double value, const char* what);

/// A time (s) in millionths; throws std::invalid_argument for one before 0 or too late.
std::int64_t time_millionths(double t);

}  // namespace rubicon::film
