#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "src/exchange/ifc/curve_points.hpp"
#include "src/exchange/ifc/ifc_profile.hpp"

namespace rubicon::ifc {

/// The areas of a profile: by its measures, by its curves, with holes, composed of others, derived
/// from another. Nothing if something of it cannot be read, or its lines cross.
std::optional<std::vector<Region>> profile_regions(const ShapeTerms& terms, std::uint64_t id);

/// Profiles composed of composed profiles: real files have one level.
inline constexpr int kDeepestProfile = 8;

}  // namespace rubicon::ifc
