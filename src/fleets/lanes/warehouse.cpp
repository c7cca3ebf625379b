#include "src/fleets/lanes/warehouse.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

namespace rubicon::lanes {
namespace {

constexpr double kModule = 18;        // m, as the paper's 60 feet
constexpr double kLaneApart = 4;      // m, between the middles of the two lanes of a travelway
constexpr double kIntersection = 8;   // m, across the travelway between rows
constexpr double kGateDistance = 40;  // m, from the modules to the highway
constexpr double kRowPitch = kModule + kIntersection;
constexpr double kCorridorPitch = 2 * kModule + 2 * kLaneApart;

enum Class { kHighway, kFreeway, kAlley };

class Builder {
 public:
  explicit Builder(const WarehouseQuery& query) : query_(query), last_(2 * query.rows) {
    result_.classes = {query.highway, query.freeway, query.alley};
  }

  NetworkDescription build() {
    for (int x = 0; x < query_.corridors; ++x) add_gate_nodes(x);
    for (int x = 0; x < query_.corridors; ++x) add_corridor_nodes(x);
    // Straight on before turning: of ways equally good the first lanes count.
    for (int x = 0; x < query_.corridors; ++x) add_modules(x);
    for (int x = 0; x + 1 < query_.corridors; ++x) add_travelways_between(x, x + 1);
    for (int x = 0; x < query_.corridors; ++x) add_entries(x);
    add_highway();
    return std::move(result_);
  }

 private:
  static std::string letter(int x) { return std::string(1, static_cast<char>('A' + x)); }
  static std::string near_gate(int x) { return letter(x); }
  static std::string far_gate(int x) { return letter(x) + letter(x); }
  static std::string middle(int x, int n) { return fmt::format("{0}{0}{1}", letter(x), n); }
  static std::string entrance(int x, int n) { return fmt::format("{}{}", letter(x), n); }
  static std::string exit(int x, int n) { return fmt::format("{0}{1}{0}{2}", letter(x), n, n + 2); }
  // The module across the corridor: 11 - n of ten.
  int across_from(int n) const { return last_ + 1 - n; }

  void add_node(const std::string& name, double x, double y, double heading_deg) {
    index_[name] = static_cast<NodeIndex>(result_.nodes.size());
    result_.nodes.push_back({name, x, y, heading_deg, true});
  }

  LaneIndex add_lane(const std::string& from, const std::string& to, Class its_class,
                     double seconds) {
    const double speed = result_.classes[static_cast<std::size_t>(its_class)].speed;
    result_.lanes.push_back({index_.at(from), index_.at(to), its_class, seconds * speed, kNone});
    return static_cast<LaneIndex>(result_.lanes.size()) - 1;
  }

  struct Ends {
    std::string from;
    std::string to;
  };

  // The two lanes of a travelway, one beside the other.
  void add_pair(const Ends& one, const Ends& other, Class its_class, double seconds) {
    const LaneIndex first = add_lane(one.from, one.to, its_class, seconds);
    const LaneIndex second = add_lane(other.from, other.to, its_class, seconds);
    result_.lanes[static_cast<std::size_t>(first)].beside = second;
  }

  static double corridor_y(int x) { return -kCorridorPitch * x; }
  double far_end() const { return kRowPitch * query_.rows - kIntersection; }

  void add_gate_nodes(int x) {
    add_node(near_gate(x), -kGateDistance, corridor_y(x), 0);
    if (query_.far_gates) add_node(far_gate(x), far_end() + kGateDistance, corridor_y(x), 180);
  }

  bool has_middle(int x) const { return x > 0 || query_.middle_node_at_first_gate; }

  void add_corridor_nodes(int x) {
    const double odd_y = corridor_y(x) - kLaneApart / 2;
    const double even_y = corridor_y(x) + kLaneApart / 2;
    if (has_middle(x)) add_node(middle(x, 1), -kGateDistance / 2, odd_y, 0);
    for (int row = 0; row < query_.rows; ++row) {
      const int n = 2 * row + 1;
      const double near = kRowPitch * row;
      add_node(entrance(x, n), near, odd_y, 0);
      add_node(exit(x, n), near + kModule, odd_y, 0);
      add_node(entrance(x, across_from(n)), near + kModule, even_y, 180);
      add_node(exit(x, across_from(n)), near, even_y, 180);
    }
  }

