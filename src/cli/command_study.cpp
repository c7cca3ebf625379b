#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <variant>
#include <vector>

#include "src/cli/commands.hpp"
#include "src/cli/fail.hpp"
#include "src/cli/load_study.hpp"
#include "src/cli/progress_line.hpp"
#include "src/cli/thread_count.hpp"
#include "src/exchange/encoding/sha256.hpp"
#include "src/exchange/files/append_file_io.hpp"
#include "src/exchange/files/result_folder_io.hpp"
#include "src/results/page/report_page.hpp"
#include "src/results/report/diagnostic_printer.hpp"
#include "src/simulation/schedule/time_text.hpp"
#include "src/studies/answers/study_answers.hpp"
#include "src/studies/answers/study_text.hpp"
#include "src/studies/cluster/hand_out.hpp"
#include "src/studies/cluster/mpi_channel_io.hpp"
#include "src/studies/search/optimiser_process_io.hpp"
#include "src/studies/search/search.hpp"

namespace rubicon::cli {

namespace {

using interpreter::SourceMap;

/// "1234/5000 runs, 0:03:20 left".
class StudyProgress {
 public:
  void show(std::int64_t done, std::int64_t planned) {
    if (first_ < 0) first_ = done;
    if (!line_.is_due()) return;
    const double seconds = line_.seconds();
    const auto made = static_cast<double>(done - first_);
    std::string left;
    if (seconds > 1 && made > 0) {
      const double rest = seconds / made * static_cast<double>(planned - done);
      left = ", " + schedule::clock_text(schedule::ticks_from_seconds(rest)) + " left";
    }
    line_.show(fmt::format("{}/{} runs{}", done, planned, left));
  }

