#pragma once

#include <optional>
#include <string_view>

#include "interpreter/syntax/diagnostic.hpp"
#include "interpreter/syntax/syntax.hpp"
#include "src/motion/robot/goal_clauses.hpp"

namespace rubicon::interpreter {

/// Largest length that shapes, frames, steps and speeds may have, in m (m/s). Beyond it a double no
/// longer resolves a tenth of the contact tolerance; angles (degrees) share the bound.
inline constexpr double kMaxLength = 1e7;

/// Smallest motion step, in m or degrees: finer ones cannot be told apart by the livelock check at
/// kMaxLength.
inline constexpr double kMinStep = 1e-6;

/// Largest duration of one thing, in s (about three years): sums of thousands stay within 64 bits
/// of nanoseconds.
inline constexpr double kMaxDuration = 1e8;

/// Of a bare number the density, in kg/m3, up to which it is meant in t/m3: gold has 19.3 of these,
/// and foam 15 kg/m3 and more.
inline constexpr double kLightestDensity = 25;

/// "a length", "an angle", ...: what a unit measures.
std::string_view unit_kind_text(syntax::UnitKind kind);

/// Whether `number` is bare or has a unit of the kind `wanted`; F09 at its place if not. `what`
/// names it in the message ("step(...) of 'x'").
bool check_unit(const syntax::Number& number, syntax::UnitKind wanted, std::string_view what,
                Diagnostics& diagnostics);

/// How far the tool of a robot may be beside a straight way; the angle is the default where it is
/// not given. F09, or `code` where it is out of bounds; nothing then.
std::optional<robot::LineDeviation> resolve_deviation(const syntax::MotionClause& clause,
                                                      const char* code, Diagnostics& diagnostics);

}  // namespace rubicon::interpreter
