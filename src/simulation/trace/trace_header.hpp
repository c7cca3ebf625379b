#pragma once

#include <string>

#include "interpreter/check/plan_model.hpp"
#include "interpreter/syntax/source.hpp"
#include "src/simulation/trace/trace_sink.hpp"

namespace rubicon::trace {

/// The first line of a trace: the whole scene, so that reports, explanations and verification need
/// nothing else. Lengths in metres, angles of parameters in degrees, times in seconds; files with
/// their text and its SHA-256. docs/trace.md describes every member.
std::string header_line(const interpreter::PlanModel& plan, const interpreter::SourceMap& sources,
                        TraceDetail detail);

}  // namespace rubicon::trace
