#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "src/exchange/ifc/curve_points.hpp"
#include "src/exchange/ifc/solid.hpp"
#include "src/exchange/ifc/solid_cut.hpp"

namespace rubicon::ifc {

/// What a shape is made of. Bodies may overlap: their union is the thing.
struct Bodies {
  std::vector<Solid> solids;       ///< metres, in the frame of the shape
  std::vector<std::string> notes;  ///< where the solids differ from the model: lower case
};

/// Makes bodies of what a file says: extruded, revolved and swept areas, faces, primitives, mapped
/// items and what is combined from them. Cuts and holes are worked out here, exactly but for
/// kShift. A cut that cannot be made is left out and noted: the body is larger, never smaller.
class ShapeReader {
 public:
  explicit ShapeReader(const ShapeTerms& terms) : terms_(terms) {}

  /// The body of an IfcProductDefinitionShape. Nothing if no representation can be read whole.
  std::optional<Bodies> read(std::uint64_t shape);

 private:
  bool read_representation(std::uint64_t id, int depth, Bodies& out);
  bool read_item(std::uint64_t id, int depth, Bodies& out);
  bool read_mapped(const StepRecord& record, int depth, Bodies& out);
  bool read_boolean(const StepRecord& record, int depth, Bodies& out);
  bool read_swept(const StepRecord& record, Bodies& out);
  bool read_disk(const StepRecord& record, Bodies& out);
  bool put(std::optional<Solid> solid, Bodies& out) const;
  std::optional<std::vector<Cell>> cutter(std::uint64_t id, int depth, const Bodies& first,
                                          Bodies& notes);
  std::optional<std::vector<Cell>> half_space(const StepRecord& record, const Bodies& first);

  const ShapeTerms& terms_;
};

/// What is taken away from bodies at once, and how people call it.
struct BodyCut {
  std::vector<Cell> cells;
  std::string what;
};

/// Makes cuts one after the other. One that a body cannot be cut with, or that takes more than its
/// share of the budget, is left out and noted.
void cut_bodies(Bodies& bodies, const std::vector<BodyCut>& cuts, WorkBudget& budget);

/// The cells of closed bodies; nothing if one is open, or too complicated, or they take more than
/// their share of the budget.
std::optional<std::vector<Cell>> cells_of(const Bodies& bodies, WorkBudget& budget);

/// Moves points. Mirrored bodies are turned, so that they look outwards.
void transform(const math::Mat3& linear, const math::Vec3& translation, std::vector<Solid>& solids);

/// Steps that the cuts of one body may take, and those that make cells of one tool, but never more
/// than half of what is left for cuts (WorkBudget::share). 400 round holes in a slab take 170
/// million, a sphere of 1 m 20.
inline constexpr std::uint64_t kMostCutSteps = 250'000'000;
/// Booleans in second operands, and maps in maps: real files have two or three.
inline constexpr int kDeepestShape = 32;
/// Booleans on first operands: real files have up to a few hundred cuts in one beam.
inline constexpr std::size_t kLongestChain = 10'000;

}  // namespace rubicon::ifc
