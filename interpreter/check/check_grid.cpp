#include "interpreter/check/check_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "interpreter/check/check_number.hpp"
#include "interpreter/parse/parse_grid.hpp"
#include "src/motion/math/index.hpp"

namespace rubicon::interpreter {

namespace {

using math::at;

/// Most expansions of a run: some hours. Most of a seed, so that each is exact as a number.
constexpr double kMostExpansions = 1e11;
constexpr double kMostSeed = 1e15;
/// Most jobs, ticks at which one arrives, ticks between two.
constexpr double kMostJobs = 1e6, kMostArrival = 1e8, kMostInterval = 1e5;
/// Faults of agents that are listed.
constexpr std::size_t kListed = 20;

class GridCheck {
 public:
  GridCheck(const syntax::GridItem& item, const std::string& plan_path, SourceMap& sources,
            FileProvider& files, Diagnostics& diagnostics)
      : item_(item),
        plan_path_(plan_path),
        sources_(sources),
        files_(files),
        diagnostics_(diagnostics),
        who_("network '" + item.network.text + "'") {}

  std::optional<GridSpec> run() {
    const int errors = diagnostics_.errors();
    spec_.name = item_.network.text;
    for (const Span& span : item_.in_blocks) {
      wrong(span, "what makes a grid stands outside of for and when");
    }
    has_jobs_ = !item_.jobs.empty() || !item_.named_jobs.empty();
    for (const syntax::NumberItem& number : item_.numbers) take(number);
    if (diagnostics_.errors() != errors || !read_map() || !read_scenario()) return std::nullopt;
    for (const syntax::GridItem::Agent& agent : item_.named) take(agent);
    if (spec_.problem.agents.empty() && diagnostics_.errors() == errors) {
      diagnostics_.warning("P57", item_.network.span, who_ + " has no agents: nothing will be done",
                           "write scenario \"FILE.scen\"; or agent NAME from (0, 0) to (4, 2);");
    }
    if (diagnostics_.errors() != errors) return std::nullopt;
    report_faults();
    if (diagnostics_.errors() != errors) return std::nullopt;
    if (has_jobs_) take_jobs();
    if (diagnostics_.errors() != errors) return std::nullopt;
    return std::move(spec_);
  }

 private:
  void wrong(Span span, std::string message, std::string hint = {}) {
    diagnostics_.error("P57", span, std::move(message), std::move(hint));
  }

  /// A whole number within bounds.
  std::optional<double> whole(const syntax::Number& number, const std::string& what, double least,
                              double most) {
    if (number.expression) {
      wrong(number.span, what + " is a number that is written out");
      return std::nullopt;
    }
    if (!check_unit(number, syntax::UnitKind::none, what, diagnostics_)) return std::nullopt;
    if (number.value >= least && number.value <= most && std::floor(number.value) == number.value) {
      return number.value;
    }
    diagnostics_.error("P09", number.span,
                       fmt::format("{} is a whole number of {:.0f} to {:.0f}, found {:g}", what,
                                   least, most, number.value));
    return std::nullopt;
  }

  bool first(const std::string& key, Span span) {
    const auto [place, is_new] = given_.emplace(key, span);
    if (is_new) return true;
    Diagnostic diagnostic;
    diagnostic.code = "P02";
    diagnostic.span = span;
    diagnostic.message = fmt::format("{} of {} is given twice", key, who_);
    diagnostic.notes.push_back({place->second, "given here first"});
    diagnostics_.add(std::move(diagnostic));
    return false;
  }

  void take(const syntax::NumberItem& item) {
    const std::string& key = item.name.text;
    const bool is_of_jobs = key == "window" || key == "interval" || key == "tick" ||
                            key == "late" || key == "late_ticks";
    if (key != "expansions" && key != "seed" && !is_of_jobs) {
      wrong(item.name.span,
            fmt::format("expected expansions, seed, window, interval, tick, late or late_ticks, "
                        "found '{}'",
                        key),
            "policy grid { expansions 1000000; seed 7; }");
      return;
    }
    if (!first(key, item.name.span)) return;
    if (is_of_jobs) {
      take_of_jobs(key, item);
      return;
    }
    const bool is_seed = key == "seed";
    const auto value = whole(item.value, is_seed ? "the seed" : "the number of expansions",
                             is_seed ? 0 : 1, is_seed ? kMostSeed : kMostExpansions);
    if (!value) return;
    if (is_seed) {
      spec_.query.seed = static_cast<std::uint64_t>(*value);
    } else {
      spec_.query.expansions = static_cast<std::int64_t>(*value);
    }
  }

