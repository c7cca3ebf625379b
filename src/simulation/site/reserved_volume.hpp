#pragma once

#include <optional>
#include <vector>

#include "src/motion/collision/query/swept_volume.hpp"

namespace rubicon::site {

/// By how much the volume of a step may be larger than what is swept (m): a share of the contact
/// tolerance, so that what only touches stays free. Consequence: false hits only where two machines
/// come nearer than this to the tolerance.
inline constexpr double kReservedGrowthShare = 0.25;
/// But not less (m): below it the slices of a step become too many.
inline constexpr double kLeastReservedGrowth = 1e-5;

double reserved_growth(double contact_tolerance);

/// One body of a reserved volume, over a step or standing (m, world).
struct ReservedPart {
  collision::BodyPtr body;
  geometry::Motion motion;
  int part = 0;  ///< the owner's number for it
  bool is_buffer = false;
};

/// What is known of the volume that a machine sweeps in a step, from its tests.
struct StepVolume {
  std::optional<collision::Bounds> bounds;  ///< a box around all of it, world
  std::vector<geometry::Motion> motions;    ///< of its parts, see `part_motions`; or none
};

/// The volume that belongs to one owner: where a machine stands, all that it sweeps while a step of
/// it lasts, or a zone.
class ReservedVolume {
 public:
  ReservedVolume(std::vector<ReservedPart> parts, double growth);

  /// Which body of the query meets which part of the volume.
  struct Hit {
    int item = 0;
    int part = 0;
  };
  /// The first such pair: by the items of the query, then by the parts. Items that are buffers
  /// (`are_buffers`, by item; empty: none is) are not tested against buffers.
  std::optional<Hit> meets(collision::MovingBodies& bodies,
                           const std::vector<bool>& are_buffers = {}) const;

  /// The box around it, world.
  const collision::Bounds& bounds() const { return bounds_; }

 private:
  struct Part {
    collision::SweptVolume volume;
    int part = 0;
    bool is_buffer = false;
  };
  std::vector<Part> parts_;
  collision::Bounds bounds_;
};

}  // namespace rubicon::site
