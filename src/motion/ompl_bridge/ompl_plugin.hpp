#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace rubicon::ompl_bridge {

using Point = std::vector<double>;

/// What a planner of OMPL asks: configurations are points, with a coordinate for each parameter.
class Question {
 public:
  virtual ~Question() = default;
  virtual std::size_t size() const = 0;
  virtual double lower(std::size_t i) const = 0;
  virtual double upper(std::size_t i) const = 0;
  virtual double weight(std::size_t i) const = 0;
  /// Whether it is an angle that turns freely, from -180 to 180.
  virtual bool cyclic(std::size_t i) const = 0;
  /// Whether a sum of parameters is kept, so that not all within the ranges may be taken.
  virtual bool keeps() const = 0;
  /// Whether a leg is free if it is free the other way round.
  virtual bool symmetric() const = 0;
  /// Of a vehicle that turns no narrower than a radius: then distances are lengths of its ways, and
  /// places between two others lie on them.
  virtual bool steers() const { return false; }
  virtual double distance(std::span<const double>, std::span<const double>) const { return 0; }
  virtual Point partway(std::span<const double> a, std::span<const double>, double) const {
    return {a.begin(), a.end()};
  }
  /// Moves a point into the ranges, and to where what is kept holds.
  virtual void fit(Point& point) const = 0;
  virtual bool stands(std::span<const double> point) = 0;
  virtual bool leg_is_free(std::span<const double> a, std::span<const double> b) = 0;
  /// Whether no more tests may be made.
  virtual bool spent() const = 0;
};

struct Asked {
  std::string planner;                                   ///< its name in OMPL
  std::vector<std::pair<std::string, double>> settings;  ///< its parameters
  double seed = 1;
  double range = 0;  ///< its longest leg, weighted; 0: as OMPL sets it
  double nodes = 0;  ///< configurations that it may keep
  bool tells_tree = false;
  Point start, goal;
};

struct Answer {
  std::vector<Point> way;  ///< start first, goal last; none: no way
  std::size_t nodes = 0;   ///< of its trees or its graph at the end
  bool out_of_nodes = false;
  std::string cause;  ///< of no way, where it was not that tests or nodes ran out
  std::vector<std::pair<Point, Point>> tree;  ///< edges, where they were asked for
};

/// What the loaded file gives. It is built together with the command, so both know the same types.
struct OmplPlugin {
  /// One at a time: OMPL has one source of seeds for all.
  Answer (*plan)(Question& question, const Asked& asked);
  /// The parameters of a planner, by their names in OMPL; none of a planner that is not there.
  std::vector<std::string> (*parameters)(const std::string& planner);
  const char* version;  ///< of OMPL
};
inline constexpr int kOmplPluginVersion = 2;
/// The name of the function in the file: `const OmplPlugin* rubicon_ompl(int version)`.
inline constexpr const char* kOmplBegin = "rubicon_ompl";

}  // namespace rubicon::ompl_bridge
