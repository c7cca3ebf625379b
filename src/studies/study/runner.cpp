#include "src/studies/study/runner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <utility>

#include "src/simulation/taskplan/run_plan.hpp"

namespace rubicon::study {

namespace {

constexpr std::int64_t kMostRunsAtOnce = 64;

/// Whether the rule that ends the runs of a variant is met by those that were made.
bool is_met(const Condition& until, const VariantRuns& variant) {
  const auto width =
      value_of(until.statistic, variant.values[static_cast<std::size_t>(until.statistic.question)]);
  return width && until.holds(*width, until.limit);
}

/// The runs of a study, handed out to threads. Variants are opened in order, as many at a time as
/// there are threads, so that the memory for plans is bounded.
class Runner {
 public:
  Runner(const StudyModel& study, const std::vector<interpreter::ParameterTexts>& variants,
         const RunnerOptions& options)
      : study_(study), options_(options), results_(variants.size()), open_(variants.size()) {
    for (std::size_t i = 0; i < variants.size(); ++i) results_[i].set = variants[i];
    for (const LoggedRun& each : options.known) {
      const std::size_t variant = each.variant - options.first_variant;
      if (variant < open_.size()) open_[variant].known.push_back(&each);
    }
    planned_ = static_cast<std::int64_t>(variants.size()) * study.most_runs;
  }

  std::optional<std::vector<VariantRuns>> run() {
    std::vector<std::thread> threads;
    for (int i = 1; i < options_.threads; ++i) threads.emplace_back([this] { work(); });
    work();
    for (std::thread& each : threads) each.join();
    if (failure_) std::rethrow_exception(failure_);
    if (stopped_) return std::nullopt;
    return std::move(results_);
  }

 private:
  /// A variant while its runs are made.
  struct Open {
    enum class State : std::uint8_t { waiting, loading, running, done };
    State state = State::waiting;
    std::shared_ptr<const LoadedVariant> loaded;
    std::vector<const LoggedRun*> known;
    std::vector<bool> made;     ///< by run: handed out or known
    std::int64_t next = 0;      ///< no run before it is to be handed out
    std::int64_t planned = 0;   ///< runs until the next look at the rule
    std::int64_t finished = 0;  ///< of these
  };
  struct Piece {
    std::size_t variant = 0;
    std::vector<std::int64_t> runs;
    std::shared_ptr<const LoadedVariant> loaded;
    bool load = false;
  };

  void work() {
    try {
      std::size_t own_variant = results_.size();
      std::unique_ptr<interpreter::PlanModel> own;  // drawn durations are written into it
      while (const auto piece = next_piece()) {
        if (piece->load) {
          load(piece->variant);
          continue;
        }
        if (piece->variant != own_variant) {
          own = std::make_unique<interpreter::PlanModel>(*piece->loaded->plan);
          own_variant = piece->variant;
        }
        make(*piece, *own);
      }
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
      stop();
    }
  }

  void stop() {
    stopped_ = true;
    changed_.notify_all();
  }

  std::optional<Piece> next_piece() {
    std::unique_lock lock(mutex_);
    while (true) {
      if (stopped_) return std::nullopt;
      while (first_ < open_.size() && open_[first_].state == Open::State::done) ++first_;
      if (first_ == open_.size()) return std::nullopt;
      int busy = 0;
      for (std::size_t i = first_; i < open_.size() && busy < options_.threads; ++i) {
        Open& each = open_[i];
        if (each.state == Open::State::done) continue;
        ++busy;
        if (each.state == Open::State::waiting) {
          each.state = Open::State::loading;
          Piece piece;
          piece.variant = i;
          piece.load = true;
          return piece;
        }
        if (each.state == Open::State::running) {
          if (auto piece = take_runs(i)) return piece;
        }
      }
      changed_.wait(lock);
    }
  }

  std::optional<Piece> take_runs(std::size_t variant) {
    Open& each = open_[variant];
    const std::int64_t left = each.planned - each.next;
    const std::int64_t most =
        std::clamp<std::int64_t>(left / (4 * options_.threads), 1, kMostRunsAtOnce);
    Piece piece;
    piece.variant = variant;
    piece.loaded = each.loaded;
    while (each.next < each.planned && static_cast<std::int64_t>(piece.runs.size()) < most) {
      const auto run = static_cast<std::size_t>(each.next++);
      if (each.made[run]) continue;
      each.made[run] = true;
      piece.runs.push_back(static_cast<std::int64_t>(run));
    }
    if (piece.runs.empty()) return std::nullopt;
    return piece;
  }

  void load(std::size_t variant) {
    auto loaded = std::make_shared<LoadedVariant>(options_.load(options_.first_variant + variant));
    const std::lock_guard lock(mutex_);
    Open& each = open_[variant];
    VariantRuns& result = results_[variant];
    if (options_.on_load && !options_.on_load(options_.first_variant + variant, *loaded)) {
      stop();
      return;
    }
    if (!loaded->plan) {
      fail(variant, loaded->fault);
      return;
    }
    result.describe(*loaded->plan);
    each.loaded = std::move(loaded);
    each.state = Open::State::running;
    plan_more(variant);
  }

  void fail(std::size_t variant, const std::string& fault) {
    results_[variant].fault = fault;
    planned_ -= study_.most_runs - open_[variant].finished;
    close(variant);
  }

