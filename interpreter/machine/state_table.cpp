#include "interpreter/machine/state_table.hpp"

#include <utility>

namespace rubicon::interpreter {

std::uint32_t& StateTable::find_or_insert(const Hash128& key, std::uint32_t initial,
                                          bool& inserted) {
  if (size_ >= kMostStates) return restart_with(key, initial, inserted);
  if ((size_ + 1) * 2 > slots_.size()) grow();
  const std::size_t mask = slots_.size() - 1;
  for (std::size_t i = key.low & mask;; i = (i + 1) & mask) {
    Slot& slot = slots_[i];
    if (!slot.used) {
      slot = {key, initial, true};
      ++size_;
      inserted = true;
      return slot.count;
    }
    if (slot.key == key) {
      inserted = false;
      return slot.count;
    }
  }
}

/// A key that is known is found also when the table is full.
std::uint32_t& StateTable::restart_with(const Hash128& key, std::uint32_t initial, bool& inserted) {
  const std::size_t mask = slots_.size() - 1;
  for (std::size_t i = key.low & mask; slots_[i].used; i = (i + 1) & mask) {
    if (slots_[i].key == key) {
      inserted = false;
      return slots_[i].count;
    }
  }
  clear();
  return find_or_insert(key, initial, inserted);
}

void StateTable::clear() {
  if (size_ == 0) return;
  slots_.clear();
  size_ = 0;
}

void StateTable::grow() {
  std::vector<Slot> old = std::exchange(slots_, {});
  slots_.resize(old.empty() ? 64 : old.size() * 2);
  const std::size_t mask = slots_.size() - 1;
  for (const Slot& slot : old) {
    if (!slot.used) continue;
    std::size_t i = slot.key.low & mask;
    while (slots_[i].used) i = (i + 1) & mask;
    slots_[i] = slot;
  }
}

}  // namespace rubicon::interpreter
