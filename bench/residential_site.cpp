#include "bench/residential_site.hpp"

#include <array>

namespace rubicon::bench {
namespace {

constexpr int kStoreys = 5;
constexpr int kUnitsInARow = 4;
constexpr int kPlanks = 10;
constexpr double kStorey = 3;  // m
constexpr double kUnitLength = 12;
constexpr double kPlankWidth = 1.2;
constexpr double kFirstRow = 11.6;   // m, y of the middle of the row near the crane
constexpr double kSecondRow = 20.8;  // m, beyond a corridor of 2 m

/// A wall of a unit: middle in the plane of the unit, whose corner is the origin.
struct Wall {
  double x;
  double y;
  double half_length;
  bool along_y;
};

constexpr std::array<Wall, 15> kWalls = {{{0.075, 1.8, 1.8, true},
                                          {0.075, -1.8, 1.8, true},
                                          {11.925, 1.8, 1.8, true},
                                          {11.925, -1.8, 1.8, true},
                                          {2.1, 3.525, 1.95, false},
                                          {6, 3.525, 1.95, false},
                                          {9.9, 3.525, 1.95, false},
                                          {2.0375, 0.975, 1.8875, false},
                                          {4, 2.25, 1.2, true},
                                          {6, -1.275, 2.175, true},
                                          {8.9625, 0.975, 2.8875, false},
                                          {9, -1.275, 2.175, true},
                                          {2.1, -3.525, 1.95, false},
                                          {6, -3.525, 1.95, false},
                                          {9.9, -3.525, 1.95, false}}};

/// Frames of the units of a storey: the second row is turned round, balconies outwards.
std::vector<Pose> unit_frames() {
  std::vector<Pose> frames;
  const double west = -kUnitLength * kUnitsInARow / 2;
  for (int i = 0; i < kUnitsInARow; ++i) {
    frames.push_back(math::translation(west + kUnitLength * i, kFirstRow, 0));
    frames.push_back(math::translation(west + kUnitLength * (i + 1), kSecondRow, 0) *
                     math::rotation_z_deg(180));
  }
  return frames;
}

}  // namespace

SweptScene residential_site() {
  SweptScene scene;
  const auto add_solid = [&](const Vec3& half) {
    scene.solids.emplace_back(centred_box(half));
    return static_cast<int>(scene.solids.size()) - 1;
  };
  const int ground = add_solid({60, 60, 0.5});
  const int plank = add_solid(kPlankHalf);
  const int balcony = add_solid({3, 0.75, 0.1});
  const int stair = add_solid({0.98, 0.6, 1.4});
  std::vector<int> walls;
  for (const Wall& wall : kWalls) walls.push_back(add_solid({wall.half_length, 0.075, 1.3}));

  scene.standing.push_back({ground, math::translation(0, 0, -0.5)});
  for (int storey = 0; storey < kStoreys; ++storey) {
    for (const Pose& frame : unit_frames()) {
      const Pose X_WU = math::translation(0, 0, kStorey * storey) * frame;
      const auto place = [&](int solid, double x, double y, double z) {
        scene.standing.push_back({solid, X_WU * math::translation(x, y, z)});
      };
      for (int i = 0; i < kPlanks; ++i) {
        const double x = kPlankWidth * (0.5 + i);
        place(plank, x, 0, 0.1);
        if (storey + 1 < kStoreys) place(plank, x, 0, 2.9);
      }
      place(balcony, 6, -4.45, 0.1);
      place(stair, 1.98, 4.3, 1.6);
      for (std::size_t i = 0; i < kWalls.size(); ++i) {
        const Wall& wall = kWalls[i];
        const Pose X_UB =
            math::translation(wall.x, wall.y, 1.5) * math::rotation_z_deg(wall.along_y ? 90 : 0);
        scene.standing.push_back({walls[i], X_WU * X_UB});
      }
    }
  }
  scene.load = centred_box(kPlankHalf);
  return scene;
}

std::vector<Vec3> roof_places() {
  std::vector<Vec3> places;
  for (const Pose& frame : unit_frames()) {
    for (int i = 0; i < kPlanks; ++i) {
      places.emplace_back(frame * Vec3(kPlankWidth * (0.5 + i), 0, kTopOfWalls + kPlankHalf.z()));
    }
  }
  return places;
}

}  // namespace rubicon::bench