  void add_modules(int x) {
    for (int n = 1; n < last_; n += 2) {
      const int m = across_from(n);
      add_pair({entrance(x, n), exit(x, n)}, {entrance(x, m), exit(x, m)}, kAlley, query_.along);
    }
    for (int n = 1; n + 2 < last_; n += 2) {
      const int m = across_from(n);
      add_pair({exit(x, n), entrance(x, n + 2)}, {exit(x, m - 2), entrance(x, m)}, kAlley,
               query_.inside);
    }
    // Into the lane across the corridor: on the way to lower letters, then to higher ones.
    for (int n = 1; n < last_; n += 2) {
      const int m = across_from(n);
      add_lane(exit(x, n), entrance(x, m), kAlley, query_.inside);
      if (n + 2 < last_) add_lane(exit(x, m - 2), entrance(x, n + 2), kAlley, query_.inside);
    }
  }

  // The travelways between the rows, to the next higher letter and back.
  void add_travelways_between(int low, int high) {
    for (int n = 1; n < last_; n += 2) {
      const int m = across_from(n);
      if (n + 2 < last_) {
        add_pair({entrance(high, m), exit(low, n)}, {entrance(low, n + 2), exit(high, m - 2)},
                 kFreeway, query_.across);
      } else {
        add_lane(entrance(high, m), exit(low, n), kFreeway, query_.across);
      }
    }
  }

  void add_entries(int x) {
    if (has_middle(x)) {
      add_lane(near_gate(x), middle(x, 1), kFreeway, query_.entry / 2);
      add_lane(middle(x, 1), entrance(x, 1), kFreeway, query_.entry / 2);
    } else {
      add_lane(near_gate(x), entrance(x, 1), kFreeway, query_.entry);
    }
    add_lane(exit(x, last_), near_gate(x), kFreeway, query_.entry);
    if (!query_.far_gates) return;
    add_lane(far_gate(x), entrance(x, 2), kFreeway, query_.entry);
    add_lane(exit(x, last_ - 1), far_gate(x), kFreeway, query_.entry);
  }

  void add_highway_between(const std::string& a, const std::string& b, double seconds) {
    add_pair({a, b}, {b, a}, kHighway, seconds);
  }

  void add_highway() {
    for (int x = 0; x + 1 < query_.corridors; ++x) {
      add_highway_between(near_gate(x), near_gate(x + 1), query_.hop);
      if (query_.far_gates) add_highway_between(far_gate(x), far_gate(x + 1), query_.hop);
    }
    if (!query_.far_gates) return;
    add_highway_between(near_gate(0), far_gate(0), query_.round);
    if (query_.corridors > 1) {
      const int end = query_.corridors - 1;
      add_highway_between(near_gate(end), far_gate(end), query_.round);
    }
  }

  const WarehouseQuery& query_;
  int last_;  // the highest module number
  NetworkDescription result_;
  std::map<std::string, NodeIndex> index_;
};

}  // namespace

NetworkDescription warehouse(const WarehouseQuery& query) {
  if (query.corridors < 1 || query.corridors > 26) {
    throw std::invalid_argument(
        fmt::format("warehouse: expected 1 to 26 corridors, found {}", query.corridors));
  }
  if (query.rows < 1 || query.rows > 10'000) {
    throw std::invalid_argument(
        fmt::format("warehouse: expected 1 to 10000 rows, found {}", query.rows));
  }
  const std::pair<const char*, double> times[] = {
      {"along", query.along}, {"inside", query.inside}, {"across", query.across},
      {"entry", query.entry}, {"hop", query.hop},       {"round", query.round}};
  for (const auto& [name, seconds] : times) {
    if (seconds > 0 && std::isfinite(seconds)) continue;
    throw std::invalid_argument(
        fmt::format("warehouse: expected a time {} above 0 s, found {}", name, seconds));
  }
  return Builder(query).build();
}

}  // namespace rubicon::lanes
