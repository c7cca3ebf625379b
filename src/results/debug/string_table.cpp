#include "src/results/debug/string_table.hpp"

#include "src/results/debug/clean_text.hpp"

namespace rubicon::debug {

TextId StringTable::add(std::string_view text) {
  const auto known = ids_.find(text);
  if (known != ids_.end()) return known->second;
  const auto id = static_cast<TextId>(texts_.size());
  texts_.push_back(clean_text(text));
  ids_.emplace(std::string(text), id);
  return id;
}

TextId StringTable::find(std::string_view text) const {
  const auto known = ids_.find(text);
  return known == ids_.end() ? kNone : known->second;
}

const std::string& StringTable::operator[](TextId id) const {
  static const std::string kEmpty;
  return id < texts_.size() ? texts_[id] : kEmpty;
}

}  // namespace rubicon::debug
