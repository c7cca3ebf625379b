#include "bench/pibt_jobs.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace rubicon::bench {

using grid::at;
using grid::CellId;

namespace {

/// On maps with dead ends PIBT may go on for ever: after so many ticks without an arrival it has
/// come to nothing.
constexpr int kStill = 5'000;

}  // namespace

PibtJobs::PibtJobs(const grid::GridProblem& problem, const std::vector<grid::GridJob>& jobs,
                   std::uint64_t seed)
    : graph_(problem.map),
      board_(graph_, jobs, problem.agents.size()),
      distances_(graph_, std::vector<CellId>(2 * problem.agents.size(), 0)),
      random_(seed),
      leg_(problem.agents.size(), 0),
      here_(at(graph_.size()), -1),
      next_here_(at(graph_.size()), -1),
      order_(problem.agents.size()) {
  const std::size_t count = problem.agents.size();
  for (std::size_t i = 0; i < count; ++i) {
    cells_.push_back(graph_.id(problem.agents[i].from));
    distances_.set_goal(2 * static_cast<int>(i), graph_.id(problem.agents[i].to));
    first_.push_back(static_cast<double>(i) / static_cast<double>(count));
  }
  priority_ = first_;
  std::iota(order_.begin(), order_.end(), 0U);
}

int PibtJobs::goal_row(std::size_t vehicle) const {
  return 2 * static_cast<int>(vehicle) + leg_[vehicle];
}

bool PibtJobs::advance() {
  if (board_.is_done() || now_ - last_arrival_ > kStill) return false;
  const std::size_t count = cells_.size();
  const auto arrive = [&](std::size_t i) {
    if (!board_.arrive(static_cast<int>(i), now_, cells_[i])) return;
    last_arrival_ = now_;
    priority_[i] = first_[i];
    leg_[i] = 1;
  };
  for (bool again = true; again;) {
    again = false;
    for (const int vehicle : board_.give(now_, cells_)) {
      const std::size_t i = at(vehicle);
      const int job = board_.job_of(vehicle);
      distances_.set_goal(2 * vehicle, board_.from(job));
      distances_.set_goal(2 * vehicle + 1, board_.to(job));
      leg_[i] = 0;
      priority_[i] = first_[i];
      arrive(i);
      again = again || board_.job_of(vehicle) < 0;
    }
  }
  if (board_.is_done()) return false;
  std::sort(order_.begin(), order_.end(),
            [&](std::size_t a, std::size_t b) { return priority_[a] > priority_[b]; });
  next_.assign(count, grid::kNowhere);
  for (std::size_t i = 0; i < count; ++i) here_[at(cells_[i])] = static_cast<int>(i);
  for (const std::size_t i : order_) {
    if (next_[i] == grid::kNowhere) assign(i, -1);
  }
  for (std::size_t i = 0; i < count; ++i) here_[at(cells_[i])] = -1;
  for (std::size_t i = 0; i < count; ++i) next_here_[at(next_[i])] = -1;
  cells_ = next_;
  ++now_;
  for (std::size_t i = 0; i < count; ++i) {
    if (board_.job_of(static_cast<int>(i)) >= 0) ++priority_[i];
    arrive(i);
  }
  return true;
}

bool PibtJobs::assign(std::size_t vehicle, int pushed_by) {
  using Choice = std::tuple<int, int, std::uint64_t, CellId>;
  std::vector<Choice> choices;
  const auto add = [&](CellId cell) {
    const int other = here_[at(cell)];
    const bool is_taken = other >= 0 && other != static_cast<int>(vehicle);
    choices.emplace_back(distances_.to_goal(goal_row(vehicle), cell), is_taken ? 1 : 0,
                         random_.next(), cell);
  };
  const CellId from = cells_[vehicle];
  add(from);
  for (const CellId beside : graph_.beside(from)) add(beside);
  std::sort(choices.begin(), choices.end());
  for (const Choice& choice : choices) {
    const CellId cell = std::get<3>(choice);
    if (next_here_[at(cell)] >= 0) continue;
    if (pushed_by >= 0 && cells_[at(pushed_by)] == cell) continue;
    next_[vehicle] = cell;
    next_here_[at(cell)] = static_cast<int>(vehicle);
    const int other = here_[at(cell)];
    if (other >= 0 && next_[at(other)] == grid::kNowhere &&
        !assign(at(other), static_cast<int>(vehicle))) {
      continue;
    }
    return true;
  }
  next_[vehicle] = from;
  next_here_[at(from)] = static_cast<int>(vehicle);
  return false;
}

}  // namespace rubicon::bench
