#include "src/studies/study/runner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

namespace rubicon::study {

namespace {

constexpr std::int64_t kMostRunsAtOnce = 64;
constexpr const char* kNotAsked = "what it answers is not what was asked";

/// Whether the rule that ends the runs of a variant is met by those that were made.
bool is_met(const Condition& until, const VariantRuns& variant) {
  const auto width =
      value_of(until.statistic, variant.values[static_cast<std::size_t>(until.statistic.question)]);
  return width && until.holds(*width, until.limit);
}

/// The runs of a study, handed out to threads and to remote workers. Variants are opened in order,
/// as many at a time as pieces are worked on, so that the memory for plans is bounded.
class Runner : private Work {
 public:
  Runner(const StudyModel& study, const std::vector<interpreter::ParameterTexts>& variants,
         const RunnerOptions& options)
      : study_(study),
        options_(options),
        places_(options.threads + (options.remote ? options.remote->places() : 0)),
        read_(options.read, static_cast<std::size_t>(options.threads) + 1),
        results_(variants.size()),
        open_(variants.size()) {
    for (std::size_t i = 0; i < variants.size(); ++i) results_[i].set = variants[i];
    for (const LoggedRun& each : options.known) {
      const std::size_t variant = each.variant - options.first_variant;
      if (variant < open_.size()) open_[variant].known.push_back(&each);
    }
    planned_ = static_cast<std::int64_t>(variants.size()) * study.most_runs;
  }

  std::optional<std::vector<VariantRuns>> run() {
    std::vector<std::thread> threads;
    const int own = options_.remote ? options_.threads : options_.threads - 1;
    for (int i = 0; i < own; ++i) threads.emplace_back([this] { work_here(); });
    if (!options_.remote) {
      work_here();
    } else if (!options_.remote->serve(*this)) {
      const std::lock_guard lock(mutex_);
      stop();
    }
    for (std::thread& each : threads) each.join();
    if (failure_) std::rethrow_exception(failure_);
    if (stopped_) return std::nullopt;
    return std::move(results_);
  }

 private:
  /// A variant while its runs are made.
  struct Open {
    enum class State : std::uint8_t { waiting, opening, running, done };
    State state = State::waiting;
    std::string digest;  ///< of what it was read from
    std::vector<const LoggedRun*> known;
    std::vector<bool> made;     ///< by run: handed out or known
    std::int64_t next = 0;      ///< no run before it is to be handed out
    std::int64_t planned = 0;   ///< runs until the next look at the rule
    std::int64_t finished = 0;  ///< of these
  };

  void work_here() {
    try {
      Worker worker(study_, read_);
      while (const auto piece = wait_for_piece()) done(*piece, worker.work(*piece));
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

  std::optional<Piece> wait_for_piece() {
    std::unique_lock lock(mutex_);
    while (!over()) {
      if (auto piece = next_piece()) return piece;
      changed_.wait(lock);
    }
    return std::nullopt;
  }

  std::optional<Piece> take() override {
    const std::lock_guard lock(mutex_);
    return over() ? std::nullopt : next_piece();
  }

  bool is_over() const override {
    const std::lock_guard lock(mutex_);
    return over();
  }

  // From here on with the lock held.
  bool over() const {
    return stopped_ ||
           std::all_of(open_.begin() + static_cast<std::ptrdiff_t>(first_), open_.end(),
                       [](const Open& each) { return each.state == Open::State::done; });
  }

  std::optional<Piece> next_piece() {
    while (first_ < open_.size() && open_[first_].state == Open::State::done) ++first_;
    int busy = 0;
    for (std::size_t i = first_; i < open_.size() && busy < places_; ++i) {
      Open& each = open_[i];
      if (each.state == Open::State::done) continue;
      ++busy;
      if (each.state == Open::State::waiting) {
        each.state = Open::State::opening;
        return Piece{options_.first_variant + i, results_[i].set, {}};
      }
      if (each.state == Open::State::running) {
        if (auto piece = take_runs(i)) return piece;
      }
    }
    return std::nullopt;
  }

  std::optional<Piece> take_runs(std::size_t variant) {
    Open& each = open_[variant];
    const std::int64_t left = each.planned - each.next;
    const std::int64_t most =
        std::clamp<std::int64_t>(left / (std::int64_t{4} * places_), 1, kMostRunsAtOnce);
    Piece piece{options_.first_variant + variant, results_[variant].set, {}};
    while (each.next < each.planned && static_cast<std::int64_t>(piece.runs.size()) < most) {
      const auto run = static_cast<std::size_t>(each.next++);
      if (each.made[run]) continue;
      each.made[run] = true;
      piece.runs.push_back(static_cast<std::int64_t>(run));
    }
    if (piece.runs.empty()) return std::nullopt;
    return piece;
  }

  void give_back(const Piece& piece) override {
    const std::lock_guard lock(mutex_);
    Open& each = open_[piece.variant - options_.first_variant];
    if (each.state == Open::State::done) return;
    if (piece.runs.empty()) each.state = Open::State::waiting;
    for (const std::int64_t run : piece.runs) {
      each.made[static_cast<std::size_t>(run)] = false;
      each.next = std::min(each.next, run);
    }
    changed_.notify_all();
  }

  std::string complaint(const Piece& piece, const PieceResult& result) const override {
    const std::lock_guard lock(mutex_);
    const std::size_t variant = piece.variant - options_.first_variant;
    if (piece.runs.empty()) {
      const bool right = result.runs.empty() && result.facts.has_value() == result.fault.empty();
      return right ? "" : kNotAsked;
    }
    if (open_[variant].digest != result.digest) return "what it reads of the plan is different";
    if (!result.fault.empty()) return "";
    if (result.runs.size() != piece.runs.size()) return kNotAsked;
    for (std::size_t i = 0; i < piece.runs.size(); ++i) {
      const LoggedRun& each = result.runs[i];
      const bool same = each.variant == piece.variant && each.run == piece.runs[i];
      if (!same || !results_[variant].fits(each.record)) return kNotAsked;
    }
    return "";
  }

  void done(const Piece& piece, const PieceResult& result) override {
    const std::lock_guard lock(mutex_);
    const std::size_t variant = piece.variant - options_.first_variant;
    if (open_[variant].state == Open::State::done) return;
    if (piece.runs.empty()) {
      opened(variant, result);
      return;
    }
    if (!result.fault.empty()) {
      fail(variant, result.fault);
      return;
    }
    for (const LoggedRun& each : result.runs) {
      results_[variant].take(each.run, each.record);
      if (options_.on_run && !options_.on_run(each)) {
        stop();
        return;
      }
    }
    count(variant, static_cast<std::int64_t>(result.runs.size()));
  }

  void opened(std::size_t variant, const PieceResult& result) {
    Open& each = open_[variant];
    each.digest = result.digest;
    if (options_.on_load && !options_.on_load(options_.first_variant + variant, result.digest)) {
      stop();
      return;
    }
    if (!result.fault.empty()) {
      fail(variant, result.fault);
      return;
    }
    static_cast<VariantFacts&>(results_[variant]) = *result.facts;
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
    open_[variant].made = {};
    read_.forget(options_.first_variant + variant);
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

  const StudyModel& study_;
  const RunnerOptions& options_;
  int places_;  ///< pieces that are worked on at a time
  OpenVariants read_;
  std::vector<VariantRuns> results_;
  mutable std::mutex mutex_;  ///< of what follows, and of results_
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
