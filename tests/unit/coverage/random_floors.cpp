#include "tests/unit/coverage/random_floors.hpp"

#include <algorithm>
#include <map>

#include "src/motion/math/angles.hpp"
#include "src/motion/math/index.hpp"

namespace rubicon::coverage {
namespace {

using math::at;

bool is_floor(const Chequer& chequer, int row, int column) {
  return row >= 0 && column >= 0 && row < static_cast<int>(chequer.floor.size()) &&
         column < static_cast<int>(chequer.floor[0].size()) && chequer.floor[at(row)][at(column)];
}

/// Neither a corner where only squares across from each other are floor, nor shafts that touch the
/// outside in a corner.
bool is_clean(const Chequer& chequer) {
  for (int row = 0; row <= static_cast<int>(chequer.floor.size()); ++row) {
    for (int column = 0; column <= static_cast<int>(chequer.floor[0].size()); ++column) {
      const bool a = is_floor(chequer, row - 1, column - 1);
      const bool b = is_floor(chequer, row - 1, column);
      const bool c = is_floor(chequer, row, column - 1);
      const bool d = is_floor(chequer, row, column);
      if ((a && d && !b && !c) || (b && c && !a && !d)) return false;
    }
  }
  return true;
}

void keep_largest_part(Chequer& chequer) {
  const int rows = static_cast<int>(chequer.floor.size());
  const int columns = static_cast<int>(chequer.floor[0].size());
  std::vector<std::vector<int>> part(at(rows), std::vector<int>(at(columns), -1));
  std::vector<int> sizes;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      if (!is_floor(chequer, row, column) || part[at(row)][at(column)] >= 0) continue;
      const int number = static_cast<int>(sizes.size());
      sizes.push_back(0);
      std::vector<std::pair<int, int>> open{{row, column}};
      part[at(row)][at(column)] = number;
      while (!open.empty()) {
        const auto [r, c] = open.back();
        open.pop_back();
        ++sizes.back();
        for (const auto& [dr, dc] : {std::pair(0, 1), {1, 0}, {0, -1}, {-1, 0}}) {
          if (!is_floor(chequer, r + dr, c + dc) || part[at(r + dr)][at(c + dc)] >= 0) continue;
          part[at(r + dr)][at(c + dc)] = number;
          open.emplace_back(r + dr, c + dc);
        }
      }
    }
  }
  const int best = static_cast<int>(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      if (part[at(row)][at(column)] != best) chequer.floor[at(row)][at(column)] = false;
    }
  }
}

int try_from(std::vector<std::vector<bool>>& open, int used, int best) {
  const int rows = static_cast<int>(open.size());
  const int columns = static_cast<int>(open[0].size());
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      if (!open[at(row)][at(column)]) continue;
      if (used + 1 >= best) return best;
      int reach = columns;
      for (int bottom = row; bottom < rows && open[at(bottom)][at(column)]; ++bottom) {
        int right = column;
        while (right < reach && open[at(bottom)][at(right)]) ++right;
        reach = right;
        for (int end = column + 1; end <= reach; ++end) {
          const auto fill = [&](bool value) {
            for (int r = row; r <= bottom; ++r) {
              for (int c = column; c < end; ++c) open[at(r)][at(c)] = value;
            }
          };
          fill(false);
          best = try_from(open, used + 1, best);
          fill(true);
        }
      }
      return best;
    }
  }
  return std::min(used, best);
}

}  // namespace

std::vector<Place> box(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

Chequer random_chequer(FloorRandom& random, int columns, int rows, double most_pitch) {
  while (true) {
    Chequer chequer;
    chequer.x = {0};
    chequer.y = {0};
    for (int i = 0; i < columns; ++i) {
      chequer.x.push_back(chequer.x.back() + random.between(0.3 * most_pitch, most_pitch));
    }
    for (int i = 0; i < rows; ++i) {
      chequer.y.push_back(chequer.y.back() + random.between(0.3 * most_pitch, most_pitch));
    }
    const int share = 5 + random.below(4);
    for (int row = 0; row < rows; ++row) {
      chequer.floor.emplace_back();
      for (int column = 0; column < columns; ++column) {
        chequer.floor.back().push_back(random.below(10) < share);
      }
    }
    bool any = false;
    for (const auto& row : chequer.floor) any = any || std::count(row.begin(), row.end(), true) > 0;
    if (!any) continue;
    keep_largest_part(chequer);
    if (is_clean(chequer)) return chequer;
  }
}

FloorDescription floor_of(const Chequer& chequer) {
  // The edges of squares with no floor beyond, floor on their left.
  std::map<std::pair<int, int>, std::pair<int, int>> next;
  for (int row = 0; row < static_cast<int>(chequer.floor.size()); ++row) {
    for (int column = 0; column < static_cast<int>(chequer.floor[0].size()); ++column) {
      if (!is_floor(chequer, row, column)) continue;
      if (!is_floor(chequer, row - 1, column)) next[{row, column}] = {row, column + 1};
      if (!is_floor(chequer, row + 1, column)) next[{row + 1, column + 1}] = {row + 1, column};
      if (!is_floor(chequer, row, column - 1)) next[{row + 1, column}] = {row, column};
      if (!is_floor(chequer, row, column + 1)) next[{row, column + 1}] = {row + 1, column + 1};
    }
  }
  FloorDescription floor;
  while (!next.empty()) {
    std::vector<Place> ring;
    for (auto it = next.begin(); it != next.end();) {
      const auto [row, column] = it->first;
      ring.push_back({chequer.x[at(column)], chequer.y[at(row)]});
      const auto to = it->second;
      next.erase(it);
      it = next.find(to);
    }
    double area = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Place& a = ring[i];
      const Place& b = ring[(i + 1) % ring.size()];
      area += a.x * b.y - a.y * b.x;
    }
    if (area > 0) {
      floor.outline = ring;
    } else {
      floor.shafts.push_back({"", ring});
    }
  }
  return floor;
}

