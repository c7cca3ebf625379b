#include "src/exchange/ifc/step_values.hpp"

#include <charconv>
#include <cmath>

#include "src/exchange/ifc/step_characters.hpp"
#include "src/exchange/ifc/step_file.hpp"

namespace rubicon::ifc {

namespace {

bool is_capital(char c) { return c >= 'A' && c <= 'Z'; }
bool is_in_number(char c) {
  return is_digit(c) || c == '.' || c == 'E' || c == 'e' || c == '+' || c == '-';
}

}  // namespace

class StepValueReader {
 public:
  explicit StepValueReader(std::string_view text) : text_(text) {}

  std::optional<StepValues> read() {
    skip();
    if (at_ >= text_.size() || text_[at_] != '(') return std::nullopt;
    // An explicit stack: the depth of the text is its author's choice.
    std::vector<std::size_t> open;
    bool after_value = false;  // a comma or a bracket must follow
    do {
      skip();
      if (at_ >= text_.size()) return std::nullopt;
      const char c = text_[at_];
      if (c == ')') {
        if (open.empty() || (!after_value && !is_empty(open.back()))) return std::nullopt;
        ++at_;
        result_.values_[open.back()].end = static_cast<std::uint32_t>(result_.values_.size());
        open.pop_back();
        after_value = true;
      } else if (after_value) {
        if (c != ',') return std::nullopt;
        ++at_;
        after_value = false;
      } else if (c == '(') {
        ++at_;
        if (!open_list(StepKind::list, {}, open)) return std::nullopt;
      } else if (is_capital(c) || c == '!') {
        if (!open_typed(open)) return std::nullopt;
      } else {
        if (!read_simple(c)) return std::nullopt;
        after_value = true;
      }
    } while (!open.empty());
    return std::move(result_);
  }

 private:
  bool is_empty(std::size_t list) const { return list + 1 == result_.values_.size(); }

  bool open_list(StepKind kind, std::string_view keyword, std::vector<std::size_t>& open) {
    if (open.size() >= static_cast<std::size_t>(kDeepestBrackets)) return false;
    open.push_back(result_.values_.size());
    result_.values_.push_back({kind, 0, keyword});
    return true;
  }

  bool open_typed(std::vector<std::size_t>& open) {
    const std::size_t begin = at_++;
    while (at_ < text_.size() &&
           (is_capital(text_[at_]) || is_digit(text_[at_]) || text_[at_] == '_')) {
      ++at_;
    }
    const std::string_view keyword = text_.substr(begin, at_ - begin);
    skip();
    if (at_ >= text_.size() || text_[at_] != '(') return false;
    ++at_;
    return open_list(StepKind::typed, keyword, open);
  }

  void skip() {
    while (at_ < text_.size()) {
      if (is_blank(text_[at_])) {
        ++at_;
      } else if (text_.compare(at_, 2, "/*") == 0) {
        const std::size_t end = text_.find("*/", at_ + 2);
        at_ = end == std::string_view::npos ? text_.size() : end + 2;
      } else {
        break;
      }
    }
  }

  void put(StepKind kind, std::size_t begin, std::size_t end) {
    const auto next = static_cast<std::uint32_t>(result_.values_.size() + 1);
    result_.values_.push_back({kind, next, text_.substr(begin, end - begin)});
  }

  /// A value that holds no other.
  bool read_simple(char c) {
    const std::size_t begin = at_;
    if (c == '$' || c == '*') {
      ++at_;
      put(c == '$' ? StepKind::unset : StepKind::derived, begin, at_);
    } else if (c == '\'') {
      return read_text();
    } else if (c == '"' || (c == '.' && at_ + 1 < text_.size() && !is_digit(text_[at_ + 1]))) {
      const std::size_t end = text_.find(c, at_ + 1);
      if (end == std::string_view::npos) return false;
      at_ = end + 1;
      put(c == '"' ? StepKind::binary : StepKind::enumeration, begin + 1, end);
    } else if (c == '#') {
      ++at_;
      while (at_ < text_.size() && is_digit(text_[at_])) ++at_;
      if (at_ == begin + 1) return false;
      put(StepKind::reference, begin + 1, at_);
    } else if (is_in_number(c)) {
      while (at_ < text_.size() && is_in_number(text_[at_])) ++at_;
      put(StepKind::number, begin, at_);
    } else {
      return false;
    }
    return true;
  }

  bool read_text() {
    const std::size_t begin = ++at_;
    while (true) {
      const std::size_t end = text_.find('\'', at_);
      if (end == std::string_view::npos) return false;
      at_ = end + 1;
      if (at_ < text_.size() && text_[at_] == '\'') {
        ++at_;  // two marks stand for one
        continue;
      }
      put(StepKind::text, begin, end);
      return true;
    }
  }

  std::string_view text_;
  std::size_t at_ = 0;
  StepValues result_;
};

std::optional<StepValues> StepValues::read(std::string_view arguments) {
  return StepValueReader(arguments).read();
}

StepItem StepValues::all() const { return {this, 0}; }

std::size_t StepValues::size() const { return all().size(); }

StepItem StepValues::operator[](std::size_t index) const { return all()[index]; }

std::vector<std::uint64_t> StepValues::references() const {
  std::vector<std::uint64_t> found;
  for (std::size_t i = 0; i < values_.size(); ++i) {
    if (values_[i].kind == StepKind::reference) found.push_back(StepItem(this, i).reference());
  }
  return found;
}

std::optional<double> StepItem::number() const {
  if (kind() == StepKind::typed) return size() == 1 ? (*begin()).number() : std::nullopt;
  if (kind() != StepKind::number) return std::nullopt;
  std::string_view digits = text();
  if (digits.front() == '+') digits.remove_prefix(1);
  double result = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), result);
  if (error != std::errc() || end != digits.data() + digits.size() || !std::isfinite(result)) {
    return std::nullopt;
  }
  return result;
}

std::uint64_t StepItem::reference() const {
  return kind() == StepKind::reference ? whole_number(text()).value_or(0) : 0;
}

std::string StepItem::decoded() const {
  return kind() == StepKind::text ? decode_step_text(text()) : std::string();
}

StepItem::Iterator& StepItem::Iterator::operator++() {
  at_ = values_->values_[at_].end;
  return *this;
}

StepItem::Iterator StepItem::begin() const {
  const bool holds = kind() == StepKind::list || kind() == StepKind::typed;
  return {values_, holds ? at_ + 1 : 0};
}

StepItem::Iterator StepItem::end() const {
  const bool holds = kind() == StepKind::list || kind() == StepKind::typed;
  return {values_, holds ? value().end : 0};
}

std::size_t StepItem::size() const {
  std::size_t count = 0;
  for (Iterator at = begin(); at != end(); ++at) ++count;
  return count;
}

StepItem StepItem::operator[](std::size_t index) const {
  for (Iterator at = begin(); at != end(); ++at) {
    if (index-- == 0) return *at;
  }
  return {};
}

std::optional<std::uint64_t> whole_number(std::string_view text) {
  std::uint64_t result = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), result);
  if (text.empty() || error != std::errc() || end != text.data() + text.size()) {
    return std::nullopt;
  }
  return result;
}

}  // namespace rubicon::ifc
