#include "tests/unit/film/film_decoder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace rubicon::test {

namespace {

std::uint32_t unsigned_at(std::string_view bytes, std::size_t place) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;)
    value = value << 8 | static_cast<unsigned char>(bytes[place + i]);
  return value;
}

std::vector<std::int64_t> read_column(std::string_view body, const nlohmann::ordered_json& where) {
  std::size_t place = where.at("offset");
  std::vector<std::int64_t> values;
  for (std::size_t i = 0; i < where.at("count"); ++i) {
    std::uint64_t zigzag = 0;
    int shift = 0;
    while (true) {
      const auto byte = static_cast<unsigned char>(body.at(place++));
      zigzag |= static_cast<std::uint64_t>(byte & 127) << shift;
      if (byte < 128) break;
      shift += 7;
    }
    std::int64_t value = static_cast<std::int64_t>(zigzag / 2);
    if (zigzag % 2 == 1) value = -value - 1;
    if (where.at("delta") && !values.empty()) value += values.back();
    values.push_back(value);
  }
  return values;
}

}  // namespace

std::vector<double> DecodedTrack::at(std::size_t parameter, std::int64_t time) const {
  const std::vector<std::int64_t>& values = q.at(parameter);
  const auto from = std::lower_bound(t.begin(), t.end(), time);
  const auto to = std::upper_bound(t.begin(), t.end(), time);
  if (from != to) return {values.begin() + (from - t.begin()), values.begin() + (to - t.begin())};
  if (from == t.begin()) return {static_cast<double>(values.front())};
  if (from == t.end()) return {static_cast<double>(values.back())};
  const auto after = static_cast<std::size_t>(from - t.begin());
  const double part =
      static_cast<double>(time - t[after - 1]) / static_cast<double>(t[after] - t[after - 1]);
  return {static_cast<double>(values[after - 1]) +
          part * static_cast<double>(values[after] - values[after - 1])};
}

std::vector<std::string> DecodedFilm::texts(const std::string& column) const {
  std::vector<std::string> result;
  for (const std::int64_t number : columns.at(column)) {
    result.push_back(head.at("strings").at(static_cast<std::size_t>(number)));
  }
  return result;
}

std::vector<std::string> DecodedFilm::places(const std::string& column) const {
  std::vector<std::string> result;
  for (const std::int64_t number : columns.at(column)) {
    const auto& place = head.at("places").at(static_cast<std::size_t>(number));
    const std::string file = head.at("strings").at(place.at(0).get<std::size_t>());
    result.push_back(fmt::format("{}:{}:{}", file, place.at(1).get<int>(), place.at(2).get<int>()));
  }
  return result;
}

DecodedTrack DecodedFilm::track(int robot, int run) const {
  const auto cut = [&](const char* column, std::size_t from, std::size_t count) {
    const std::vector<std::int64_t>& all = columns.at(column);
    if (from + count > all.size()) throw std::out_of_range(column);
    const auto begin = all.begin() + static_cast<std::ptrdiff_t>(from);
    return std::vector<std::int64_t>(begin, begin + static_cast<std::ptrdiff_t>(count));
  };
  for (const auto& track : head.at("tracks")) {
    if (track.at("robot") != robot || track.at("run") != run) continue;
    const std::size_t count = track.at("count");
    const std::size_t first = track.at("q");
    DecodedTrack result;
    result.t = cut("key.t", track.at("first"), count);
    const auto& parameters =
        head.at("header").at("robots").at(static_cast<std::size_t>(robot)).at("parameters");
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      result.q.push_back(cut("key.q", first + i * count, count));
    }
    return result;
  }
  throw std::out_of_range(fmt::format("no track of robot {} in run {}", robot, run));
}

DecodedFilm decode_film(std::string_view bytes) {
  constexpr std::size_t kBeforeHead = 16;
  EXPECT_EQ(bytes.substr(0, 8), "RUBICONF");
  EXPECT_EQ(unsigned_at(bytes, 8), 1u);
  const std::size_t length = unsigned_at(bytes, 12);
  DecodedFilm film;
  film.head = nlohmann::ordered_json::parse(bytes.substr(kBeforeHead, length));
  const std::string_view body = bytes.substr(kBeforeHead + length);
  for (const auto& [name, where] : film.head.at("columns").items()) {
    film.columns[name] = read_column(body, where);
  }
  return film;
}

std::string unpacked(std::string_view bytes) {
  z_stream stream{};
  inflateInit2(&stream, 15 + 16);
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  std::string result;
  std::array<char, 4096> piece{};
  int state = Z_OK;
  while (state == Z_OK) {
    stream.next_out = reinterpret_cast<Bytef*>(piece.data());
    stream.avail_out = static_cast<uInt>(piece.size());
    state = inflate(&stream, Z_NO_FLUSH);
    result.append(piece.data(), piece.size() - stream.avail_out);
  }
  EXPECT_EQ(state, Z_STREAM_END);
  EXPECT_EQ(stream.avail_in, 0u);
  inflateEnd(&stream);
  return result;
}

}  // namespace rubicon::test
