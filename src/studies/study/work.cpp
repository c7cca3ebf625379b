#include "src/studies/study/work.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "src/simulation/taskplan/run_plan.hpp"

namespace rubicon::study {

std::shared_ptr<const OpenVariants::Entry> OpenVariants::get(
    std::size_t variant, const interpreter::ParameterTexts& set) {
  std::shared_ptr<Slot> slot;
  {
    const std::lock_guard lock(mutex_);
    const auto found = std::find_if(slots_.begin(), slots_.end(),
                                    [&](const auto& each) { return each->variant == variant; });
    if (found != slots_.end()) {
      slots_.splice(slots_.begin(), slots_, found);
    } else {
      slots_.push_front(std::make_shared<Slot>());
      slots_.front()->variant = variant;
      if (slots_.size() > most_) slots_.pop_back();
    }
    slot = slots_.front();
  }
  const std::lock_guard lock(slot->reading);
  if (slot->entry) return slot->entry;
  auto entry = std::make_shared<Entry>();
  entry->loaded = read_(variant, set);
  entry->fault = entry->loaded.fault;
  if (entry->loaded.plan) {
    try {
      entry->site = site::prepare_site(*entry->loaded.plan);
    } catch (const std::invalid_argument& error) {
      entry->fault = error.what();
    }
  }
  slot->entry = std::move(entry);
  return slot->entry;
}

void OpenVariants::forget(std::size_t variant) {
  const std::lock_guard lock(mutex_);
  std::erase_if(slots_, [&](const auto& each) { return each->variant == variant; });
}

PieceResult Worker::work(const Piece& piece) {
  const auto entry = variants_.get(piece.variant, piece.set);
  PieceResult result;
  result.digest = entry->loaded.digest;
  result.fault = entry->fault;
  if (!result.fault.empty()) return result;
  if (piece.runs.empty()) {
    result.facts = facts_of(*entry->loaded.plan);
    return result;
  }
  const interpreter::PlanModel& plan = *entry->loaded.plan;
  interpreter::Draws draws;
  taskplan::RunOptions options;
  options.detail = trace::TraceDetail::none;
  options.prepared = &entry->site;
  options.draws = &draws;
  for (const std::int64_t run : piece.runs) {
    if (stop_ && *stop_) break;
    if (study_.sampled) draws = draws_of(plan, {study_.seed, static_cast<std::uint64_t>(run)});
    try {
      const taskplan::Schedule schedule =
          taskplan::run_plan(plan, entry->loaded.sources, nullptr, options);
      result.runs.push_back({piece.variant, run, record_of(study_, plan, schedule, run < kCurves)});
    } catch (const std::invalid_argument& error) {
      result.fault = error.what();
      break;
    }
  }
  return result;
}

}  // namespace rubicon::study
