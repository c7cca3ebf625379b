#include "src/collision/body.hpp"

#include <algorithm>
#include <utility>

namespace rubicon::collision {
namespace {

/// More corners than this add nothing to a test of containment.
constexpr std::size_t kProbesPerPiece = 8;

}  // namespace

Body::Body(std::vector<ConvexPiece> pieces, std::vector<TriangleSoup> soups, const Vec3& centre)
    : pieces_(std::move(pieces)), soups_(std::move(soups)) {
  extent_.centre = centre;
  const auto reach_to = [this](const Vec3& point, double disc) {
    extent_.radius = std::max(extent_.radius, point.norm() + disc);
    extent_.reach = std::max(extent_.reach, (point + extent_.centre).norm() + disc);
  };
  for (const ConvexPiece& piece : pieces_) {
    convexes_.push_back(piece.view());
    bounds_.add(piece.bounds);
    Vec3 mean = Vec3::Zero();
    for (const Vec3& vertex : piece.vertices) {
      reach_to(vertex, piece.disc);
      mean += vertex / static_cast<double>(piece.vertices.size());
    }
    probes_.push_back(mean);
    const std::size_t corners = std::min(piece.vertices.size(), kProbesPerPiece);
    probes_.insert(probes_.end(), piece.vertices.begin(),
                   piece.vertices.begin() + static_cast<std::ptrdiff_t>(corners));
  }
  for (const TriangleSoup& soup : soups_) {
    bounds_.add(soup.bounds());
    for (const auto& triangle : soup.triangles()) {
      for (const int index : triangle) reach_to(soup.vertices()[index], 0);
    }
    probes_.insert(probes_.end(), soup.probes().begin(), soup.probes().end());
    has_closed_soup_ = has_closed_soup_ || soup.closed();
  }
}

}  // namespace rubicon::collision
