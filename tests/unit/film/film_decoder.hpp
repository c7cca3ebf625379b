#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace rubicon::test {

/// The keys of one track in millionths.
struct DecodedTrack {
  std::vector<std::int64_t> t;
  std::vector<std::vector<std::int64_t>> q;  ///< by parameter

  /// The values that a parameter has at a time: several at a jump.
  std::vector<double> at(std::size_t parameter, std::int64_t time) const;
};

/// A film read back as docs/film.md describes it; fails the test for what does not keep to it.
struct DecodedFilm {
  nlohmann::ordered_json head;
  std::map<std::string, std::vector<std::int64_t>> columns;

  /// A column of numbers of strings.
  std::vector<std::string> texts(const std::string& column) const;
  /// A column of places, as file:line:column.
  std::vector<std::string> places(const std::string& column) const;
  /// The track of a robot, `run` -1 for what happened.
  DecodedTrack track(int robot, int run = -1) const;
};

DecodedFilm decode_film(std::string_view bytes);

/// The text that gzip packed.
std::string unpacked(std::string_view bytes);

}  // namespace rubicon::test
