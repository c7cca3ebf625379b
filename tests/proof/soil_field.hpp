#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "tests/proof/fcl_voice.hpp"

namespace rubicon::collision::proof {

/// Soil between two surfaces over square cells, as columns; one whose top is not above its bottom
/// is empty. Whole mm, from the corner of the first cell.
struct Columns {
  int columns = 0, rows = 0;
  std::int64_t cell = 0;
  std::vector<std::int64_t> top, bottom;

  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(column);
  }
  bool is_empty(std::size_t cell_index) const { return top[cell_index] <= bottom[cell_index]; }
  /// m: the least height of a column that is not empty.
  double thinnest() const;
};

/// All points from which a cube of half an edge `by` (m) reaches the soil; for a negative number
/// those around which such a cube lies in the soil. Of columns that are grown apart in height, what
/// is between them counts, too. As triangles for FCL: it knows no boxes.
class OffsetSoil {
 public:
  OffsetSoil(const Columns& soil, double by);

  bool has(const Vec3& point) const;
  /// The surface; null where nothing is left.
  const FclGeometry& surface() const { return surface_; }

 private:
  struct Strip {
    double bottom = 0, top = 0;
    bool is_empty() const { return top <= bottom; }
  };
  Strip strip(std::size_t i, std::size_t j) const;
  void make_surface();

  std::vector<double> x_, y_;  ///< m: the borders of the strips
  std::vector<Strip> strips_;
  FclGeometry surface_;
};

/// The same soil with many offsets, each made when it is asked for.
class SoilOffsets {
 public:
  explicit SoilOffsets(Columns soil) : soil_(std::move(soil)) {}
  const Columns& soil() const { return soil_; }
  const OffsetSoil& by(double offset);

 private:
  Columns soil_;
  std::map<double, OffsetSoil> made_;
};

}  // namespace rubicon::collision::proof
