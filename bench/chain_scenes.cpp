#include "bench/chain_scenes.hpp"

#include <algorithm>
#include <cmath>

namespace rubicon::bench {

namespace {

/// Numbers as a plan has them: four digits behind the point.
double rounded(double value) { return std::round(value * 1e4) / 1e4; }

ChainBox span_box(double x0, double x1, double y0, double y1, double z0, double z1) {
  return {{shift(rounded((x0 + x1) / 2), rounded((y0 + y1) / 2), rounded((z0 + z1) / 2))},
          {rounded((x1 - x0) / 2), rounded((y1 - y0) / 2), rounded((z1 - z0) / 2)}};
}

std::vector<double> drawn(const Chain& chain, Random& random) {
  std::vector<double> q;
  for (const ChainLink& link : chain.links) {
    if (link.axis != '-') q.push_back(rounded(random.between(link.lower, link.upper)));
  }
  return q;
}

/// Of the hand of the arm: where its fingers end, and where it points.
struct Hand {
  Eigen::Vector3d tip;
  Eigen::Vector3d points;
};
Hand hand_at(const Chain& arm, const std::vector<double>& q) {
  const Eigen::Isometry3d X = arm.poses(q).back();
  return {X * Eigen::Vector3d(0, 0, 0.21), X.linear().col(2)};
}

/// A configuration that brings the hand there, by damped least squares from a random one.
std::optional<std::vector<double>> reach(const Chain& arm, const Hand& wanted, Random& random) {
  using Error = Eigen::Matrix<double, 6, 1>;
  std::vector<double> q = drawn(arm, random);
  const auto error_at = [&](const std::vector<double>& at) {
    const Hand hand = hand_at(arm, at);
    Error error;
    error << wanted.tip - hand.tip, 0.3 * (wanted.points - hand.points);
    return error;
  };
  for (int i = 0; i < 60; ++i) {
    const Error error = error_at(q);
    if (error.norm() < 1e-3) break;
    Eigen::Matrix<double, 6, 7> slope;
    for (int j = 0; j < 7; ++j) {
      std::vector<double> beside = q;
      beside[static_cast<std::size_t>(j)] += 0.01;
      slope.col(j) = (error - error_at(beside)) / 0.01;
    }
    const Eigen::Matrix<double, 6, 6> damped =
        slope * slope.transpose() + 1e-8 * Eigen::Matrix<double, 6, 6>::Identity();
    const Eigen::Matrix<double, 7, 1> step = slope.transpose() * damped.ldlt().solve(error);
    std::size_t joint = 0;
    for (const ChainLink& link : arm.links) {
      if (link.axis == '-') continue;
      q[joint] += std::clamp(step[static_cast<Eigen::Index>(joint)], -20.0, 20.0);
      q[joint] = std::clamp(q[joint], link.lower, link.upper);
      ++joint;
    }
  }
  if (error_at(q).norm() > 0.01) return std::nullopt;
  for (double& value : q) value = rounded(value);
  return q;
}

/// Boards at heights, side walls, a back, and with `columns` walls between.
struct Shelf {
  double x0, x1, y0, y1, thickness;
  std::vector<double> boards;
  int columns;
};
std::vector<ChainBox> boxes_of(const Shelf& s) {
  std::vector<ChainBox> boxes;
  for (const double z : s.boards) {
    boxes.push_back(span_box(s.x0, s.x1, s.y0, s.y1, z, z + s.thickness));
  }
  const double top = s.boards.back();
  for (int i = 0; i <= s.columns; ++i) {
    const double y = s.y0 + (s.y1 - s.y0) * i / s.columns;
    boxes.push_back(span_box(s.x0, s.x1, y - s.thickness / 2, y + s.thickness / 2, 0, top));
  }
  boxes.push_back(span_box(s.x1, s.x1 + s.thickness, s.y0, s.y1, 0, top));
  return boxes;
}

struct HandGoals {
  std::vector<ChainBox> obstacles;
  Hand start, goal;
};

HandGoals in_shelf(Random& random, int rows, double lowest, double height, int columns) {
  const double x0 = random.between(0.5, 0.58);
  const double y = random.between(-0.1, 0.1);
  Shelf shelf{x0, x0 + 0.35, y - 0.5, y + 0.5, 0.02, {}, columns};
  for (int i = 0; i <= rows; ++i) shelf.boards.push_back(lowest + height * i);
  HandGoals goals;
  goals.obstacles = boxes_of(shelf);
  const auto in_bin = [&](int row, int column) {
    const double width = 1.0 / columns;
    const double spread = columns > 1 ? 0.03 : 0.25;
    return Hand{{x0 + random.between(0.08, 0.16),
                 shelf.y0 + width * (column + 0.5) + random.between(-spread, spread),
                 lowest + height * (row + 0.5) + random.between(-0.02, 0.02)},
                Eigen::Vector3d::UnitX()};
  };
  const int row = random.below(rows);
  const int column = random.below(columns);
  goals.start = in_bin(row, column);
  if (columns > 1) {
    goals.goal = in_bin(random.below(rows), (column + 1 + random.below(columns - 1)) % columns);
  } else {
    goals.goal = in_bin((row + 1 + random.below(rows - 1)) % rows, 0);
  }
  return goals;
}

const Eigen::Vector3d kDown = -Eigen::Vector3d::UnitZ();

HandGoals in_box(Random& random) {
  HandGoals goals;
  const double x = random.between(0.45, 0.55);
  const double y = random.between(-0.2, 0.2);
  goals.obstacles.push_back(span_box(0.25, 0.95, -0.6, 0.6, -0.04, 0));
  goals.obstacles.push_back(span_box(x - 0.18, x - 0.16, y - 0.2, y + 0.2, 0, 0.25));
  goals.obstacles.push_back(span_box(x + 0.16, x + 0.18, y - 0.2, y + 0.2, 0, 0.25));
  goals.obstacles.push_back(span_box(x - 0.18, x + 0.18, y - 0.22, y - 0.2, 0, 0.25));
  goals.obstacles.push_back(span_box(x - 0.18, x + 0.18, y + 0.2, y + 0.22, 0, 0.25));
  const double side = y > 0 ? -1 : 1;
  goals.start = {{x + random.between(-0.05, 0.1), y + side * random.between(0.38, 0.45), 0.06},
                 kDown};
  goals.goal = {{x + random.between(-0.03, 0.03), y + random.between(-0.05, 0.05), 0.08}, kDown};
  return goals;
}

HandGoals in_cage(Random& random) {
  HandGoals goals;
  const double x = random.between(0.45, 0.55);
  const double y = random.between(-0.15, 0.15);
  goals.obstacles.push_back(span_box(0.25, 0.95, -0.6, 0.6, -0.04, 0));
  // Bars all around up to 0.5 m, a gap of 0.3 m to the arm's side and above.
  for (int i = 0; i < 5; ++i) {
    const double at = -0.26 + 0.13 * i;
    goals.obstacles.push_back(span_box(x + 0.25, x + 0.27, y + at - 0.01, y + at + 0.01, 0, 0.5));
    goals.obstacles.push_back(span_box(x + at - 0.01, x + at + 0.01, y + 0.27, y + 0.29, 0, 0.5));
    goals.obstacles.push_back(span_box(x + at - 0.01, x + at + 0.01, y - 0.29, y - 0.27, 0, 0.5));
  }
  for (const double z : {0.24, 0.48}) {
    goals.obstacles.push_back(span_box(x + 0.25, x + 0.27, y - 0.29, y + 0.29, z, z + 0.02));
    goals.obstacles.push_back(span_box(x - 0.27, x + 0.27, y + 0.27, y + 0.29, z, z + 0.02));
    goals.obstacles.push_back(span_box(x - 0.27, x + 0.27, y - 0.29, y - 0.27, z, z + 0.02));
  }
  const double side = random.below(2) == 0 ? 1 : -1;
  goals.start = {
      {random.between(0.3, 0.4), y + side * random.between(0.45, 0.5), random.between(0.1, 0.2)},
      kDown};
  goals.goal = {{x + random.between(-0.05, 0.05), y + random.between(-0.08, 0.08),
                 random.between(0.06, 0.12)},
                kDown};
  return goals;
}

HandGoals at_table(Random& random, bool under) {
  HandGoals goals;
  const double z = under ? random.between(0.4, 0.5) : 0;
  goals.obstacles.push_back(span_box(0.35, 0.95, -0.5, 0.5, z - 0.04, z));
  const double side = random.below(2) == 0 ? 1 : -1;
  if (under) {
    for (const double y : {-0.48, 0.44}) {
      goals.obstacles.push_back(span_box(0.36, 0.4, y, y + 0.04, 0, z - 0.04));
      goals.obstacles.push_back(span_box(0.9, 0.94, y, y + 0.04, 0, z - 0.04));
    }
    goals.start = {{random.between(0.45, 0.55), random.between(-0.25, 0.25), z + 0.08}, kDown};
    goals.goal = {{random.between(0.45, 0.55), random.between(-0.25, 0.25), z - 0.2},
                  Eigen::Vector3d::UnitX()};
    return goals;
  }
  goals.start = {{random.between(0.4, 0.6), side * random.between(0.3, 0.4), 0.05}, kDown};
  goals.goal = {{random.between(0.4, 0.6), -side * random.between(0.3, 0.4), 0.05}, kDown};
  for (int i = 0; i < 12; ++i) {
    const double x = random.between(0.38, 0.85);
    const double y = random.between(-0.45, 0.45);
    const double h = random.between(0.1, 0.35);
    const auto clear = [&](const Hand& hand) {
      return std::hypot(hand.tip.x() - x, hand.tip.y() - y) > 0.17;
    };
    if (!clear(goals.start) || !clear(goals.goal)) continue;
    goals.obstacles.push_back(span_box(x - 0.03, x + 0.03, y - 0.03, y + 0.03, 0, h));
  }
  return goals;
}

HandGoals goals_of(const std::string& scene, Random& random) {
  if (scene == "shelf") return in_shelf(random, 3, 0.15, 0.27, 1);
  if (scene == "tall_shelf") return in_shelf(random, 3, 0.05, 0.36, 1);
  if (scene == "thin_shelf") return in_shelf(random, 2, 0.2, 0.36, 3);
  if (scene == "box") return in_box(random);
  if (scene == "cage") return in_cage(random);
  return at_table(random, scene == "under_table");
}

}  // namespace

Chain digging_excavator() {
  constexpr double kDegrees = 57.29577951308232;
  Chain chain;
  chain.name = "excavator";
  chain.meets_itself = false;
  const auto box = [](Moves at, double x, double y, double z) {
    return ChainBox{std::move(at), {x, y, z}};
  };
  const double bend = rounded(0.35 * kDegrees);
  chain.links = {{"upper", -1, {}, 'z', 1, -180, 180, 15, {box({shift(-1, 0, 2.1)}, 2, 1.25, 0.9)}},
                 {"boom",
                  0,
                  {shift(0.4, 0, 1.9)},
                  'y',
                  -1,
                  rounded(-0.75 * kDegrees),
                  rounded(0.95 * kDegrees),
                  5.5,
                  {box({turn('y', -bend), shift(1.5, 0, 0)}, 1.6, 0.25, 0.35),
                   box({turn('y', -bend), shift(2.9, 0, 0), turn('y', 2 * bend), shift(1.4, 0, 0)},
                       1.5, 0.22, 0.3)}},
                 {"stick",
                  1,
                  {shift(5.7, 0, 0)},
                  'y',
                  -1,
                  rounded(-2.6 * kDegrees),
                  rounded(-0.45 * kDegrees),
                  22.5,
                  {box({shift(1.2, 0, 0)}, 1.6, 0.18, 0.25)}},
                 {"bucket",
                  2,
                  {shift(2.9, 0, 0)},
                  'y',
                  -1,
                  rounded(-2.4 * kDegrees),
                  rounded(0.6 * kDegrees),
                  31.71,
                  {box({shift(0.7, 0, -0.25)}, 0.7, 0.5, 0.4)}}};
  return chain;
}

std::vector<ChainBox> trench_and_truck(Random* moved) {
  std::vector<ChainBox> boxes = {
      span_box(-15, 4.6, -15, 15, -1, 0),    span_box(9.6, 15, -15, 15, -1, 0),
      span_box(4.6, 9.6, 1.6, 15, -1, 0),    span_box(4.6, 9.6, -15, -1.6, -1, 0),
      span_box(4.6, 9.6, -1.6, 1.6, -4, -3), span_box(4.4, 4.6, -1.6, 1.6, -3, -1),
      span_box(9.6, 9.8, -1.6, 1.6, -3, -1)};
  for (const double x : {5.75, 8.25}) {
    boxes.push_back({{shift(x, 0, -0.9)}, {0.23, 1.6, 0.23}});
    boxes.push_back({{shift(x, 0, -0.9), turn('y', 45)}, {0.23, 1.6, 0.23}});
  }
  const auto truck = [&](double hx, double hy, double hz, double x, double y, double z) {
    boxes.push_back({{turn('z', 150), shift(6.6, 0, 0), shift(x, y, z)}, {hx, hy, hz}});
  };
  truck(1.25, 2.6, 0.1, 0, 0, 1.2);
  truck(0.05, 2.6, 0.65, -1.2, 0, 1.95);
  truck(0.05, 2.6, 0.65, 1.2, 0, 1.95);
  truck(1.25, 0.05, 0.65, 0, 2.55, 1.95);
  truck(1.25, 0.05, 0.65, 0, -2.55, 1.95);
  truck(1.2, 0.9, 1.45, 0, 3.6, 1.45);
  truck(0.9, 2.4, 0.5, 0, 0, 0.5);
  if (moved == nullptr) return boxes;
  for (ChainBox& box : boxes) {
    const double x = rounded(moved->between(-0.3, 0.3));
    const double y = rounded(moved->between(-0.3, 0.3));
    const double z = rounded(moved->between(-0.3, 0.3));
    box.at.insert(box.at.begin(), shift(x, y, z));
    box.at.push_back(turn('z', rounded(moved->between(-15, 15))));
  }
  return boxes;
}

std::optional<ChainProblem> dig_and_dump(const Chain& chain, std::vector<ChainBox> obstacles,
                                         Random& random) {
  ChainProblem problem;
  problem.obstacles = std::move(obstacles);
  const FclChain world(chain, problem.obstacles);
  const auto find = [&](double swing, double radius, double height, double tilt) {
    for (int i = 0; i < 200'000; ++i) {
      std::vector<double> q = drawn(chain, random);
      q[0] = swing;
      if (std::isfinite(tilt)) {
        q[3] = rounded(tilt - q[1] - q[2]);
        if (q[3] < chain.links[3].lower || q[3] > chain.links[3].upper) continue;
      }
      const Eigen::Vector3d middle = chain.poses(q).back() * Eigen::Vector3d(0.7, 0, -0.25);
      const double r = std::hypot(middle.x(), middle.y());
      if (std::hypot(r - radius, middle.z() - height) > 0.35 || !world.free(q)) continue;
      return q;
    }
    return std::vector<double>();
  };
  problem.start = find(0, 7, -2.15, std::nan(""));
  if (problem.start.empty()) return std::nullopt;
  const double tilt = problem.start[1] + problem.start[2] + problem.start[3];
  problem.goal = find(150, 6.6, 3.6, tilt);
  if (problem.goal.empty()) return std::nullopt;
  return problem;
}

Chain seven_axis_arm() {
  Chain arm;
  arm.name = "arm";
  const auto box = [](Moves at, double x, double y, double z) {
    return ChainBox{std::move(at), {x, y, z}};
  };
  constexpr double kBig = 124.6;
  constexpr double kSmall = 149.5;
  arm.links = {
      {"base", -1, {}, '-', 1, 0, 0, 0, {box({shift(-0.05, 0, 0.07)}, 0.1, 0.09, 0.07)}},
      {"link1",
       0,
       {shift(0, 0, 0.333)},
       'z',
       1,
       -166,
       166,
       kBig,
       {box({shift(0, 0, -0.1)}, 0.06, 0.06, 0.09)}},
      {"link2",
       1,
       {turn('x', -90)},
       'z',
       1,
       -101,
       101,
       kBig,
       {box({shift(0, -0.05, 0)}, 0.06, 0.11, 0.06)}},
      {"link3",
       2,
       {shift(0, -0.316, 0), turn('x', 90)},
       'z',
       1,
       -166,
       166,
       kBig,
       {box({shift(0, 0, -0.08)}, 0.06, 0.06, 0.08), box({shift(0.06, 0, 0)}, 0.06, 0.05, 0.06)}},
      {"link4",
       3,
       {shift(0.0825, 0, 0), turn('x', 90)},
       'z',
       1,
       -176,
       -4,
       kBig,
       {box({shift(-0.04, 0.03, 0)}, 0.09, 0.08, 0.06)}},
      {"link5",
       4,
       {shift(-0.0825, 0.384, 0), turn('x', -90)},
       'z',
       1,
       -166,
       166,
       kSmall,
       {box({shift(0, 0, -0.2)}, 0.055, 0.06, 0.09),
        box({shift(0, 0.04, -0.06)}, 0.04, 0.05, 0.09)}},
      {"link6",
       5,
       {turn('x', 90)},
       'z',
       1,
       -1,
       215,
       kSmall,
       {box({shift(0.04, 0, 0)}, 0.09, 0.05, 0.055)}},
      {"link7",
       6,
       {shift(0.088, 0, 0), turn('x', 90)},
       'z',
       1,
       -166,
       166,
       kSmall,
       {box({shift(0, 0, 0.08)}, 0.045, 0.045, 0.035),
        box({turn('z', -45), shift(0, 0, 0.145)}, 0.032, 0.1, 0.035),
        box({turn('z', -45), shift(0, 0, 0.195)}, 0.012, 0.05, 0.015)}}};
  return arm;
}

const std::vector<std::string>& arm_scenes() {
  static const std::vector<std::string> names = {"shelf", "tall_shelf", "thin_shelf", "box",
                                                 "cage",  "on_table",   "under_table"};
  return names;
}

std::optional<ChainProblem> arm_problem(const std::string& scene, const Chain& arm,
                                        Random& random) {
  HandGoals goals = goals_of(scene, random);
  ChainProblem problem;
  problem.obstacles = std::move(goals.obstacles);
  const FclChain world(arm, problem.obstacles);
  const auto find = [&](const Hand& hand) {
    for (int i = 0; i < 40; ++i) {
      auto q = reach(arm, hand, random);
      if (q && world.free(*q)) return *q;
    }
    return std::vector<double>();
  };
  problem.start = find(goals.start);
  if (problem.start.empty()) return std::nullopt;
  problem.goal = find(goals.goal);
  if (problem.goal.empty() || !meets(world, {problem.start, problem.goal}, 0.5)) {
    return std::nullopt;
  }
  return problem;
}

std::vector<ChainBox> scattered(int near, int far, Random& random) {
  std::vector<ChainBox> boxes;
  for (int i = 0; i < near + far; ++i) {
    const double angle = random.between(-180, 180);
    const double away = i < near ? random.between(0.35, 1.1) : random.between(5, 200);
    const double z = i < near ? random.between(0, 1.1) : random.between(0, 20);
    const auto side = [&] { return rounded(random.between(0.02, 0.06)); };
    ChainBox box;
    box.at = {turn('z', rounded(angle)), shift(rounded(away), 0, rounded(z))};
    box.half.x() = side();
    box.half.y() = side();
    box.half.z() = side();
    boxes.push_back(std::move(box));
  }
  return boxes;
}

}  // namespace rubicon::bench