  /// A number within bounds.
  std::optional<double> real(const syntax::Number& number, syntax::UnitKind unit,
                             const std::string& what, double least, double most) {
    if (number.expression) {
      wrong(number.span, what + " is a number that is written out");
      return std::nullopt;
    }
    if (!check_unit(number, unit, what, diagnostics_)) return std::nullopt;
    if (number.value >= least && number.value <= most) return number.value;
    diagnostics_.error(
        "P09", number.span,
        fmt::format("{} is {:g} to {:g}, found {:g}", what, least, most, number.value));
    return std::nullopt;
  }

  void take_of_jobs(const std::string& key, const syntax::NumberItem& item) {
    if (!has_jobs_) {
      wrong(item.name.span, key + " goes with jobs, and there are none", "write jobs 1000;");
      return;
    }
    using syntax::UnitKind;
    if (key == "window") {
      const auto value = whole(item.value, "the window", 2, grid::kLongestWindow);
      if (value) spec_.job_query.window = static_cast<int>(*value);
    } else if (key == "late_ticks") {
      const auto value = whole(item.value, "late_ticks", 1, grid::kLongestStand);
      if (value) spec_.job_query.late_ticks = static_cast<int>(*value);
    } else if (key == "late") {
      const auto value = real(item.value, UnitKind::none, "the share of moves that end late", 0, 1);
      if (value) spec_.job_query.late = *value;
    } else if (key == "interval") {
      const auto value =
          real(item.value, UnitKind::none, "the ticks between two jobs", 0, kMostInterval);
      if (value) interval_ = *value;
    } else {
      const auto value = real(item.value, UnitKind::time, "a tick", 1e-3, 3600);
      if (value) spec_.tick = *value;
    }
  }

  const syntax::GridItem::File* file_of(const char* key) {
    const syntax::GridItem::File* found = nullptr;
    for (const syntax::GridItem::File& file : item_.files) {
      if (file.key.text == key && first(key, file.key.span)) found = &file;
    }
    return found;
  }

  /// The text of a file that the plan names, and which it is.
  std::optional<FileId> read(const syntax::GridItem::File& file) {
    const std::string path = resolve_path(plan_path_, file.file.text);
    std::variant<std::string, FileFailure> text = files_.read_text(path);
    if (const auto* failure = std::get_if<FileFailure>(&text)) {
      diagnostics_.error(
          "F01", file.file.span,
          fmt::format("{} '{}': {}", file.key.text, file.file.text, failure->message));
      return std::nullopt;
    }
    return sources_.add(path, std::get<std::string>(std::move(text)));
  }

  void wrong_in(FileId file, const grid::TextFault& fault) {
    wrong({file, static_cast<std::uint32_t>(fault.begin), static_cast<std::uint32_t>(fault.end)},
          fault.message, fault.hint);
  }

  bool read_map() {
    const syntax::GridItem::File* file = file_of("map");
    if (file == nullptr) {
      wrong(item_.network.span, who_ + " has no map", "write map \"FILE.map\";");
      return false;
    }
    spec_.map = file->file.text;
    const auto id = read(*file);
    if (!id) return false;
    auto map = grid::read_map(sources_.file(*id).text);
    if (const auto* fault = std::get_if<grid::TextFault>(&map)) {
      wrong_in(*id, *fault);
      return false;
    }
    spec_.problem.map = std::get<grid::GridMap>(std::move(map));
    return true;
  }

