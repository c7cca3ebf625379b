#include "tests/unit/collision/answers.hpp"

#include <cstring>

#include "tests/unit/collision/two_joint_motion.hpp"

namespace rubicon::collision::test {

void Answers::add(double value) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  bits_.push_back(bits);
}

void Answers::add(const Vec3& point) {
  for (int i = 0; i < 3; ++i) add(point[i]);
}

void Answers::add(const SweptHit& hit) {
  add(hit.item);
  add(hit.obstacle ? *hit.obstacle : -1.0);
  add(hit.other_item.value_or(-1));
}

void Answers::add(const SweptResult& result) {
  if (result.hit) {
    add(*result.hit);
  } else {
    add(-2.0);
  }
}

Questions random_questions(std::uint32_t seed, int obstacles, int queries) {
  Random random(seed);
  Questions questions;
  const auto any_body = [&] {
    return questions.bodies[random.below(static_cast<int>(questions.bodies.size()))];
  };
  for (int i = 0; i < obstacles; ++i) questions.world.insert(any_body(), random.pose(4));
  for (int i = 0; i < queries; ++i) {
    SweptQuery query;
    const Pose X = random.pose(4);
    TwoJointMotion crane;
    crane.theta1 = 3;
    crane.place0 = X.translation();
    crane.place1 = crane.place0 + random.vector(0.3);
    const Motion motions[] = {geometry::translating(X, random.vector(0.5)),
                              turning(X, random.direction(), random.vector(5), 8), crane.motion()};
    for (int k = 0; k < 2; ++k)
      query.items.push_back(
          item(*questions.bodies[(i + k) % questions.bodies.size()], motions[(i + k) % 3]));
    query.pairs = {{0, 1}};
    questions.queries.push_back(query);
  }
  return questions;
}

Answers answers_of(const Questions& questions) {
  Answers answers;
  ClearanceBudget budget;
  for (const SweptQuery& query : questions.queries) {
    answers.add(questions.world.test(query));
    answers.add(questions.world.test(query, budget));
    for (const BlockingPair& pair : questions.world.explain(query)) {
      answers.add(pair.hit);
      answers.add(pair.contact.fraction);
      answers.add(pair.contact.point_W);
    }
    const Clearance miss = questions.world.clearance(query, 0.5);
    answers.add(miss.lower_bound);
    answers.add(miss.upper_bound);
    answers.add(miss.point_moving_W);
    const MovingBody& moving = query.items[0].moving;
    const auto blocked =
        questions.world.blocked_at(*moving.body, moving.motion.pose(0.5), 1e-3, {});
    answers.add(blocked ? *blocked : -1.0);
  }
  return answers;
}

}  // namespace rubicon::collision::test
