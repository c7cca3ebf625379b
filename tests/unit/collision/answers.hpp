#pragma once

#include <cstdint>
#include <vector>

#include "tests/unit/collision/bodies.hpp"

namespace rubicon::collision::test {

/// Everything that a world answers, as plain bits.
class Answers {
 public:
  void add(double value);
  void add(const Vec3& point);
  void add(const SweptHit& hit);
  void add(const SweptResult& result);

  bool operator==(const Answers&) const = default;

 private:
  std::vector<std::uint64_t> bits_;
};

/// A site and what to ask of it.
struct Questions {
  CollisionWorld world;
  std::vector<BodyPtr> bodies = site_bodies();
  std::vector<SweptQuery> queries;
};
Questions random_questions(std::uint32_t seed, int obstacles, int queries);

/// All kinds of answers to all questions.
Answers answers_of(const Questions& questions);

}  // namespace rubicon::collision::test
