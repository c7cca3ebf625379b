#include "src/motion/coverage/region.hpp"

#include <algorithm>
#include <polyclipping/clipper.hpp>

namespace rubicon::coverage {
namespace {

/// Units: corners that are nearer than this to each other or to the line of their neighbours go.
constexpr double kSameCorner = 1.5;

ClipperLib::Path path_of(const Ring& ring) {
  ClipperLib::Path path;
  for (const Point& p : ring) path.emplace_back(p.x, p.y);
  if (!ClipperLib::Orientation(path)) ClipperLib::ReversePath(path);
  return path;
}

ClipperLib::Paths paths_of(const std::vector<Ring>& rings) {
  ClipperLib::Paths paths;
  for (const Ring& ring : rings) paths.push_back(path_of(ring));
  return paths;
}

/// Counter-clockwise, from its least corner; empty if there is nothing of any size.
Ring ring_of(ClipperLib::Path path) {
  ClipperLib::CleanPolygon(path, kSameCorner);
  Ring ring;
  for (const ClipperLib::IntPoint& p : path) ring.push_back({p.X, p.Y});
  if (ring.size() < 3) return {};
  const std::int64_t area = twice_area(ring);
  if (area == 0) return {};
  if (area < 0) std::reverse(ring.begin(), ring.end());
  std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
  return ring;
}

void add_regions(const ClipperLib::PolyNode& node, std::vector<Region>& regions) {
  for (const ClipperLib::PolyNode* outer : node.Childs) {
    Region region;
    region.outline = ring_of(outer->Contour);
    for (const ClipperLib::PolyNode* hole : outer->Childs) {
      Ring ring = ring_of(hole->Contour);
      if (!ring.empty()) region.holes.push_back(std::move(ring));
      add_regions(*hole, regions);
    }
    std::sort(region.holes.begin(), region.holes.end());
    if (!region.outline.empty()) regions.push_back(std::move(region));
  }
}

std::vector<Region> regions_of(const ClipperLib::PolyTree& tree) {
  std::vector<Region> regions;
  add_regions(tree, regions);
  std::sort(regions.begin(), regions.end(),
            [](const Region& a, const Region& b) { return a.outline < b.outline; });
  return regions;
}

std::vector<Region> combined(const ClipperLib::Paths& subject, const ClipperLib::Paths& clip,
                             ClipperLib::ClipType how, ClipperLib::PolyFillType inside) {
  ClipperLib::Clipper clipper;
  clipper.StrictlySimple(true);
  clipper.AddPaths(subject, ClipperLib::ptSubject, true);
  clipper.AddPaths(clip, ClipperLib::ptClip, true);
  ClipperLib::PolyTree tree;
  clipper.Execute(how, tree, inside, ClipperLib::pftNonZero);
  return regions_of(tree);
}

}  // namespace

std::int64_t twice_area(const Region& region) {
  std::int64_t area = twice_area(region.outline);
  for (const Ring& hole : region.holes) area -= twice_area(hole);
  return area;
}

std::vector<Region> united(const std::vector<Ring>& rings, std::int64_t gap) {
  ClipperLib::Paths paths;
  ClipperLib::Clipper clipper;
  clipper.AddPaths(paths_of(rings), ClipperLib::ptSubject, true);
  clipper.Execute(ClipperLib::ctUnion, paths, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  if (gap > 0) {
    // Grown and shrunk again: what the growth has filled for good was narrower than the gap.
    const double half = static_cast<double>(gap) / 2;
    for (const double by : {half, -half}) {
      ClipperLib::ClipperOffset offset;
      offset.AddPaths(paths, ClipperLib::jtMiter, ClipperLib::etClosedPolygon);
      offset.Execute(paths, by);
    }
  }
  return combined(paths, {}, ClipperLib::ctUnion, ClipperLib::pftNonZero);
}

std::vector<Region> nested(const std::vector<Ring>& rings) {
  return combined(paths_of(rings), {}, ClipperLib::ctUnion, ClipperLib::pftEvenOdd);
}

std::vector<Region> difference(const std::vector<Region>& regions, const std::vector<Ring>& rings) {
  ClipperLib::Paths paths;
  for (const Region& region : regions) {
    paths.push_back(path_of(region.outline));
    for (const Ring& hole : region.holes) {
      paths.push_back(path_of(hole));
      ClipperLib::ReversePath(paths.back());
    }
  }
  return combined(paths, paths_of(rings), ClipperLib::ctDifference, ClipperLib::pftNonZero);
}

std::vector<Region> inside_outline(const std::vector<Ring>& rings, const Region& region,
                                   std::int64_t inset) {
  ClipperLib::ClipperOffset offset;
  offset.AddPath(path_of(region.outline), ClipperLib::jtMiter, ClipperLib::etClosedPolygon);
  ClipperLib::Paths inner;
  offset.Execute(inner, -static_cast<double>(inset));
  return combined(paths_of(rings), inner, ClipperLib::ctIntersection, ClipperLib::pftNonZero);
}

}  // namespace rubicon::coverage
