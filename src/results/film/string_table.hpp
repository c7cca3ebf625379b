#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <tuple>
#include <unordered_map>
#include <vector>

namespace rubicon::film {

/// Each text once, by number; number 0 is "".
class StringTable {
 public:
  StringTable();
  std::int64_t number(std::string_view text);
  const std::vector<const std::string*>& texts() const { return texts_; }

 private:
  struct Hash {
    using is_transparent = void;
    std::size_t operator()(std::string_view text) const {
      return std::hash<std::string_view>()(text);
    }
  };
  std::unordered_map<std::string, std::int64_t, Hash, std::equal_to<>> numbers_;
  std::vector<const std::string*> texts_;  ///< the keys of `numbers_`, which never move
};

/// A place in a text: number of the file's string, line, column; all 0 where there is none.
struct Place {
  std::int64_t file = 0;
  std::int64_t line = 0;
  std::int64_t column = 0;

  auto operator<=>(const Place&) const = default;
};

/// Each place once, by number.
class PlaceTable {
 public:
  std::int64_t number(const Place& place);
  const std::vector<Place>& places() const { return places_; }

 private:
  std::map<Place, std::int64_t> numbers_;
  std::vector<Place> places_;
};

}  // namespace rubicon::film