  bool read_scenario() {
    std::size_t most = grid::kMostAgents + 1;
    bool has_count = false;
    for (const syntax::Number& number : item_.agents) {
      if (!first("agents", number.span)) continue;
      const auto count = whole(number, "the number of agents", 1, grid::kMostAgents);
      if (!count) return false;
      most = static_cast<std::size_t>(*count);
      has_count = true;
    }
    const syntax::GridItem::File* file = file_of("scenario");
    if (file == nullptr) {
      if (has_count) {
        wrong(item_.agents.front().span, "agents says how many of a scenario, and there is none",
              "write scenario \"FILE.scen\";");
      }
      return !has_count;
    }
    spec_.scenario = file->file.text;
    const auto id = read(*file);
    if (!id) return false;
    const auto trips = grid::read_scenario(sources_.file(*id).text, spec_.problem.map, most);
    if (const auto* fault = std::get_if<grid::TextFault>(&trips)) {
      wrong_in(*id, *fault);
      return false;
    }
    for (const grid::Trip& trip : std::get<std::vector<grid::Trip>>(trips)) {
      spec_.problem.agents.push_back(
          {fmt::format("a{}", spec_.problem.agents.size() + 1), trip.from, trip.to});
      spans_.push_back(
          {*id, static_cast<std::uint32_t>(trip.begin), static_cast<std::uint32_t>(trip.end)});
      names_.emplace(spec_.problem.agents.back().name, spans_.back());
    }
    if (has_count && spans_.size() < most) {
      wrong(item_.agents.front().span,
            fmt::format("scenario '{}' has {} agents; expected {} at least", spec_.scenario,
                        spans_.size(), most));
      return false;
    }
    return true;
  }

  std::optional<grid::Cell> cell(const syntax::FloorPlace& place) {
    const auto x = whole(place.x, "the column of a cell", 0, grid::kMostCells);
    const auto y = whole(place.y, "the row of a cell", 0, grid::kMostCells);
    if (!x || !y) return std::nullopt;
    return grid::Cell{static_cast<int>(*x), static_cast<int>(*y)};
  }

  void take(const syntax::GridItem::Agent& agent) {
    const auto [place, is_new] = names_.emplace(agent.name.text, agent.name.span);
    if (!is_new) {
      Diagnostic diagnostic;
      diagnostic.code = "P02";
      diagnostic.span = agent.name.span;
      diagnostic.message = fmt::format("agent '{}' is declared twice", agent.name.text);
      diagnostic.notes.push_back({place->second, "declared here first"});
      diagnostics_.add(std::move(diagnostic));
      return;
    }
    const auto from = cell(agent.from), to = cell(agent.to);
    if (!from || !to) return;
    spec_.problem.agents.push_back({agent.name.text, *from, *to});
    spans_.push_back(agent.span);
  }

