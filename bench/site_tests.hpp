#pragma once

#include <span>

#include "interpreter/program/world.hpp"
#include "src/motion/guides/guide.hpp"

namespace rubicon::bench {

/// What guides ask, answered by the site as the machine answers it.
class SiteTests : public guides::MotionTests {
 public:
  SiteTests(const robot::RobotModel& model, const interpreter::World& world)
      : model_(model), world_(world) {}

  bool stands(std::span<const double> q) override { return in_range(q) && !world_.blocked_at(q); }
  bool sweeps_free(std::span<const double> q_from, std::span<const double> q_to) override {
    return in_range(q_to) && !world_.refusal({q_from, q_to, 0, 0});
  }

  guides::LegShares look_along(std::span<const double> q_from, std::span<const double> q_to,
                               bool whole, double least) override {
    const interpreter::LegLook look = world_.look_along(q_from, q_to, whole, least);
    return {look.free_until, look.met_from};
  }

 private:
  bool in_range(std::span<const double> q) const {
    for (std::size_t i = 0; i < q.size(); ++i) {
      const robot::Parameter& p = model_.parameters[i];
      if (!p.cyclic && (q[i] < p.lower || q[i] > p.upper)) return false;
    }
    return true;
  }

  const robot::RobotModel& model_;
  const interpreter::World& world_;
};

}  // namespace rubicon::bench
