#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "interpreter/program/events.hpp"

namespace rubicon::taskplan {

/// An attempt that met something.
struct RecordedHit {
  int n = 0;
  std::vector<std::string> parameters;  ///< display names
  interpreter::Span span;
  interpreter::HitPair pair;
  int way_point = 1;            ///< from 1, of its motion
  interpreter::Ticks time = 0;  ///< when it was met
};

/// Passes events on (to a trace, if there is one) and remembers who is in the way: the last hit of
/// every set of parameters that has not moved since.
class HitRecorder : public interpreter::EventSink {
 public:
  explicit HitRecorder(interpreter::EventSink* next) : next_(next) {}

  /// The latest hit that was not overcome; null if there is none.
  const RecordedHit* last() const { return open_.empty() ? nullptr : &open_.back(); }
  /// All that were not overcome, oldest first.
  const std::vector<RecordedHit>& open() const { return open_; }
  /// Hits of other machines and of zones since `forget` whose command has not succeeded since: also
  /// those that the robot gave way to.
  const std::vector<RecordedHit>& given_way() const { return given_way_; }
  /// All that was met since `forget`, overcome or not: machines by number, other things by name.
  const std::set<std::pair<int, std::string>>& met() const { return met_; }
  /// Something was met by no attempt of a script.
  void note(const interpreter::HitPair& pair) {
    met_.emplace(pair.machine, pair.machine >= 0 ? std::string() : pair.met);
  }
  /// From now on the configurations after each step are kept, or no more.
  void keep_way(bool keeps) {
    keeps_way_ = keeps;
    if (keeps) way_.clear();
  }
  const std::vector<std::vector<double>>& way() const { return way_; }
  void forget() {
    open_.clear();
    given_way_.clear();
    met_.clear();
  }

  void goal(int k, int n) override;
  void guide(const interpreter::GuidePlan& plan) override;
  void way_point(int k, int n) override;
  void set(const std::string& variable, double value, interpreter::Span span) override;
  void enter(interpreter::LoopKind kind, interpreter::Span span) override;
  void exit(interpreter::LoopKind kind, interpreter::Span span, bool reached,
            int successes) override;
  void which(const std::string& label, interpreter::Span span) override;
  void attempt(const interpreter::Attempt& attempt) override;
  void wait(int n, interpreter::Ticks time, interpreter::Span span) override;
  void stop(interpreter::Ticks time) override;
  void think(const interpreter::Thinking& thinking) override;
  void foreseen(const interpreter::ForeseenWay& way, interpreter::Ticks time) override;

 private:
  interpreter::EventSink* next_;
  std::vector<RecordedHit> open_;       ///< oldest first
  std::vector<RecordedHit> given_way_;  ///< oldest first
  std::set<std::pair<int, std::string>> met_;
  int way_point_ = 1;
  bool keeps_way_ = false;
  std::vector<std::vector<double>> way_;
};

}  // namespace rubicon::taskplan
