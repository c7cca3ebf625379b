#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "src/motion/math/random.hpp"
#include "src/studies/study/study_model.hpp"

namespace rubicon::study {

namespace {

std::vector<interpreter::ParameterTexts> every_combination(const StudyModel& study) {
  std::vector<interpreter::ParameterTexts> result;
  std::vector<std::size_t> at(study.variables.size(), 0);
  while (true) {
    interpreter::ParameterTexts set;
    for (std::size_t i = 0; i < at.size(); ++i) {
      set.emplace_back(study.variables[i].name, study.variables[i].values[at[i]]);
    }
    result.push_back(std::move(set));
    std::size_t i = at.size();
    while (i > 0 && ++at[i - 1] == study.variables[i - 1].values.size()) at[--i] = 0;
    if (i == 0) return result;
  }
}

std::string first_value(const Variable& variable) {
  return variable.range ? value_at(*variable.range, 0) : variable.values.front();
}

std::vector<interpreter::ParameterTexts> one_at_a_time(const StudyModel& study) {
  interpreter::ParameterTexts first;
  for (const Variable& each : study.variables) first.emplace_back(each.name, first_value(each));
  std::vector<interpreter::ParameterTexts> result{first};
  for (std::size_t i = 0; i < study.variables.size(); ++i) {
    for (std::size_t k = 1; k < study.variables[i].values.size(); ++k) {
      result.push_back(first);
      result.back()[i].second = study.variables[i].values[k];
    }
  }
  return result;
}

/// Each variable takes each of `latin` equal parts of its range once, in an order of its own.
std::vector<interpreter::ParameterTexts> latin_hypercube(const StudyModel& study) {
  const auto count = static_cast<std::size_t>(study.latin);
  std::vector<interpreter::ParameterTexts> result(count);
  math::Random random(study.seed);
  for (const Variable& each : study.variables) {
    std::vector<std::size_t> part(count);
    std::iota(part.begin(), part.end(), std::size_t{0});
    for (std::size_t i = count; i > 1; --i) std::swap(part[i - 1], part[random.index(i)]);
    for (std::size_t i = 0; i < count; ++i) {
      const double share =
          (static_cast<double>(part[i]) + random.uniform()) / static_cast<double>(count);
      if (each.range) {
        result[i].emplace_back(each.name, value_at(*each.range, share));
        continue;
      }
      const auto value = static_cast<std::size_t>(share * static_cast<double>(each.values.size()));
      result[i].emplace_back(each.name, each.values[std::min(value, each.values.size() - 1)]);
    }
  }
  return result;
}

}  // namespace

std::string value_at(const Variable::Range& range, double share) {
  // Six digits of the range, whatever its values are, and never beyond its ends.
  const double width = range.high - range.low;
  const double largest = std::max(std::fabs(range.low), std::fabs(range.high));
  constexpr int kLeastDigits = 6;
  constexpr int kMostDigits = 17;
  int digits = kLeastDigits - 1;
  for (double reach = width; reach < largest && digits < kMostDigits; reach *= 10) ++digits;
  digits = std::max(digits, kLeastDigits);
  std::string text = fmt::format("{:.{}g}", range.low + width * share, digits);
  const double value = std::stod(text);
  if (value < range.low) text = fmt::format("{}", range.low);
  if (value > range.high) text = fmt::format("{}", range.high);
  return range.unit.empty() ? text : text + " " + range.unit;
}

bool must_search(const StudyModel& study) {
  if (study.design != Design::search) return false;
  std::size_t count = 1;
  for (const Variable& each : study.variables) {
    if (each.range) return true;
    count *= each.values.size();
    if (count > static_cast<std::size_t>(study.budget)) return true;
  }
  return false;
}

std::size_t count_variants(const StudyModel& study) {
  if (study.design == Design::latin) return static_cast<std::size_t>(study.latin);
  if (must_search(study)) return static_cast<std::size_t>(study.budget);
  std::size_t count = 1;
  for (const Variable& each : study.variables) {
    if (study.design == Design::one_at_a_time) {
      count += each.values.size() - 1;
    } else if (count <= kMostVariants) {
      count *= each.values.size();
    }
  }
  return count;
}

std::vector<interpreter::ParameterTexts> variants_of(const StudyModel& study) {
  switch (study.design) {
    case Design::latin:
      return latin_hypercube(study);
    case Design::one_at_a_time:
      return one_at_a_time(study);
    case Design::search: {
      if (!must_search(study)) break;
      interpreter::ParameterTexts first;
      for (const Variable& each : study.variables) first.emplace_back(each.name, first_value(each));
      return {first};
    }
    case Design::full:
      break;
  }
  return every_combination(study);
}

}  // namespace rubicon::study
