#include "tests/unit/travel/fixtures.hpp"

#include "src/motion/math/angles.hpp"

namespace rubicon::travel {

Obstacle moving(std::string name, Corners corners, double from, double to, const Vec2& velocity) {
  return {std::move(name),
          {std::move(corners)},
          {{from, {0, 0}, 0}, {to, (to - from) * velocity, 0}},
          false};
}

Obstacle standing(std::string name, Corners corners) {
  return {std::move(name), {std::move(corners)}, {}, false};
}

TravelQuery figure_1() {
  const Corners m = {{-6, 0}, {6, 0}, {8, 6}, {0, 10}, {-8, 6}};
  return {{moving("M", m, 25, 60, {-0.75, 0})}, {0, -20}, {0, 40}};
}

TravelQuery figure_3() {
  return {{standing("S", box(-20, 0, 40, 4)), moving("M1", box(-26, -20, 7, 22), 70, 1e5, {-1, 0}),
           standing("M2", box(19, -20, 7, 22))},
          {0, -40},
          {0, 60}};
}

TravelQuery figure_4b() {
  return {{standing("S", box(-20, 0, 40, 4)), standing("M1", box(-32, -26, 12, 13)),
           moving("M2", box(-26, -14, 7, 17), 80, 140, {-1, 1})},
          {0, -40},
          {0, 60}};
}

TravelQuery figure_4c(bool opens) {
  const Corners m = box(-31, 9, 5, 20);
  return {{standing("W1", box(-30, -30, 60, 4)), standing("W2", box(26, -30, 4, 60)),
           standing("W3", box(-30, 26, 60, 4)), standing("W4", box(-30, -30, 4, 40)),
           opens ? moving("M", m, 150, 170, {-2, 0}) : standing("M", m)},
          {0, -10},
          {0, 80}};
}

TravelQuery figure_5() {
  const Corners m4 = {{-2, 55}, {4, 51}, {10, 55}, {10, 63}, {-2, 63}};
  return {{standing("S1", box(-20, 0, 40, 4)), standing("M1", box(-32, -26, 12, 13)),
           moving("M2", box(-26, -3, 7, 6), 82, 140, {-1, 1}),
           moving("M3", box(-26, -15, 6, 13), 82, 140, {-1, 1}),
           standing("S2", u_shape(-25, 20, 34, 20, 3)), moving("M4", m4, 190, 1e5, {-0.2, 0})},
          {0, -40},
          {0, 90}};
}

TravelQuery figure_2a() {
  TravelQuery query;
  const auto at = [](double angle, double radius) {
    return Vec2(radius * math::cos_deg(angle), radius * math::sin_deg(angle));
  };
  constexpr int kSlabs = 36;
  constexpr double kThickness = 0.5;
  for (int i = 0; i < kSlabs; ++i) {
    // From 2 m further in than the end of the slab before, 5 degrees back, to half a metre further
    // out than that end, 30 degrees on.
    const double angle = 180 - 30 * i;
    const double radius = 20 + 0.5 * i;
    const Vec2 a = at(angle + 35, radius - 2.5);
    const Vec2 b = at(angle, radius);
    const Vec2 along = (b - a).normalized();
    const Vec2 inward = kThickness * Vec2(along.y(), -along.x());
    query.obstacles.push_back(
        standing("slab" + std::to_string(i), {a, b, Vec2(b + inward), Vec2(a + inward)}));
  }
  query.start = at(205, 60);
  return query;
}

TravelQuery figure_2b() {
  // Four long boxes like the sails of a mill round the destination's side, none in contact.
  return {{standing("A", box(-12, 0, 20, 3)), standing("B", box(9, 0, 3, 20)),
           standing("C", box(-8, 21, 20, 3)), standing("D", box(-12, 4, 3, 20))},
          {0, -20},
          {0, 12}};
}

}  // namespace rubicon::travel
