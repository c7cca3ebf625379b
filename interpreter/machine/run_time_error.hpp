#pragma once

#include <string>

#include "interpreter/syntax/source.hpp"

namespace rubicon::interpreter {

/// A mistake of a script that only shows when it runs: ends the motion with status `error` at its
/// place.
struct RunTimeError {
  std::string message;
  Span span;
};

/// Fraction of a step within which a value counts as met, and tolerance of comparisons (LANGUAGE
/// section 4).
inline constexpr double kEpsilon = 1e-6;

/// Visits of one cell of half steps after which a run counts as circling (LANGUAGE 9.3).
inline constexpr std::uint32_t kMaxVisits = 50;

/// Assignments and structure between two attempts; more means behaviours that call each other
/// without ever moving.
inline constexpr int kMaxQuietSteps = 1'000'000;

}  // namespace rubicon::interpreter
