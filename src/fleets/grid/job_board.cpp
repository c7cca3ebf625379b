#include "src/fleets/grid/job_board.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "src/fleets/grid/random_bits.hpp"

namespace rubicon::grid {

namespace {

/// The open cells that can be reached from a cell, by number.
std::vector<char> reached_from(const CellGraph& graph, CellId start) {
  std::vector<char> reached(at(graph.size()), 0);
  std::vector<CellId> open = {start};
  reached[at(start)] = 1;
  while (!open.empty()) {
    const CellId here = open.back();
    open.pop_back();
    for (const CellId beside : graph.beside(here)) {
      if (reached[at(beside)] != 0) continue;
      reached[at(beside)] = 1;
      open.push_back(beside);
    }
  }
  return reached;
}

}  // namespace

std::vector<GridJob> draw_jobs(const GridProblem& problem, std::size_t count, double interval,
                               std::uint64_t seed) {
  std::vector<GridJob> jobs;
  if (problem.agents.empty()) return jobs;
  const CellGraph graph(problem.map);
  const std::vector<char> reached = reached_from(graph, graph.id(problem.agents.front().from));
  std::vector<Cell> cells;
  for (CellId id = 0; id < graph.size(); ++id) {
    if (reached[at(id)] != 0) cells.push_back(graph.cell(id));
  }
  if (cells.size() < 2) return jobs;
  RandomBits random(seed);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t from = random.below(cells.size());
    std::size_t to = random.below(cells.size() - 1);
    if (to >= from) ++to;
    const double arrives = std::floor(static_cast<double>(i) * interval);
    jobs.push_back({fmt::format("j{}", i + 1), cells[from], cells[to], static_cast<int>(arrives)});
  }
  return jobs;
}

std::vector<GridFault> faults_of_jobs(const GridProblem& problem,
                                      const std::vector<GridJob>& jobs) {
  std::vector<GridFault> faults;
  if (jobs.empty()) return faults;
  if (problem.agents.empty()) {
    faults.push_back({-1, -1, false, "there are jobs, and no agents to do them"});
    return faults;
  }
  const CellGraph graph(problem.map);
  const std::vector<char> reached = reached_from(graph, graph.id(problem.agents.front().from));
  for (const GridAgent& agent : problem.agents) {
    if (reached[at(graph.id(agent.from))] != 0) continue;
    faults.push_back(
        {-1, -1, false,
         fmt::format("agents '{}' and '{}' cannot reach each other: walls lie between, "
                     "and any of them may get any job",
                     problem.agents.front().name, agent.name)});
    return faults;
  }
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    for (const bool at_end : {false, true}) {
      const Cell cell = at_end ? jobs[i].to : jobs[i].from;
      const auto wrong = [&](const std::string& how) {
        faults.push_back({static_cast<int>(i), -1, at_end,
                          fmt::format("job '{}' {} ({}, {}), which {}", jobs[i].name,
                                      at_end ? "ends at" : "begins at", cell.x, cell.y, how)});
      };
      if (!problem.map.has(cell)) {
        wrong(
            fmt::format("is outside of the map of {} x {}", problem.map.columns, problem.map.rows));
      } else if (!problem.map.is_open(cell)) {
        wrong("is on a wall");
      } else if (reached[at(graph.id(cell))] == 0) {
        wrong("no agent can reach: walls lie between");
      }
    }
  }
  return faults;
}

JobBoard::JobBoard(const CellGraph& graph, const std::vector<GridJob>& jobs, std::size_t vehicles)
    : graph_(graph),
      jobs_(jobs),
      order_(jobs.size()),
      records_(jobs.size()),
      job_of_(vehicles, -1),
      free_(vehicles),
      there_(at(graph.size()), -1),
      seen_(at(graph.size()), 0) {
  for (const GridJob& job : jobs) {
    from_.push_back(graph.id(job.from));
    to_.push_back(graph.id(job.to));
  }
  std::iota(order_.begin(), order_.end(), 0);
  std::stable_sort(order_.begin(), order_.end(),
                   [&](int a, int b) { return jobs[at(a)].arrives < jobs[at(b)].arrives; });
}

int JobBoard::nearest_free(CellId cell) {
  ++search_;
  seen_[at(cell)] = search_;
  border_ = {cell};
  while (!border_.empty()) {
    int best = -1;
    next_.clear();
    for (const CellId here : border_) {
      const int vehicle = there_[at(here)];
      if (vehicle >= 0 && (best < 0 || vehicle < best)) best = vehicle;
      for (const CellId beside : graph_.beside(here)) {
        if (seen_[at(beside)] == search_) continue;
        seen_[at(beside)] = search_;
        next_.push_back(beside);
      }
    }
    if (best >= 0) return best;
    border_.swap(next_);
  }
  return -1;
}

const std::vector<int>& JobBoard::give(int tick, const Configuration& cells) {
  got_.clear();
  const auto is_ready = [&] {
    return free_ > 0 && given_ < order_.size() && jobs_[at(order_[given_])].arrives <= tick;
  };
  if (!is_ready()) return got_;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (job_of_[i] < 0) there_[at(cells[i])] = static_cast<int>(i);
  }
  while (is_ready()) {
    const int job = order_[given_++];
    const int vehicle = nearest_free(from_[at(job)]);
    job_of_[at(vehicle)] = job;
    records_[at(job)].vehicle = vehicle;
    records_[at(job)].taken = tick;
    --free_;
    there_[at(cells[at(vehicle)])] = -1;
    got_.push_back(vehicle);
  }
  for (const CellId cell : cells) there_[at(cell)] = -1;
  return got_;
}

bool JobBoard::arrive(int vehicle, int tick, CellId cell) {
  const int job = job_of_[at(vehicle)];
  if (job < 0) return false;
  JobRecord& record = records_[at(job)];
  bool did = false;
  if (record.picked < 0 && cell == from_[at(job)]) {
    record.picked = tick;
    did = true;
  }
  if (record.picked >= 0 && cell == to_[at(job)]) {
    record.delivered = tick;
    job_of_[at(vehicle)] = -1;
    ++free_;
    ++delivered_;
    did = true;
  }
  return did;
}

bool JobBoard::is_idle() const { return free_ == job_of_.size(); }

}  // namespace rubicon::grid