  void close(std::size_t variant) {
    open_[variant].state = Open::State::done;
    open_[variant].loaded.reset();
    open_[variant].made = {};
    changed_.notify_all();
  }

  /// So many more runs as there are before the next look at the rule; takes those that are known.
  void plan_more(std::size_t variant) {
    Open& each = open_[variant];
    VariantRuns& result = results_[variant];
    each.planned = study_.until ? std::min(study_.most_runs, each.planned + kRunsBetweenLooks)
                                : study_.most_runs;
    each.made.resize(static_cast<std::size_t>(each.planned), false);
    result.resize(study_, each.planned);
    std::int64_t taken = 0;
    for (const LoggedRun* known : each.known) {
      if (known->run >= each.planned || each.made[static_cast<std::size_t>(known->run)] ||
          !result.fits(known->record)) {
        continue;
      }
      each.made[static_cast<std::size_t>(known->run)] = true;
      result.take(known->run, known->record);
      ++taken;
    }
    changed_.notify_all();
    count(variant, taken);
  }

  void count(std::size_t variant, std::int64_t runs) {
    Open& each = open_[variant];
    each.finished += runs;
    done_ += runs;
    if (options_.on_progress) options_.on_progress(done_, planned_);
    if (each.finished < each.planned || each.state != Open::State::running) return;
    const bool enough = each.planned == study_.most_runs ||
                        (study_.until && is_met(*study_.until, results_[variant]));
    if (!enough) {
      plan_more(variant);
      return;
    }
    planned_ -= study_.most_runs - each.planned;
    close(variant);
  }

  void make(const Piece& piece, interpreter::PlanModel& plan) {
    std::vector<LoggedRun> made;
    std::string fault;
    for (const std::int64_t run : piece.runs) {
      if (study_.sampled) {
        draw_durations(plan, {study_.seed, static_cast<std::uint64_t>(run)});
      }
      try {
        const taskplan::Schedule schedule = taskplan::run_plan(plan, piece.loaded->sources, nullptr,
                                                               {trace::TraceDetail::none, {}, {}});
        made.push_back({options_.first_variant + piece.variant, run,
                        record_of(study_, plan, schedule, run < kCurves)});
      } catch (const std::invalid_argument& error) {
        fault = error.what();
        break;
      }
    }
    const std::lock_guard lock(mutex_);
    if (open_[piece.variant].state == Open::State::done) return;
    if (!fault.empty()) {
      fail(piece.variant, fault);
      return;
    }
    VariantRuns& result = results_[piece.variant];
    for (const LoggedRun& each : made) {
      result.take(each.run, each.record);
      if (options_.on_run && !options_.on_run(each)) {
        stop();
        return;
      }
    }
    count(piece.variant, static_cast<std::int64_t>(made.size()));
  }

  const StudyModel& study_;
  const RunnerOptions& options_;
  std::vector<VariantRuns> results_;
  std::mutex mutex_;  ///< of what follows, and of results_
  std::condition_variable changed_;
  std::vector<Open> open_;
  std::size_t first_ = 0;  ///< no variant before it is open
  std::int64_t done_ = 0;
  std::int64_t planned_ = 0;
  bool stopped_ = false;
  std::exception_ptr failure_;
};

}  // namespace

std::optional<std::vector<VariantRuns>> run_study(
    const StudyModel& study, const std::vector<interpreter::ParameterTexts>& variants,
    const RunnerOptions& options) {
  return Runner(study, variants, options).run();
}

void check_names(const StudyModel& study, const interpreter::PlanModel& plan,
                 interpreter::Diagnostics& diagnostics) {
  if (study.choice && !plan.start_at) {
    for (const Condition& each : study.choice->with) {
      if (!each.date) continue;
      diagnostics.error("U11", each.statistic.span,
                        "the limit is a date, and the plan does not say when it begins",
                        "start_at \"2026-03-02 07:00\"; in the plan, or a limit such as 30 h");
    }
  }
  const auto look = [&](const Question& question, const char* what,
                        const std::vector<std::string>& names) {
    if (std::find(names.begin(), names.end(), question.of) != names.end()) return;
    const std::string near = interpreter::did_you_mean(question.of, names);
    diagnostics.error("U11", question.span,
                      fmt::format("the plan has no {} '{}'{}", what, question.of,
                                  near.empty() ? "" : "; did you mean " + near + "?"));
  };
  std::vector<std::string> tasks;
  std::vector<std::string> digs;
  for (const auto& each : plan.tasks) {
    tasks.push_back(each.name);
    const auto digs_soil = [](const interpreter::TaskSpec& task) {
      return task.dig || task.motion_dig;
    };
    const bool by_choice = !each.choices.empty() && digs_soil(each.choices.front());
    if (digs_soil(each) || by_choice) digs.push_back(each.name);
  }
  std::vector<std::string> resources;
  for (const auto& each : plan.robots) resources.push_back(each.name);
  for (const auto& each : plan.crews) resources.push_back(each.name);
  for (const Question& each : study.questions) {
    if (each.asked == Asked::utilisation) look(each, "robot or crew", resources);
    const bool task = each.asked == Asked::task_start || each.asked == Asked::task_finish ||
                      each.asked == Asked::task_duration;
    if (task) look(each, "task", tasks);
    const bool dig = each.asked == Asked::production || each.asked == Asked::unit_cost;
    if (dig) look(each, "task that digs", digs);
  }
}

}  // namespace rubicon::study
