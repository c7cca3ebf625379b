#pragma once

#include <cstddef>

/// What a machine may cost, in work and never in time: the same file is read or refused everywhere.
/// Real machine descriptions stay below a hundredth of each.
namespace rubicon::urdf {

inline constexpr std::size_t kMaxFileBytes = std::size_t{64}
                                             << 20;   ///< of the file; of all it includes
inline constexpr std::size_t kMaxElements = 500'000;  ///< of one file, and of all that xacro makes
inline constexpr int kMaxDepth = 200;                 ///< of elements in each other
inline constexpr std::size_t kMaxIncludes = 500;      ///< files that a xacro file includes, in all
inline constexpr std::size_t kMaxIncludeDepth = 40;   ///< files that include each other
inline constexpr std::size_t kMaxCallDepth = 100;     ///< macros that call each other
inline constexpr std::size_t kMaxExpandedBytes = std::size_t{64} << 20;  ///< names and values
inline constexpr std::size_t kMaxTextBytes = std::size_t{1} << 20;       ///< of one value
inline constexpr std::size_t kMaxExpressionSteps = 5'000'000;            ///< in all expressions
inline constexpr int kMaxExpressionDepth = 64;  ///< of parentheses, and of properties in each other
inline constexpr std::size_t kMaxLinks = 10'000;  ///< joints are one fewer

inline constexpr std::size_t kMaxMovingLinks = 999;  // a robot has 1000 bodies

}  // namespace rubicon::urdf
