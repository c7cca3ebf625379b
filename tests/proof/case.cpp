#include "tests/proof/case.hpp"

#include <fmt/format.h>

namespace rubicon::collision::proof {
namespace {

constexpr std::uint64_t kStep = 0x9e3779b97f4a7c15U;

std::uint64_t scrambled(std::uint64_t value) {
  value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9U;
  value = (value ^ (value >> 27)) * 0x94d049bb133111ebU;
  return value ^ (value >> 31);
}

}  // namespace

CaseEngine::CaseEngine(std::uint64_t seed, std::string_view generator, std::uint64_t index) {
  state_ = scrambled(seed + kStep);
  for (const char letter : generator)
    state_ = scrambled(state_ ^ static_cast<unsigned char>(letter));
  state_ = scrambled(state_ + kStep * index);
}

CaseEngine::result_type CaseEngine::operator()() {
  state_ += kStep;
  return static_cast<result_type>(scrambled(state_) >> 32);
}

std::string_view name_of(MotionKind kind) {
  switch (kind) {
    case MotionKind::kStill:
      return "pose";
    case MotionKind::kTranslation:
      return "T";
    case MotionKind::kRotation:
      return "R";
    case MotionKind::kScrew:
      return "screw";
    case MotionKind::kGeneral:
      return "general";
    case MotionKind::kPair:
      break;
  }
  return "both move";
}

std::string text_of(const Vec3& vector) {
  return fmt::format("({}, {}, {})", vector.x(), vector.y(), vector.z());
}

std::string text_of(const Pose& X) {
  return fmt::format("at {} rotation columns {} {} {}", text_of(Vec3(X.translation())),
                     text_of(Vec3(X.linear().col(0))), text_of(Vec3(X.linear().col(1))),
                     text_of(Vec3(X.linear().col(2))));
}

}  // namespace rubicon::collision::proof
