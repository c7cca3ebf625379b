#include "src/motion/travel/outline.hpp"

#include <algorithm>
#include <numeric>
#include <set>

namespace rubicon::travel {
namespace {

std::size_t at_index(int index) { return static_cast<std::size_t>(index); }

void insert_sorted(std::vector<int>& numbers, int number) {
  numbers.insert(std::lower_bound(numbers.begin(), numbers.end(), number), number);
}

void erase_sorted(std::vector<int>& numbers, int number) {
  numbers.erase(std::lower_bound(numbers.begin(), numbers.end(), number));
}

bool contains(const Ring& outer, const Ring& inner) {
  const ExactPoint corner(inner.front());
  return place_of_middle(corner, corner, outer) > 0;
}

}  // namespace

Outline::Outline(std::vector<Piece> pieces) : pieces_(std::move(pieces)) {
  neighbours_.resize(pieces_.size());
  composite_of_.assign(pieces_.size(), -1);
  for (const Piece& piece : pieces_) boxes_.push_back(box_of(piece.ring));
  std::vector<int> order(pieces_.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [this](int a, int b) {
    return std::pair(boxes_[at_index(a)].low_x, a) < std::pair(boxes_[at_index(b)].low_x, b);
  });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Box& box = boxes_[at_index(order[i])];
    for (std::size_t j = i + 1; j < order.size(); ++j) {
      if (boxes_[at_index(order[j])].low_x > box.high_x) break;
      find_contacts(order[i], order[j]);
    }
  }
  std::vector<int> all(pieces_.size());
  std::iota(all.begin(), all.end(), 0);
  rebuild(all);
}

void Outline::find_contacts(int a, int b) {
  if (a > b) std::swap(a, b);
  if (!boxes_[at_index(a)].meets(boxes_[at_index(b)])) return;
  const Ring& ring_a = pieces_[at_index(a)].ring;
  const Ring& ring_b = pieces_[at_index(b)].ring;
  ++work_.pairs;
  Contact contact{a, b, meetings(ring_a, ring_b)};
  if (contact.meetings.empty() && !contains(ring_a, ring_b) && !contains(ring_b, ring_a)) return;
  contacts_.insert_or_assign({a, b}, std::move(contact));
  insert_sorted(neighbours_[at_index(a)], b);
  insert_sorted(neighbours_[at_index(b)], a);
}

void Outline::forget_contacts(int piece) {
  for (const int other : neighbours_[at_index(piece)]) {
    contacts_.erase(std::minmax(piece, other));
    erase_sorted(neighbours_[at_index(other)], piece);
  }
  neighbours_[at_index(piece)].clear();
}

void Outline::replace(std::span<const Change> changes) {
  if (changes.empty()) return;
  std::set<int> changed;
  std::set<int> touched;  // composites
  for (const Change& change : changes) {
    changed.insert(change.piece);
    touched.insert(composite_of(change.piece));
    forget_contacts(change.piece);
    pieces_[at_index(change.piece)].ring = change.ring;
    boxes_[at_index(change.piece)] = box_of(change.ring);
  }
  for (const int piece : changed) {
    for (int other = 0; other < static_cast<int>(pieces_.size()); ++other) {
      // A pair of changed pieces is looked at once.
      if (other == piece || (changed.contains(other) && other < piece)) continue;
      find_contacts(piece, other);
    }
    for (const int other : neighbours_[at_index(piece)]) touched.insert(composite_of(other));
  }
  std::vector<int> stale;
  for (const int composite : touched) {
    Composite& old = composites_[at_index(composite)];
    stale.insert(stale.end(), old.pieces.begin(), old.pieces.end());
    for (const int piece : old.pieces) composite_of_[at_index(piece)] = -1;
    old = Composite();
  }
  std::sort(stale.begin(), stale.end());
  rebuild(stale);
}

void Outline::rebuild(const std::vector<int>& stale) {
  std::size_t slot = 0;
  for (const int first : stale) {
    if (composite_of(first) >= 0) continue;
    while (slot < composites_.size() && !composites_[slot].pieces.empty()) ++slot;
    if (slot == composites_.size()) composites_.emplace_back();
    std::vector<int> members{first};
    composite_of_[at_index(first)] = static_cast<int>(slot);
    for (std::size_t i = 0; i < members.size(); ++i) {
      for (const int other : neighbours_[at_index(members[i])]) {
        if (composite_of(other) >= 0) continue;
        composite_of_[at_index(other)] = static_cast<int>(slot);
        members.push_back(other);
      }
    }
    std::sort(members.begin(), members.end());
    std::vector<const Contact*> contacts;
    for (const int member : members) {
      for (const int other : neighbours_[at_index(member)]) {
        if (other > member) contacts.push_back(&contacts_.at({member, other}));
      }
    }
    composites_[slot] = build_composite(pieces_, std::move(members), contacts);
    composites_[slot].version = ++version_;
    ++work_.built;
  }
}

int Outline::place_of(const ExactPoint& p) const {
  for (const Composite& composite : composites_) {
    if (composite.pieces.empty()) continue;
    const Vec2 low = metres({composite.box.low_x, composite.box.low_y});
    const Vec2 high = metres({composite.box.high_x, composite.box.high_y});
    // The margin covers the rounding of p; who is right on the border is asked exactly.
    constexpr double kMargin = 1e-6;
    if ((p.p.array() < low.array() - kMargin).any()) continue;
    if ((p.p.array() > high.array() + kMargin).any()) continue;
    bool inside = false;
    for (const Edge& edge : composite.edges) {
      const ExactPoint& from = composite.nodes[at_index(edge.from)];
      const ExactPoint& to = composite.nodes[at_index(edge.to)];
      const int above_from = compare_y(from, p);
      const int above_to = compare_y(to, p);
      if (above_from * above_to > 0) continue;
      const int at = side(ExactPoint(edge.line_a), ExactPoint(edge.line_b), p);
      if (at == 0 && compare(from, p) * compare(to, p) <= 0) return 0;
      // Half-open in y: a node that the ray to the east meets counts once.
      if ((above_from > 0) == (above_to > 0)) continue;
      if ((at > 0) == (above_to > 0)) inside = !inside;
    }
    if (inside) return 1;
  }
  return -1;
}

}  // namespace rubicon::travel
