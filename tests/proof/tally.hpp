#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "tests/proof/case.hpp"

namespace rubicon::collision::proof {

/// What came of many questions of one kind.
struct Count {
  std::int64_t questions = 0;
  std::int64_t hits = 0;   ///< by the oracle
  std::int64_t frees = 0;  ///< by the oracle; the rest is too near to call
  std::int64_t misses = 0;
  std::int64_t false_hits = 0;
  std::int64_t fcl_hits = 0;  ///< the oracle's hits that FCL was asked about
  std::int64_t fcl_misses = 0;
  std::int64_t fcl_frees = 0;
  std::int64_t fcl_false_hits = 0;
  std::int64_t third_answers = 0;  ///< where the third voice made up its mind and the oracle too
  std::int64_t quarrels = 0;       ///< of these, where it says the opposite

  void add(const Outcome& outcome);
  Count& operator+=(const Count& other);
  bool is_clean() const { return misses == 0 && false_hits == 0 && quarrels == 0; }
};

/// The counts of one generator, by kind of motion, and the cases that went wrong.
struct Tally {
  static constexpr int kKinds = 6;
  std::array<Count, kKinds> by_kind;
  std::vector<std::uint64_t> wrong;  ///< indices of cases, in rising order once all are in

  void add(std::uint64_t index, const CaseRecord& record);
  Tally& operator+=(const Tally& other);
  Count total() const;
};

std::string table_head();
/// One line a kind of motion that occurs.
std::string table_lines(std::string_view name, const Tally& tally);
std::string table_total(const Count& count);

}  // namespace rubicon::collision::proof