 private:
  ProgressLine line_{std::chrono::milliseconds(200), std::chrono::milliseconds(200)};
  std::int64_t first_ = -1;
};

/// Digits behind each line of a progress file, of what stands before them.
constexpr std::size_t kSealDigits = 8;

std::string seal_of(std::string_view line) {
  return encoding::sha256_hex(line).substr(0, kSealDigits);
}

/// What was noted in a line; nothing of one that is damaged.
std::optional<std::string> unsealed(const std::string& line) {
  if (line.size() <= kSealDigits) return std::nullopt;
  const std::size_t tab = line.size() - kSealDigits - 1;
  std::string noted = line.substr(0, tab);
  if (line[tab] != '\t' || line.substr(tab + 1) != seal_of(noted)) return std::nullopt;
  return noted;
}

constexpr std::string_view kLogHead = "study\t";

/// Why a study must not keep its runs in this file: one of somebody else is there.
std::optional<std::string> not_ours(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return std::nullopt;
  std::string begin(kLogHead.size(), '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  // One that was stopped at once may have left less.
  begin.resize(static_cast<std::size_t>(file.gcount()));
  if (kLogHead.starts_with(begin)) return std::nullopt;
  return fmt::format(
      "'{}' is not from an earlier study, and this one would replace it: move it away, or write to "
      "another folder",
      path);
}

/// The runs that a study has made so far, in a file: what one that was stopped goes on from.
class StudyLog {
 public:
  StudyLog(files::AppendFile file, std::string digest)
      : file_(std::move(file)), head_(std::string(kLogHead) + std::move(digest) + "\t.") {}

  /// What is there already; a message if it is of another study.
  std::optional<std::string> read(const study::StudyModel& study, std::size_t variants) {
    const std::vector<std::string>& lines = file_.lines();
    if (!lines.empty() && unsealed(lines.front()) != head_) {
      return "the runs in this folder are of another study, or of another version of this one; "
             "without --resume it begins again";
    }
    for (const std::string& written : lines) {
      // A run whose line is damaged is made again.
      const std::optional<std::string> line = unsealed(written);
      if (!line) continue;
      if (auto run = study::read_line(*line, study.questions.size())) {
        if (run->variant < variants) known_.push_back(std::move(*run));
      } else if (line->starts_with("variant\t")) {
        const std::size_t tab = line->find('\t', 8);
        digests_[line->substr(8, tab - 8)] = *line;
      }
    }
    if (lines.empty()) append(head_);
    file_.forget_lines();
    return failure_;
  }

  std::vector<study::LoggedRun> take_known() { return std::move(known_); }

  /// False if it could not be written.
  bool append(const std::string& line) {
    if (!failure_) failure_ = file_.append(line + '\t' + seal_of(line));
    return !failure_;
  }

  /// Notes what a variant was read from; false if it was read from something else before.
  bool note(std::size_t variant, const std::string& digest) {
    const std::string number = fmt::format("{}", variant);
    const std::string line = fmt::format("variant\t{}\t{}\t.", number, digest);
    const auto known = digests_.find(number);
    if (known == digests_.end()) {
      return append(line);
    }
    if (known->second == line) return true;
    if (!failure_) {
      failure_ =
          "the plan or one of its files has changed since the runs in this folder were made; "
          "without --resume the study begins again";
    }
    return false;
  }

  const std::optional<std::string>& failure() const { return failure_; }
  void remove() { file_.remove(); }

 private:
  files::AppendFile file_;
  std::string head_;
  std::vector<study::LoggedRun> known_;
  std::map<std::string, std::string> digests_;  ///< the lines of variants, by number
  std::optional<std::string> failure_;
};

/// What --out asks for, made of what was read so far.
files::ResultTerms result_terms(const LoadedStudy& study) {
  files::ResultTerms terms{{"study.json", "variants.csv", "runs.csv", "progress.csv"},
                           study.read()};
  if (study.model->sampled) terms.names.emplace_back("drivers.csv");
  if (!page::empty_study_page().empty()) terms.names.emplace_back("study.html");
  return terms;
}

std::optional<std::string> write_study(files::ResultFolder& folder, const study::StudyModel& study,
                                       const std::vector<study::VariantRuns>& variants,
                                       const study::StudyAnswers& answers) {
  const std::string json = study_json(study, variants, answers);
  if (auto failure = folder.write("study.json", json)) return failure;
  if (auto failure = folder.write("variants.csv", variants_csv(study, variants, answers))) {
    return failure;
  }
  if (auto failure = folder.write("runs.csv", runs_csv(study, variants))) return failure;
  if (auto failure = folder.write("progress.csv", progress_csv(variants, answers))) return failure;
  if (study.sampled) {
    if (auto failure = folder.write("drivers.csv", drivers_csv(variants, answers))) return failure;
  }
  if (page::empty_study_page().empty()) {
    fmt::print(stderr, "rubicon: note: there is no study.html: {}\n", page::kNoViewerPage);
  } else if (auto failure = folder.write(
                 "study.html", page::study_page(page::empty_study_page(), json, study.name))) {
    return failure;
  }
  return folder.commit();
}

/// Makes the runs of a search, which finds its variants as it goes.
study::SearchResult search(LoadedStudy& study, study::RunnerOptions& runner) {
  const study::StudyModel& model = *study.model;
  const bool costed = study::facts_of(*study.first->plan).costed;
  std::map<std::size_t, std::vector<study::LoggedRun>> known;
  for (study::LoggedRun& each : runner.known) known[each.variant].push_back(std::move(each));
  StudyProgress progress;
  std::int64_t done_before = 0;
  std::int64_t done_now = 0;
  runner.on_progress = [&](std::int64_t done, std::int64_t) {
    done_now = done;
    progress.show(done_before + done, model.budget * model.most_runs);
  };
  study.variants.clear();
  study::SearchTools tools;
  tools.open = study::open_optimiser;
  tools.run = [&](const std::vector<interpreter::ParameterTexts>& next) {
    runner.first_variant = study.variants.size();
    study.variants.insert(study.variants.end(), next.begin(), next.end());
    runner.known.clear();
    for (std::size_t i = runner.first_variant; i < study.variants.size(); ++i) {
      if (auto found = known.extract(i)) {
        std::move(found.mapped().begin(), found.mapped().end(), std::back_inserter(runner.known));
      }
    }
    auto made = study::run_study(model, next, runner);
    done_before += done_now;
    done_now = 0;
    return made;
  };
  return search_study(model, costed, tools);
}

/// Runs again what is worth looking at, each into a folder of its own; false: one could not be
/// written, and was reported.
bool write_films(const StudyOptions& options, const study::StudyModel& study,
                 const std::vector<study::VariantRuns>& variants,
                 const study::StudyAnswers& answers) {
  for (const study::KeptRun& each : answers.kept) {
    RunOptions run;
    run.plan = (std::filesystem::path(options.study).parent_path() / study.plan).string();
    run.out = options.out + "/" + each.folder;
    run.prints = false;
    for (const auto& [name, value] : variants[each.variant].set)
      run.set.push_back(name + "=" + value);
    if (study.sampled) run.sample = fmt::format("{}:{}", study.seed, each.run);
    if (run_plan_command(run) == kWrongInput) return false;
  }
  return true;
}

int exit_code(const std::vector<study::VariantRuns>& variants, const study::StudyAnswers& answers) {
  if (answers.choice && !answers.choice->chosen) return kInfeasible;
  for (const study::VariantRuns& each : variants) {
    if (each.fault.empty()) return kFine;
  }
  return kInfeasible;
}

/// What two ranks of a job must have in common.
std::string digest_of(const LoadedStudy& study) {
  return encoding::sha256_hex(study.text + RUBICON_VERSION);
}

/// A rank that is not 0: works for rank 0, which reports what is wrong with the study.
int help_with_study(const StudyOptions& options, cluster::MpiChannel& channel) {
  SourceMap sources;
  interpreter::Diagnostics diagnostics;
  LoadedStudy study = load_study(options.study, sources, diagnostics, false);
  cluster::HelperOptions helper;
  helper.threads = std::max(1, options.jobs);
  helper.digest = digest_of(study);
  if (!study.model) helper.failure = fmt::format("it cannot read '{}'", options.study);
  helper.read = [&](std::size_t variant, const interpreter::ParameterTexts& set) {
    return load_variant(study, variant, set);
  };
  const study::StudyModel none;
  channel.end(cluster::help(channel, study.model ? *study.model : none, helper));
  return kFine;
}

int make_study(const StudyOptions& options, cluster::MpiChannel* channel);

}  // namespace

int run_study_command(const StudyOptions& options) {
  auto opened = cluster::open_mpi();
  if (const auto* message = std::get_if<std::string>(&opened)) return fail(*message);
  auto& channel = std::get<std::unique_ptr<cluster::MpiChannel>>(opened);
  if (!channel) return make_study(options, nullptr);
  return channel->rank() == 0 ? make_study(options, channel.get())
                              : help_with_study(options, *channel);
}

namespace {

/// The other ranks of a job, for rank 0: they end when this ends.
class Ranks {
 public:
  Ranks(cluster::MpiChannel& channel, const LoadedStudy& study, int threads)
      : channel_(channel),
        hand_out_(
            channel, threads, study.model ? study.model->questions.size() : 0, digest_of(study),
            [](const std::string& note) { fmt::print(stderr, "rubicon: note: {}\n", note); }) {}
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;
  ~Ranks() {
    let_go();
    std::fflush(stdout);
    channel_.end(hand_out_.all_there());
  }

