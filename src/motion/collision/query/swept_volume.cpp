#include "src/motion/collision/query/swept_volume.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "src/motion/collision/pair/standing_body.hpp"
#include "src/motion/collision/sweep/swept_piece.hpp"

namespace rubicon::collision {
namespace {

/// No slice is shorter than this share of the motion: one that still is too large is taken for what
/// is swept.
constexpr double kShortestSlice = 1e-6;
/// Slices one moving body may look at before it is said to meet the volume: some tenths of a
/// second.
constexpr int kMostSlicesLookedAt = 1 << 14;
/// Slices that are kept; beyond it all are made anew.
constexpr std::size_t kMostSlicesKept = 1 << 16;

/// A convex piece of a body, or the triangles below a node of the tree of one of its meshes.
struct Swept {
  int piece = -1;
  int soup = -1;
  int node = 0;
};

/// A slice of the motion of one of them, or of two halves.
struct VolumeSlice {
  Swept swept;
  double s0 = 0;
  double s1 = 1;
  Bounds bounds;  ///< of all that is swept, world
  BodyPtr cover;  ///< around all that is swept; made when something is in the bounds
  StandingPlace place;
  double excess = 0;         ///< m, of the cover
  bool splits_mesh = false;  ///< its halves are two parts of the mesh, not of the way
  int first_half = -1;       ///< the second one follows
};

BodyPtr body_of(std::vector<ConvexPiece> pieces) {
  return std::make_shared<const Body>(std::move(pieces), std::vector<TriangleSoup>(),
                                      Vec3(Vec3::Zero()));
}

/// A box as a piece of no width, so that nothing is allowed to be deep in it.
ConvexPiece box_piece(const Bounds& bounds) {
  ConvexPiece piece;
  for (int corner = 0; corner < 8; ++corner) {
    piece.vertices.emplace_back((corner & 1) ? bounds.upper.x() : bounds.lower.x(),
                                (corner & 2) ? bounds.upper.y() : bounds.lower.y(),
                                (corner & 4) ? bounds.upper.z() : bounds.lower.z());
  }
  piece.normals = {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
  piece.edges = piece.normals;
  piece.bounds = bounds;
  return piece;
}

}  // namespace

MovingBodies::MovingBodies(const SweptQuery& query) : contact_tolerance_(query.contact_tolerance) {
  for (const SweptQuery::Item& item : query.items) {
    sweeps_.push_back(std::make_unique<Sweep>(*item.moving.body, item.moving.motion));
    bounds_.add(sweeps_.back()->bounds());
  }
}

MovingBodies::~MovingBodies() = default;

Bounds MovingBodies::bounds_between(double s0, double s1) const {
  Bounds result;
  for (const auto& sweep : sweeps_) result.add(sweep->bounds_between(s0, s1));
  return result;
}

class SweptVolume::Impl {
 public:
  Impl(BodyPtr body, Motion motion, double growth)
      : body_(std::move(body)),
        motion_(std::move(motion)),
        growth_(growth),
        bounds_(Sweep(*body_, motion_).bounds()) {}

  const Bounds& bounds() const { return bounds_; }

  bool meets(Sweep& sweep, double tolerance) {
    if (sweep.bounds().disjoint(bounds_)) return false;
    if (!motion_.moves()) return met_at(sweep, 0, tolerance);
    // What is inside a closed mesh crosses no surface, so its inside is looked at where the motion
    // begins and ends. Whoever is inside only in between has crossed what the surface sweeps.
    if (body_->has_closed_soup() && (met_at(sweep, 0, tolerance) || met_at(sweep, 1, tolerance))) {
      return true;
    }
    if (slices_.empty() || slices_.size() > kMostSlicesKept) begin();
    int looked_at = 0;
    for (int i = 0; i < whole_; ++i) {
      if (slice_met(i, sweep, tolerance, looked_at)) return true;
    }
    return false;
  }

 private:
  /// One slice for each piece and each mesh.
  void begin() {
    slices_.clear();
    const PieceSlice way(*body_, motion_, 0, 1);
    for (int i = 0; i < static_cast<int>(body_->convexes().size()); ++i) {
      add({i, -1, 0}, 0, 1, way);
    }
    for (int i = 0; i < static_cast<int>(body_->soups().size()); ++i) add({-1, i, 0}, 0, 1, way);
    whole_ = static_cast<int>(slices_.size());
  }

  void add(const Swept& swept, double s0, double s1, const PieceSlice& way) {
    VolumeSlice& slice = slices_.emplace_back();
    slice.swept = swept;
    slice.s0 = s0;
    slice.s1 = s1;
    slice.bounds = way.bounds(own_bounds(swept));
  }

  const TriangleSoup::Node& mesh_node(const Swept& swept) const {
    return body_->soups()[static_cast<std::size_t>(swept.soup)]
        .nodes()[static_cast<std::size_t>(swept.node)];
  }

  /// A node of the tree of a mesh that is not a leaf.
  bool is_branch(const Swept& swept) const {
    return swept.soup >= 0 && mesh_node(swept).count == 0;
  }

  const Bounds& own_bounds(const Swept& swept) const {
    if (swept.soup >= 0) return mesh_node(swept).bounds;
    return body_->convexes()[static_cast<std::size_t>(swept.piece)].bounds;
  }

