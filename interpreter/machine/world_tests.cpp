#include "interpreter/machine/world_tests.hpp"

namespace rubicon::interpreter {

bool WorldTests::stands(std::span<const double> q) { return in_range(q) && !world_.blocked_at(q); }

bool WorldTests::sweeps_free(std::span<const double> q_from, std::span<const double> q_to) {
  return in_range(q_to) && !world_.refusal({q_from, q_to, 0, 0});
}

guides::LegShares WorldTests::look_along(std::span<const double> q_from,
                                         std::span<const double> q_to, bool whole, double least) {
  const LegLook look = world_.look_along(q_from, q_to, whole, least);
  return {look.free_until, look.met_from};
}

std::vector<guides::Thing> WorldTests::things() const { return world_.things(); }

guides::Nearness WorldTests::nearest(std::span<const double> q, double range,
                                     const guides::PairsLeftOut& left_out) {
  return world_.nearest(q, range, left_out);
}

bool WorldTests::in_range(std::span<const double> q) const {
  constexpr double kRounding = 1e-9;
  for (std::size_t i = 0; i < q.size(); ++i) {
    const robot::Parameter& p = model_.parameters[i];
    if (!p.cyclic && (q[i] < p.lower - kRounding || q[i] > p.upper + kRounding)) return false;
  }
  return true;
}

}  // namespace rubicon::interpreter
