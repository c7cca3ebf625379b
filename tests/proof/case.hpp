#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tests/unit/collision/box_oracle.hpp"
#include "tests/unit/collision/random_scene.hpp"

namespace rubicon::collision::proof {

using math::Mat3;
using test::at;
using test::Truth;

/// 32 bits a call from a counter that is scrambled (splitmix64 of Steele, Lea and Flood 2014):
/// a case starts one in no time, and any two cases have unrelated numbers.
class CaseEngine {
 public:
  using result_type = std::uint32_t;

  CaseEngine(std::uint64_t seed, std::string_view generator, std::uint64_t index);
  result_type operator()();

 private:
  std::uint64_t state_ = 0;
};
using Random = test::BasicRandom<CaseEngine>;

/// How the bodies of a case move.
enum class MotionKind { kStill, kTranslation, kRotation, kScrew, kGeneral, kPair };
std::string_view name_of(MotionKind kind);

/// One question, what is true, and what was answered.
struct Outcome {
  MotionKind motion = MotionKind::kStill;
  Truth truth = Truth::kNearBoundary;
  bool engine_hit = false;
  bool grazes = false;  ///< brought to the boundary, where FCL, which has no tolerance, is no
                        ///< measure of a false hit
  std::optional<bool> fcl_hit;  ///< what FCL's users would get; not asked in every case
  std::optional<Truth> third;   ///< what fcl::collide proves with grown shapes; not asked always

  bool is_miss() const { return truth == Truth::kHit && !engine_hit; }
  bool is_false_hit() const { return truth == Truth::kFree && engine_hit; }
  /// The two oracles contradict each other: one of them is wrong.
  bool is_quarrel() const {
    return third && *third != Truth::kNearBoundary && truth != Truth::kNearBoundary &&
           *third != truth;
  }
};

/// What a generator writes down of one case.
struct CaseRecord {
  std::vector<Outcome> outcomes;
  bool explain = false;  ///< a replay: notes are wanted
  std::string notes;

  template <typename Text>
  void note(const Text& text) {
    if (explain) notes += text() + "\n";
  }
};

/// A family of cases. `run` must depend on nothing but the random numbers.
struct Generator {
  std::string_view name;
  std::string_view what;
  int share = 1;             ///< of the questions of a run, in parts of all shares
  int questions_a_case = 1;  ///< outcomes that one call writes down
  void (*run)(Random& random, CaseRecord& record) = nullptr;
};

/// Answers nearer to the tolerance than this (m) are not judged, unless the oracle is exact.
inline constexpr double kBand = 1e-4;
/// The same where the oracle is exact (pure translations, single poses of polytopes): rounding.
inline constexpr double kExactBand = 1e-7;

/// "(x, y, z)" with all digits.
std::string text_of(const Vec3& vector);
/// Place and rotation of a pose with all digits.
std::string text_of(const Pose& X);

}  // namespace rubicon::collision::proof
