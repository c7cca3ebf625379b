#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "src/studies/search/search.hpp"

namespace rubicon::study {

/// Starts the program `rubicon-search` that lies beside the command: NSGA-II of pagmo. A program of
/// its own, because loading pagmo takes longer than many runs of the command. It ends when the
/// optimiser is destroyed, or when the command ends in any way. Where it cannot be started the
/// optimiser does not answer.
std::unique_ptr<Optimiser> open_optimiser(const SearchSpace& space, const SearchPoint& start,
                                          std::uint32_t seed);

}  // namespace rubicon::study
