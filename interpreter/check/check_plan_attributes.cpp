#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "interpreter/check/check_plan_parts.hpp"
#include "interpreter/syntax/attribute_text.hpp"
#include "interpreter/syntax/utf8_character.hpp"

namespace rubicon::interpreter {

const std::string* find_attribute(const Attributes& attributes, std::string_view key) {
  const auto found = std::find_if(attributes.begin(), attributes.end(),
                                  [&](const Attribute& each) { return each.key == key; });
  return found == attributes.end() ? nullptr : &found->text;
}

namespace plan_check {

namespace {

/// Most attributes of one component or task: they are copied wherever a module is placed.
constexpr std::size_t kMaxAttributes = 64;

std::string hint_for(const std::string& mistake) {
  if (mistake == "is empty") return "leave it out";
  return mistake.starts_with("has the control") ? "write it on one line, without tabs"
                                                : "say it in fewer words";
}

}  // namespace

void add_attribute(Subject& subject, const syntax::AttributeItem& item, const std::string& who,
                   std::map<std::string, Span>& spans, Attributes& attributes) {
  const auto [place, is_new] = spans.emplace(item.key.text, item.key.span);
  if (!is_new) {
    subject.twice(item.key.span, fmt::format("the {} of {} is given twice", item.key.text, who),
                  place->second);
    return;
  }
  if (spans.size() > kMaxAttributes) {
    if (spans.size() == kMaxAttributes + 1) {
      subject.error("P19", item.key.span,
                    fmt::format("{} has more than {} attributes", who, kMaxAttributes));
    }
    return;
  }
  std::string text = plain_attribute(item.text.text);
  if (first_not_utf8(text) != std::string::npos) return;  // which the parser says
  const std::string mistake = attribute_mistake(text);
  if (mistake.empty()) {
    attributes.push_back({item.key.text, std::move(text)});
    return;
  }
  subject.error("P19", item.text.span, fmt::format("the {} of {} {}", item.key.text, who, mistake),
                hint_for(mistake));
}

}  // namespace plan_check

}  // namespace rubicon::interpreter