  bool met_at(Sweep& sweep, double s, double tolerance) const {
    return blocked_by_standing(sweep, *body_, StandingPlace(*body_, motion_.pose(s)), tolerance);
  }

  bool slice_met(int index, Sweep& sweep, double tolerance, int& looked_at) {
    if (sweep.bounds().disjoint(at(index).bounds)) return false;
    if (++looked_at > kMostSlicesLookedAt) return true;
    if (!at(index).cover) make_cover(at(index));
    const VolumeSlice slice = at(index);
    if (!blocked_by_standing(sweep, *slice.cover, slice.place, tolerance)) return false;
    if (!slice.splits_mesh && (slice.excess <= growth_ || slice.s1 - slice.s0 <= kShortestSlice)) {
      return true;
    }
    if (!is_branch(slice.swept) && met_in_the_middle(slice, sweep, tolerance)) return true;
    if (slice.first_half < 0) halve(index);
    const int first = at(index).first_half;
    return slice_met(first, sweep, tolerance, looked_at) ||
           slice_met(first + 1, sweep, tolerance, looked_at);
  }

  VolumeSlice& at(int index) { return slices_[static_cast<std::size_t>(index)]; }

  /// A pose that is met says the same as its slice, and sooner than its halves.
  bool met_in_the_middle(const VolumeSlice& slice, Sweep& sweep, double tolerance) const {
    const double middle = 0.5 * (slice.s0 + slice.s1);
    if (body_->parts().size() == 1 && slice.swept.piece >= 0) {
      return met_at(sweep, middle, tolerance);
    }
    const PieceSlice pose(*body_, motion_, middle, middle);
    std::vector<ConvexPiece> pieces;
    visit_pieces(slice.swept, [&](const Convex& piece) { pieces.push_back(pose.standing(piece)); });
    const BodyPtr body = body_of(std::move(pieces));
    return blocked_by_standing(sweep, *body, StandingPlace(*body, at_origin(pose)), tolerance);
  }

  static Pose at_origin(const PieceSlice& way) {
    Pose X = Pose::Identity();
    X.translation() = way.origin();
    return X;
  }

  /// The convex piece, or the triangles of a leaf.
  template <typename Visit>
  void visit_pieces(const Swept& swept, const Visit& visit) const {
    if (swept.piece >= 0) {
      visit(body_->convexes()[static_cast<std::size_t>(swept.piece)]);
      return;
    }
    const TriangleSoup& soup = body_->soups()[static_cast<std::size_t>(swept.soup)];
    const TriangleSoup::Node& node = mesh_node(swept);
    for (int i = node.first; i < node.first + node.count; ++i) {
      visit(TrianglePiece(soup.corner(i, 0), soup.corner(i, 1), soup.corner(i, 2)).view());
    }
  }

  void make_cover(VolumeSlice& slice) const {
    const PieceSlice way(*body_, motion_, slice.s0, slice.s1);
    std::vector<ConvexPiece> pieces;
    const auto sweep_piece = [&](const Convex& piece) {
      SweptPiece swept = way.sweep(piece, growth_);
      slice.excess = std::max(slice.excess, swept.excess);
      pieces.push_back(std::move(swept.piece));
    };
    if (is_branch(slice.swept)) {
      const Bounds& bounds = mesh_node(slice.swept).bounds;
      sweep_piece(box_piece(bounds).view());
      // Whichever is larger of what the box has too much is cut first.
      slice.splits_mesh = slice.excess <= std::max(growth_, bounds.half().norm());
    } else {
      visit_pieces(slice.swept, sweep_piece);
    }
    slice.cover = body_of(std::move(pieces));
    slice.place = StandingPlace(*slice.cover, at_origin(way));
  }

  void halve(int index) {
    const VolumeSlice slice = at(index);
    at(index).first_half = static_cast<int>(slices_.size());
    if (slice.splits_mesh) {
      const PieceSlice way(*body_, motion_, slice.s0, slice.s1);
      const int first = mesh_node(slice.swept).first;
      for (const int node : {first, first + 1}) {
        add({-1, slice.swept.soup, node}, slice.s0, slice.s1, way);
      }
      return;
    }
    const double middle = 0.5 * (slice.s0 + slice.s1);
    const std::array<double, 3> ends = {slice.s0, middle, slice.s1};
    for (std::size_t i = 0; i < 2; ++i) {
      const PieceSlice way(*body_, motion_, ends[i], ends[i + 1]);
      add(slice.swept, ends[i], ends[i + 1], way);
    }
  }

  BodyPtr body_;
  Motion motion_;
  double growth_;
  Bounds bounds_;
  std::vector<VolumeSlice> slices_;
  int whole_ = 0;  ///< the first of them are those of the whole motion
};

SweptVolume::SweptVolume(BodyPtr body, Motion motion, double growth)
    : impl_(std::make_unique<Impl>(std::move(body), std::move(motion), growth)) {}
SweptVolume::~SweptVolume() = default;
SweptVolume::SweptVolume(SweptVolume&&) noexcept = default;
SweptVolume& SweptVolume::operator=(SweptVolume&&) noexcept = default;

const Bounds& SweptVolume::bounds() const { return impl_->bounds(); }

bool SweptVolume::meets(MovingBodies& bodies, int item) const {
  return impl_->meets(*bodies.sweeps_[static_cast<std::size_t>(item)], bodies.contact_tolerance_);
}

}  // namespace rubicon::collision
