#pragma once

#include <optional>
#include <string>

#include "interpreter/program/events.hpp"

namespace rubicon::comparison {

/// What the first plan of a motion says.
class FirstReport : public interpreter::EventSink {
 public:
  void guide(const interpreter::GuidePlan& plan) override {
    if (report) return;
    report = *plan.report;
    cause = plan.cause;
  }
  void goal(int, int) override {}
  void way_point(int, int) override {}
  void set(const std::string&, double, interpreter::Span) override {}
  void enter(interpreter::LoopKind, interpreter::Span) override {}
  void exit(interpreter::LoopKind, interpreter::Span, bool, int) override {}
  void which(const std::string&, interpreter::Span) override {}
  void attempt(const interpreter::Attempt&) override {}
  void wait(int, interpreter::Ticks, interpreter::Span) override {}
  void stop(interpreter::Ticks) override {}

  std::optional<guides::PlanReport> report;
  std::string cause;
};

}  // namespace rubicon::comparison
