#include "src/results/report/jobs_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "src/results/report/grid_map_json.hpp"

namespace rubicon::report {

namespace {

using grid::JobRecord;
using grid::JobsResult;
using interpreter::GridSpec;

/// Agents that stand still and are named.
constexpr std::size_t kNamedStuck = 10;

double share(std::int64_t part, std::int64_t whole) {
  return whole == 0 ? 0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

double mean(std::int64_t sum, std::int64_t count) {
  return count == 0 ? 0 : static_cast<double>(sum) / static_cast<double>(count);
}

/// What the records say together.
struct JobSums {
  std::int64_t delivered = 0, taken = 0;
  std::int64_t under_way = 0;  ///< ticks from taken to delivered, of those that were
  std::int64_t queued = 0;     ///< ticks from arrived to taken, of those that were
  int longest = 0;
  int longest_queue = 0;  ///< most jobs that had arrived and nobody had
};

JobSums sums_of(const GridSpec& spec, const JobsResult& result) {
  JobSums sums;
  std::vector<std::pair<int, int>> changes;  // at a tick: so many more wait for a vehicle
  for (std::size_t i = 0; i < spec.jobs.size(); ++i) {
    const JobRecord& record = result.records[i];
    if (spec.jobs[i].arrives > result.ticks) continue;
    changes.emplace_back(spec.jobs[i].arrives, 1);
    if (record.taken < 0) continue;
    changes.emplace_back(record.taken, -1);
    ++sums.taken;
    sums.queued += record.taken - spec.jobs[i].arrives;
    if (record.delivered < 0) continue;
    ++sums.delivered;
    sums.under_way += record.delivered - record.taken;
    sums.longest = std::max(sums.longest, record.delivered - record.taken);
  }
  // Who is taken in the tick in which it arrives has not waited: -1 comes before 1.
  std::sort(changes.begin(), changes.end());
  int queue = 0;
  for (std::size_t i = 0; i < changes.size(); ++i) {
    queue += changes[i].second;
    const bool is_last = i + 1 == changes.size() || changes[i + 1].first != changes[i].first;
    if (is_last) sums.longest_queue = std::max(sums.longest_queue, queue);
  }
  return sums;
}

const char* jobs_outcome(const JobsResult& result) {
  return result.end == JobsResult::End::done ? "done" : "standstill";
}

double per_hour(std::int64_t jobs, const GridSpec& spec, const JobsResult& result) {
  return result.ticks == 0 ? 0 : 3600.0 * static_cast<double>(jobs) / (result.ticks * spec.tick);
}

}  // namespace

std::string jobs_table(const GridSpec& spec, const JobsResult& result) {
  const JobSums sums = sums_of(spec, result);
  std::string text = fmt::format("network {}: {} agents on {} x {} cells, {} jobs\n", spec.name,
                                 spec.problem.agents.size(), spec.problem.map.columns,
                                 spec.problem.map.rows, spec.jobs.size());
  if (result.end == JobsResult::End::standstill) {
    text += "standstill: for a long time no job has got on; agents with a job: ";
    for (std::size_t i = 0; i < result.stuck.size() && i < kNamedStuck; ++i) {
      text += (i == 0 ? "" : ", ") +
              spec.problem.agents[static_cast<std::size_t>(result.stuck[i])].name;
    }
    if (result.stuck.size() > kNamedStuck) {
      text += fmt::format(" and {} more", result.stuck.size() - kNamedStuck);
    }
    text += "\n";
  }
  text += fmt::format("delivered  {} jobs in {} ticks of {:g} s: {:.0f} per hour\n", sums.delivered,
                      result.ticks, spec.tick, per_hour(sums.delivered, spec, result));
  text += fmt::format("a job      {:.1f} ticks from taken to delivered, {} at most\n",
                      mean(sums.under_way, sums.delivered), sums.longest);
  text += fmt::format("queue      {:.1f} ticks from arrived to taken; {} jobs at most\n",
                      mean(sums.queued, sums.taken), sums.longest_queue);
  text += fmt::format(
      "agents     had a job {:.1f} % of the time; of that they stood late {:.1f} %, waited for "
      "others {:.1f} %; shortest ways {:.1f} %\n",
      share(result.with_job, static_cast<std::int64_t>(spec.problem.agents.size()) * result.ticks),
      share(result.stood, result.with_job), share(result.waited, result.with_job),
      share(result.least, result.with_job));
  if (!result.stands.empty()) {
    text += fmt::format("late       {} of {} moves\n", result.stands.size(), result.moves);
  }
  return text + fmt::format("work       {} expansions\n", result.expansions);
}

std::string jobs_csv(const GridSpec& spec, const JobsResult& result) {
  std::string text = "job,from_x,from_y,to_x,to_y,arrives,agent,taken,picked,delivered\n";
  const auto tick = [](int value) { return value < 0 ? std::string() : std::to_string(value); };
  for (std::size_t i = 0; i < spec.jobs.size(); ++i) {
    const grid::GridJob& job = spec.jobs[i];
    const JobRecord& record = result.records[i];
    text += fmt::format("{},{},{},{},{},{},{},{},{},{}\n", job.name, job.from.x, job.from.y,
                        job.to.x, job.to.y, job.arrives,
                        record.vehicle < 0
                            ? ""
                            : spec.problem.agents[static_cast<std::size_t>(record.vehicle)].name,
                        tick(record.taken), tick(record.picked), tick(record.delivered));
  }
  return text;
}

std::string job_agents_csv(const GridSpec& spec, const JobsResult& result) {
  const std::size_t count = spec.problem.agents.size();
  std::vector<std::int64_t> jobs(count, 0), with_job(count, 0), late(count, 0);
  for (const JobRecord& record : result.records) {
    if (record.taken < 0) continue;
    const auto agent = static_cast<std::size_t>(record.vehicle);
    if (record.delivered >= 0) ++jobs[agent];
    with_job[agent] += (record.delivered < 0 ? result.ticks : record.delivered) - record.taken;
  }
  for (const grid::Stand& stand : result.stands) {
    late[static_cast<std::size_t>(stand.vehicle)] += stand.ticks;
  }
  std::string text = "agent,jobs,ticks,with_job,use,moves,late_ticks\n";
  for (std::size_t i = 0; i < count; ++i) {
    const std::string& way = result.ways[i];
    const auto moves =
        static_cast<std::int64_t>(way.size()) - std::count(way.begin(), way.end(), 'w');
    text += fmt::format("{},{},{},{},{:.4f},{},{}\n", spec.problem.agents[i].name, jobs[i],
                        result.ticks, with_job[i], share(with_job[i], result.ticks) / 100, moves,
                        late[i]);
  }
  return text;
}

std::string jobs_json(const GridSpec& spec, const JobsResult& result) {
  using Json = nlohmann::ordered_json;
  const JobSums sums = sums_of(spec, result);
  Json json;
  json["format"] = "rubicon-jobs";
  json["version"] = 1;
  json["network"] = spec.name;
  json["outcome"] = jobs_outcome(result);
  json["tick_s"] = spec.tick;
  json["ticks"] = result.ticks;
  json["delivered"] = sums.delivered;
  json["jobs_per_hour"] = per_hour(sums.delivered, spec, result);
  json["moves"] = result.moves;
  json["with_job"] = result.with_job;
  json["stood"] = result.stood;
  json["waited"] = result.waited;
  json["least"] = result.least;
  json["longest_queue"] = sums.longest_queue;
  json["expansions"] = result.expansions;
  json["seed"] = spec.job_query.seed;
  json["window"] = spec.job_query.window;
  json["late"] = spec.job_query.late;
  json["late_ticks"] = spec.job_query.late_ticks;
  json["map"] = grid_map_json(spec);
  Json agents = Json::array();
  for (std::size_t i = 0; i < spec.problem.agents.size(); ++i) {
    const grid::GridAgent& agent = spec.problem.agents[i];
    agents.push_back({{"name", agent.name},
                      {"from", {agent.from.x, agent.from.y}},
                      {"home", {agent.to.x, agent.to.y}},
                      {"way", result.ways[i]}});
  }
  json["agents"] = std::move(agents);
  Json jobs = Json::array();
  for (std::size_t i = 0; i < spec.jobs.size(); ++i) {
    const grid::GridJob& job = spec.jobs[i];
    const JobRecord& record = result.records[i];
    Json each = {{"name", job.name},
                 {"from", {job.from.x, job.from.y}},
                 {"to", {job.to.x, job.to.y}},
                 {"arrives", job.arrives}};
    if (record.taken >= 0) {
      each["agent"] = spec.problem.agents[static_cast<std::size_t>(record.vehicle)].name;
      each["taken"] = record.taken;
    }
    if (record.picked >= 0) each["picked"] = record.picked;
    if (record.delivered >= 0) each["delivered"] = record.delivered;
    jobs.push_back(std::move(each));
  }
  json["jobs"] = std::move(jobs);
  Json late = Json::array();
  for (const grid::Stand& stand : result.stands) {
    late.push_back({{"agent", spec.problem.agents[static_cast<std::size_t>(stand.vehicle)].name},
                    {"tick", stand.tick},
                    {"ticks", stand.ticks}});
  }
  json["late_moves"] = std::move(late);
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace rubicon::report
