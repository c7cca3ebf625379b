#include "src/results/film/string_table.hpp"

namespace rubicon::film {

StringTable::StringTable() { number(""); }

std::int64_t StringTable::number(std::string_view text) {
  if (const auto found = numbers_.find(text); found != numbers_.end()) return found->second;
  const auto number = static_cast<std::int64_t>(texts_.size());
  texts_.push_back(&numbers_.emplace(text, number).first->first);
  return number;
}

std::int64_t PlaceTable::number(const Place& place) {
  const auto [slot, fresh] = numbers_.try_emplace(place, static_cast<std::int64_t>(places_.size()));
  if (fresh) places_.push_back(place);
  return slot->second;
}

}  // namespace rubicon::film