int fewest_by_trying(const Chequer& chequer) {
  std::vector<std::vector<bool>> open = chequer.floor;
  return try_from(open, 0, 1000);
}

std::vector<Place> random_star(FloorRandom& random, const Place& centre, double least, double most,
                               int corners) {
  std::vector<Place> result;
  for (int i = 0; i < corners; ++i) {
    const double angle = (i + random.between(0, 0.8)) * 360 / corners;
    const double radius = random.between(least, most);
    result.push_back(
        {centre.x + radius * math::cos_deg(angle), centre.y + radius * math::sin_deg(angle)});
  }
  return result;
}

/// Adds what stands without faults.
void add_columns(FloorRandom& random, FloorDescription& floor, const CoverageOptions& options,
                 double reach, int most) {
  const int count = random.below(most + 1);
  for (int i = 0; i < count; ++i) {
    floor.columns.push_back({"",
                             {random.between(-reach, reach), random.between(-reach, reach)},
                             random.between(0.2, 0.8),
                             random.below(2) == 0});
    if (!faults_of(floor, options).empty()) floor.columns.pop_back();
  }
}

FloorDescription random_general_floor(FloorRandom& random, const CoverageOptions& options) {
  FloorDescription floor;
  do {
    floor.outline = random_star(random, {0, 0}, 4, 15, 5 + random.below(8));
  } while (!faults_of(floor, options).empty());
  const int shafts = random.below(4);
  for (int i = 0; i < shafts; ++i) {
    const Place centre{random.between(-8, 8), random.between(-8, 8)};
    floor.shafts.push_back({"", random_star(random, centre, 0.4, 2, 3 + random.below(5))});
    if (!faults_of(floor, options).empty()) floor.shafts.pop_back();
  }
  add_columns(random, floor, options, 10, 5);
  return floor;
}

FloorDescription random_orthogonal_floor(FloorRandom& random, const CoverageOptions& options) {
  FloorDescription floor = floor_of(
      random_chequer(random, 2 + random.below(4), 2 + random.below(4), random.between(2, 8)));
  add_columns(random, floor, options, 20, 8);
  return floor;
}

std::vector<FloorCase> ten_floors() {
  std::vector<FloorCase> floors;
  const auto add = [&](const char* name, std::vector<Place> outline,
                       std::vector<ShaftDescription> shafts, double most) {
    FloorDescription floor;
    floor.outline = std::move(outline);
    floor.shafts = std::move(shafts);
    floors.push_back({name, std::move(floor), most});
  };
  add("30 x 12 m", box(0, 0, 30, 12), {}, 1.04);
  add("L", {{0, 0}, {30, 0}, {30, 10}, {12, 10}, {12, 25}, {0, 25}}, {}, 1.07);
  add("U", {{0, 0}, {36, 0}, {36, 20}, {26, 20}, {26, 9}, {10, 9}, {10, 20}, {0, 20}}, {}, 1.09);
  add("plus",
      {{10, 0},
       {20, 0},
       {20, 10},
       {30, 10},
       {30, 20},
       {20, 20},
       {20, 30},
       {10, 30},
       {10, 20},
       {0, 20},
       {0, 10},
       {10, 10}},
      {}, 1.11);
  add("ring", box(0, 0, 30, 30), {{"", box(10, 10, 20, 20)}}, 1.07);
  add("three shafts", box(0, 0, 24, 18),
      {{"", box(4, 4, 7, 8)}, {"", box(14, 4, 17, 8)}, {"", box(9, 11, 13, 14)}}, 1.12);
  add("trapezium", {{0, 0}, {25, 0}, {25, 15}, {10, 15}}, {}, 1.2);
  add("five corners", {{0, 0}, {20, -6}, {30, 6}, {18, 18}, {2, 14}}, {}, 1.25);
  add("notch", {{0, 0}, {28, 0}, {28, 16}, {14, 8}, {0, 16}}, {}, 1.25);
  add("slanted shaft", box(0, 0, 26, 14), {{"", {{8, 5}, {12, 4}, {13, 9}, {9, 10}}}}, 1.2);
  return floors;
}

}  // namespace rubicon::coverage