  /// Those that are drawn, then those of the plan.
  void take_jobs() {
    grid::JobQuery& query = spec_.job_query;
    query.seed = spec_.query.seed;
    if (given_.count("expansions") != 0) query.expansions = spec_.query.expansions;
    for (const char* each : {"late", "late_ticks"}) {
      const char* other = each == std::string("late") ? "late_ticks" : "late";
      if (given_.count(each) != 0 && given_.count(other) == 0) {
        wrong(given_.at(each), fmt::format("{} is given, and {} is not", each, other),
              "write both: late 0.05; late_ticks 20;");
      }
    }
    for (const syntax::Number& number : item_.jobs) {
      if (!first("jobs", number.span)) continue;
      const auto count = whole(number, "the number of jobs", 1, kMostJobs);
      if (!count) return;
      spec_.jobs =
          grid::draw_jobs(spec_.problem, static_cast<std::size_t>(*count), interval_, query.seed);
      if (spec_.jobs.empty() && !spec_.problem.agents.empty()) {
        wrong(number.span, "jobs need two cells that the agents can reach");
      }
    }
    std::map<std::string, Span> names;
    const std::size_t drawn = spec_.jobs.size();
    for (const grid::GridJob& job : spec_.jobs) names.emplace(job.name, item_.jobs.front().span);
    std::vector<Span> spans;
    for (const syntax::GridItem::Job& job : item_.named_jobs) {
      const auto [place, is_new] = names.emplace(job.name.text, job.name.span);
      if (!is_new) {
        diagnostics_.error("P02", job.name.span,
                           fmt::format("job '{}' is declared twice", job.name.text));
        continue;
      }
      const auto from = cell(job.from), to = cell(job.to);
      std::optional<double> arrives = 0.0;
      if (!job.arrives.empty()) {
        arrives = whole(job.arrives.front(), "the tick at which a job arrives", 0, kMostArrival);
      }
      if (!from || !to || !arrives) continue;
      spec_.jobs.push_back({job.name.text, *from, *to, static_cast<int>(*arrives)});
      spans.push_back(job.span);
    }
    const std::int64_t cells =
        std::count(spec_.problem.map.open.begin(), spec_.problem.map.open.end(), 1);
    if ((query.window + 1) * cells > grid::kMostInWindow) {
      wrong(item_.network.span,
            fmt::format("a window of {} ticks on {} open cells is too large; expected up to {} as "
                        "the product of both",
                        query.window, cells, grid::kMostInWindow));
      return;
    }
    if (2 * spec_.problem.agents.size() * static_cast<std::size_t>(cells) > grid::kMostPairs) {
      wrong(item_.network.span,
            fmt::format("{} agents on {} open cells are too many for jobs; expected up to {} as "
                        "the product of both",
                        spec_.problem.agents.size(), cells, grid::kMostPairs / 2));
      return;
    }
    std::size_t listed = 0;
    for (const grid::GridFault& fault : grid::faults_of_jobs(spec_.problem, spec_.jobs)) {
      if (++listed > kListed) break;
      const bool is_written = fault.agent >= static_cast<int>(drawn);
      wrong(is_written ? spans[at(fault.agent) - drawn] : item_.network.span, fault.message);
    }
  }

  void report_faults() {
    const std::vector<grid::GridFault> faults = grid::faults_of(spec_.problem);
    for (std::size_t i = 0; i < faults.size() && i < kListed; ++i) {
      const grid::GridFault& fault = faults[i];
      Diagnostic diagnostic;
      diagnostic.code = "P57";
      diagnostic.span = fault.agent < 0 ? item_.network.span : spans_[at(fault.agent)];
      diagnostic.message = fault.message;
      if (fault.other >= 0) diagnostic.notes.push_back({spans_[at(fault.other)], "the other one"});
      diagnostics_.add(std::move(diagnostic));
    }
    if (faults.size() > kListed) {
      wrong(item_.network.span,
            fmt::format("{} more agents of {} are wrong", faults.size() - kListed, who_));
    }
  }

  const syntax::GridItem& item_;
  const std::string& plan_path_;
  SourceMap& sources_;
  FileProvider& files_;
  Diagnostics& diagnostics_;
  std::string who_;
  GridSpec spec_;
  std::map<std::string, Span> given_, names_;
  std::vector<Span> spans_;  ///< by agent
  bool has_jobs_ = false;
  double interval_ = 0;
};

bool is_grid(const syntax::GridItem& item) {
  return std::any_of(item.policies.begin(), item.policies.end(),
                     [](const syntax::Name& policy) { return policy.text == "grid"; });
}

}  // namespace

std::optional<GridSpec> check_grid(const syntax::GridItem& item, const std::string& plan_path,
                                   SourceMap& sources, FileProvider& files,
                                   Diagnostics& diagnostics) {
  return GridCheck(item, plan_path, sources, files, diagnostics).run();
}

std::optional<GridSpec> load_grid(const std::string& path, SourceMap& sources, FileProvider& files,
                                  Diagnostics& diagnostics) {
  std::variant<std::string, FileFailure> text = files.read_text(path);
  // The word is not in most plans: they are not parsed for it.
  if (!std::holds_alternative<std::string>(text) ||
      std::get<std::string>(text).find("grid") == std::string::npos) {
    return std::nullopt;
  }
  const FileId file = sources.add(path, std::get<std::string>(std::move(text)));
  for (const syntax::GridItem& item : parse_grids(sources, file)) {
    if (is_grid(item)) return check_grid(item, path, sources, files, diagnostics);
  }
  return std::nullopt;
}

}  // namespace rubicon::interpreter
