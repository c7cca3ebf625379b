#include "src/simulation/taskplan/hit_recorder.hpp"

#include <algorithm>

namespace rubicon::taskplan {

void HitRecorder::goal(int k, int n) {
  way_point_ = k;
  if (next_) next_->goal(k, n);
}

/// Machines and zones that kept a guide from a way are given way to as those that refuse steps.
void HitRecorder::guide(const interpreter::GuidePlan& plan) {
  if (!plan.report->found()) {
    for (const interpreter::HitPair& pair : plan.others) {
      given_way_.push_back({0, {}, {}, pair, way_point_, plan.time});
      met_.emplace(pair.machine, pair.machine >= 0 ? std::string() : pair.met);
    }
  }
  if (next_) next_->guide(plan);
}

void HitRecorder::way_point(int k, int n) {
  if (next_) next_->way_point(k, n);
}

void HitRecorder::set(const std::string& variable, double value, interpreter::Span span) {
  if (next_) next_->set(variable, value, span);
}

void HitRecorder::enter(interpreter::LoopKind kind, interpreter::Span span) {
  if (next_) next_->enter(kind, span);
}

void HitRecorder::exit(interpreter::LoopKind kind, interpreter::Span span, bool reached,
                       int successes) {
  if (next_) next_->exit(kind, span, reached, successes);
}

void HitRecorder::which(const std::string& label, interpreter::Span span) {
  if (next_) next_->which(label, span);
}

void HitRecorder::attempt(const interpreter::Attempt& attempt) {
  if (attempt.hit != nullptr || attempt.accepted) {
    std::erase_if(open_, [&](const RecordedHit& hit) {
      return std::equal(hit.parameters.begin(), hit.parameters.end(), attempt.parameters.begin(),
                        attempt.parameters.end());
    });
    std::erase_if(given_way_, [&](const RecordedHit& hit) {
      return hit.span.file == attempt.span.file && hit.span.begin == attempt.span.begin;
    });
  }
  if (attempt.hit != nullptr) {
    const RecordedHit hit{attempt.n,    {attempt.parameters.begin(), attempt.parameters.end()},
                          attempt.span, *attempt.hit,
                          way_point_,   attempt.time};
    if (hit.pair.may_leave()) given_way_.push_back(hit);
    note(hit.pair);
    open_.push_back(hit);
  }
  if (keeps_way_ && attempt.accepted) way_.emplace_back(attempt.q.begin(), attempt.q.end());
  if (next_) next_->attempt(attempt);
}

void HitRecorder::wait(int n, interpreter::Ticks time, interpreter::Span span) {
  if (next_) next_->wait(n, time, span);
}

void HitRecorder::think(const interpreter::Thinking& thinking) {
  if (next_) next_->think(thinking);
}

void HitRecorder::foreseen(const interpreter::ForeseenWay& way, interpreter::Ticks time) {
  if (next_) next_->foreseen(way, time);
}

void HitRecorder::stop(interpreter::Ticks time) {
  if (next_) next_->stop(time);
}

}  // namespace rubicon::taskplan
