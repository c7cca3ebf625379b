#include "tests/proof/tally.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rubicon::collision::proof {
namespace {

std::string share(std::int64_t part, std::int64_t whole) {
  if (whole == 0) return "-";
  return fmt::format("{:.2f} %", 100.0 * static_cast<double>(part) / static_cast<double>(whole));
}

std::string line(std::string_view name, std::string_view motion, const Count& count) {
  return fmt::format(
      "| {:<12} | {:<9} | {:>9} | {:>9} | {:>9} | {:>7} | {:>6} | {:>10} | {:>10} | {:>14} | {:>8} "
      "| "
      "{:>8} |\n",
      name, motion, count.questions, count.hits, count.frees,
      count.questions - count.hits - count.frees, count.misses, count.false_hits,
      share(count.fcl_misses, count.fcl_hits), share(count.fcl_false_hits, count.fcl_frees),
      count.third_answers, count.quarrels);
}

}  // namespace

void Count::add(const Outcome& outcome) {
  ++questions;
  const bool hit = outcome.truth == Truth::kHit;
  const bool free = outcome.truth == Truth::kFree;
  hits += hit;
  frees += free;
  misses += outcome.is_miss();
  false_hits += outcome.is_false_hit();
  if (outcome.fcl_hit) {
    fcl_hits += hit;
    fcl_frees += free && !outcome.grazes;
    fcl_misses += hit && !*outcome.fcl_hit;
    fcl_false_hits += free && !outcome.grazes && *outcome.fcl_hit;
  }
  third_answers += outcome.third && *outcome.third != Truth::kNearBoundary && (hit || free);
  quarrels += outcome.is_quarrel();
}

Count& Count::operator+=(const Count& other) {
  questions += other.questions;
  hits += other.hits;
  frees += other.frees;
  misses += other.misses;
  false_hits += other.false_hits;
  fcl_hits += other.fcl_hits;
  fcl_misses += other.fcl_misses;
  fcl_frees += other.fcl_frees;
  fcl_false_hits += other.fcl_false_hits;
  third_answers += other.third_answers;
  quarrels += other.quarrels;
  return *this;
}

void Tally::add(std::uint64_t index, const CaseRecord& record) {
  bool is_wrong = false;
  for (const Outcome& outcome : record.outcomes) {
    by_kind[static_cast<std::size_t>(outcome.motion)].add(outcome);
    is_wrong = is_wrong || outcome.is_miss() || outcome.is_false_hit() || outcome.is_quarrel();
  }
  if (is_wrong) wrong.push_back(index);
}

Tally& Tally::operator+=(const Tally& other) {
  for (std::size_t i = 0; i < by_kind.size(); ++i) by_kind[i] += other.by_kind[i];
  wrong.insert(wrong.end(), other.wrong.begin(), other.wrong.end());
  std::sort(wrong.begin(), wrong.end());
  return *this;
}

Count Tally::total() const {
  Count sum;
  for (const Count& count : by_kind) sum += count;
  return sum;
}

std::string table_head() {
  return "| cases        | motion    | questions |      hits |      free |    near | misses | "
         "false hits | FCL misses | FCL false hits | 3rd says | opposite |\n"
         "|---|---|---|---|---|---|---|---|---|---|---|---|\n";
}

std::string table_lines(std::string_view name, const Tally& tally) {
  std::string lines;
  for (std::size_t i = 0; i < tally.by_kind.size(); ++i) {
    if (tally.by_kind[i].questions > 0)
      lines += line(name, name_of(static_cast<MotionKind>(i)), tally.by_kind[i]);
  }
  return lines;
}

std::string table_total(const Count& count) { return line("all", "", count); }

}  // namespace rubicon::collision::proof
