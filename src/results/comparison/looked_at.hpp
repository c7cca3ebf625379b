#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "interpreter/program/world.hpp"

namespace rubicon::comparison {

/// A world that is looked at: no step is made.
class LookedAt : public interpreter::World {
 public:
  explicit LookedAt(const interpreter::World& world) : world_(world) {}
  std::optional<interpreter::HitPair> propose(const interpreter::MotionStep&) override {
    return interpreter::HitPair{};
  }
  std::optional<interpreter::HitPair> refusal(const interpreter::MotionStep& step) const override {
    return world_.refusal(step);
  }
  double free_distance(std::span<const double> q, double heading_deg, double range) const override {
    return world_.free_distance(q, heading_deg, range);
  }
  bool is_met_moving(std::span<const double> q, double heading_deg, double range) const override {
    return world_.is_met_moving(q, heading_deg, range);
  }
  std::optional<interpreter::HitPair> blocked_at(std::span<const double> q) const override {
    return world_.blocked_at(q);
  }
  interpreter::LegLook look_along(std::span<const double> q_from, std::span<const double> q_to,
                                  bool whole, double least) const override {
    return world_.look_along(q_from, q_to, whole, least);
  }
  std::uint64_t version() const override { return world_.version(); }
  bool situation(const std::string& name, std::span<const double> q,
                 std::span<const double> q_goal) const override {
    return world_.situation(name, q, q_goal);
  }
  std::vector<guides::Thing> things() const override { return world_.things(); }
  guides::Nearness nearest(std::span<const double> q, double range,
                           const guides::PairsLeftOut& left_out) const override {
    return world_.nearest(q, range, left_out);
  }
  bool loaded() const override { return world_.loaded(); }

 private:
  const interpreter::World& world_;
};

}  // namespace rubicon::comparison