  study::RemoteWorkers& workers() { return hand_out_; }
  /// They have nothing left to do.
  void let_go() {
    if (!std::exchange(is_over_, true)) hand_out_.end();
  }

 private:
  cluster::MpiChannel& channel_;
  cluster::HandOut hand_out_;
  bool is_over_ = false;
};

int make_study(const StudyOptions& options, cluster::MpiChannel* channel) {
  SourceMap sources;
  interpreter::Diagnostics diagnostics;
  LoadedStudy study = load_study(options.study, sources, diagnostics);
  // Of several ranks on a computer each is one of its processors.
  const int threads = channel ? std::max(1, options.jobs) : thread_count(options.jobs);
  std::optional<Ranks> ranks;
  if (channel) ranks.emplace(*channel, study, threads);
  const auto found = diagnostics.sorted();
  if (!found.empty()) {
    const std::string messages = report::print_text(found, sources, files::wants_colour(stderr));
    std::fwrite(messages.data(), 1, messages.size(), stderr);
  }
  if (!study.model) return kWrongInput;

  std::optional<StudyLog> log;
  std::optional<files::ResultFolder> folder;
  if (!options.out.empty()) {
    if (const auto obstacle = files::ResultFolder::obstacle(options.out, result_terms(study))) {
      return fail(*obstacle);
    }
    const std::string progress = options.out + "/study.progress";
    if (const auto obstacle = not_ours(progress)) return fail(*obstacle);
    auto file = files::AppendFile::open(progress, options.resume);
    if (auto* message = std::get_if<std::string>(&file)) return fail(*message);
    log.emplace(std::get<files::AppendFile>(std::move(file)), digest_of(study));
    if (const auto failure = log->read(*study.model, study::count_variants(*study.model))) {
      return fail(fmt::format("'{}': {}", options.out, *failure));
    }
  }

  study::RunnerOptions runner;
  runner.threads = threads;
  if (ranks) runner.remote = &ranks->workers();
  runner.read = [&](std::size_t variant, const interpreter::ParameterTexts& set) {
    return load_variant(study, variant, set);
  };
  if (log) {
    runner.known = log->take_known();
    runner.on_run = [&](const study::LoggedRun& run) { return log->append(write_line(run)); };
    runner.on_load = [&](std::size_t variant, const std::string& digest) {
      return log->note(variant, digest);
    };
  }
  std::optional<std::vector<study::VariantRuns>> variants;
  std::string failure;
  if (must_search(*study.model)) {
    study::SearchResult result = search(study, runner);
    variants = std::move(result.variants);
    failure = std::move(result.failure);
  } else {
    StudyProgress progress;
    runner.on_progress = [&](std::int64_t done, std::int64_t planned) {
      progress.show(done, planned);
    };
    variants = study::run_study(*study.model, study.variants, runner);
  }
  if (ranks) ranks->let_go();
  if (log && log->failure()) return fail(fmt::format("'{}': {}", options.out, *log->failure()));
  if (!variants) return fail(fmt::format("the search cannot go on: {}", failure));
  study::StudyAnswers answers = study::answers_of(*study.model, *variants);
  if (log) {
    if (options.films) {
      answers.kept = study::runs_to_keep(*study.model, *variants, answers);
      if (!write_films(options, *study.model, *variants, answers)) return kWrongInput;
    }
    auto opened = files::ResultFolder::open(options.out, result_terms(study));
    if (auto* message = std::get_if<std::string>(&opened)) return fail(*message);
    folder.emplace(std::get<files::ResultFolder>(std::move(opened)));
    if (const auto unwritten = write_study(*folder, *study.model, *variants, answers)) {
      return fail(*unwritten);
    }
    log->remove();
  }
  const std::string text = options.format == "json" ? study_json(*study.model, *variants, answers)
                           : options.format == "csv"
                               ? variants_csv(*study.model, *variants, answers)
                               : study_table(*study.model, *variants, answers);
  std::fwrite(text.data(), 1, text.size(), stdout);
  return exit_code(*variants, answers);
}

}  // namespace

}  // namespace rubicon::cli
