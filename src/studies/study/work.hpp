#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "interpreter/check/plan_model.hpp"
#include "interpreter/syntax/source.hpp"
#include "src/simulation/site/make_site.hpp"
#include "src/studies/study/run_record.hpp"
#include "src/studies/study/study_model.hpp"

namespace rubicon::study {

/// A plan with the settings of a variant, ready to run.
struct LoadedVariant {
  std::unique_ptr<interpreter::PlanModel> plan;  ///< null if it cannot run
  interpreter::SourceMap sources;
  std::string fault;   ///< why it cannot run, for people
  std::string digest;  ///< of all that was read for it
};

/// Reads the plan with the settings of a variant, by its number in the study; of one variant in one
/// thread at a time, of several in several.
using VariantReader =
    std::function<LoadedVariant(std::size_t variant, const interpreter::ParameterTexts& set)>;

/// A part of the work of a study: to open a variant, or to make some of its runs.
struct Piece {
  std::size_t variant = 0;  ///< its number in the study
  interpreter::ParameterTexts set;
  std::vector<std::int64_t> runs;  ///< none: it is opened
};

/// What came of a piece.
struct PieceResult {
  std::string fault;                  ///< why the variant cannot run
  std::string digest;                 ///< of what was read for the variant
  std::optional<VariantFacts> facts;  ///< of one that was opened
  std::vector<LoggedRun> runs;
};

/// Variants that were read lately, with what their runs share; for several threads.
class OpenVariants {
 public:
  struct Entry {
    LoadedVariant loaded;
    site::PreparedSite site;
    std::string fault;  ///< of the plan, or of its shapes
  };

  /// Keeps at most so many.
  OpenVariants(VariantReader read, std::size_t most) : read_(std::move(read)), most_(most) {}
  std::shared_ptr<const Entry> get(std::size_t variant, const interpreter::ParameterTexts& set);
  void forget(std::size_t variant);

 private:
  struct Slot {
    std::size_t variant = 0;
    std::mutex reading;
    std::shared_ptr<const Entry> entry;
  };

  VariantReader read_;
  std::size_t most_;
  std::mutex mutex_;                        ///< of the list
  std::list<std::shared_ptr<Slot>> slots_;  ///< the one used last first
};

/// Works on pieces: one for each thread.
class Worker {
 public:
  /// All must outlive it. Where `stop` becomes true it makes no more runs, and its results do not
  /// matter any more.
  Worker(const StudyModel& study, OpenVariants& variants, const std::atomic<bool>* stop = nullptr)
      : study_(study), variants_(variants), stop_(stop) {}
  /// Throws what a run throws that is no fault of a plan.
  PieceResult work(const Piece& piece);

 private:
  const StudyModel& study_;
  OpenVariants& variants_;
  const std::atomic<bool>* stop_;
};

/// The work of a study as remote workers see it; its functions may be called while threads work.
class Work {
 public:
  virtual ~Work() = default;
  /// Nothing: there is none just now.
  virtual std::optional<Piece> take() = 0;
  virtual void done(const Piece& piece, const PieceResult& result) = 0;
  /// Whoever had it is lost; others do it.
  virtual void give_back(const Piece& piece) = 0;
  /// Nothing is left, or the study was ended.
  virtual bool is_over() const = 0;
  /// Why a result cannot be one of the piece: what comes from elsewhere is looked at before it is
  /// done. "": it can.
  virtual std::string complaint(const Piece& piece, const PieceResult& result) const = 0;
};

/// Others that work on a study.
class RemoteWorkers {
 public:
  virtual ~RemoteWorkers() = default;
  /// How many pieces they may have at a time.
  virtual int places() const = 0;
  /// Has them work until the work is over; false if the study cannot go on.
  virtual bool serve(Work& work) = 0;
};

}  // namespace rubicon::study
