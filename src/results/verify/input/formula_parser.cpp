#include "src/results/verify/input/formula_parser.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>

#include "src/results/verify/input/fault.hpp"

namespace rubicon::verify {

namespace {

/// Brackets and signs within each other; keeps a hostile header from overflowing the stack.
constexpr int kDeepestFormula = 200;

bool is_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.' ||
         static_cast<unsigned char>(c) >= 0x80;
}

}  // namespace

void FormulaParser::fail(std::string_view expected) const {
  throw UnreadableInput(
      fmt::format("expected {} at character {} of '{}'", expected, at_ + 1, std::string(text_)));
}

char FormulaParser::next() {
  while (at_ < text_.size() && text_[at_] == ' ') ++at_;
  return at_ < text_.size() ? text_[at_] : '\0';
}

bool FormulaParser::take(char symbol) {
  if (next() != symbol) return false;
  ++at_;
  return true;
}

void FormulaParser::expect(char symbol) {
  if (!take(symbol)) fail(fmt::format("'{}'", symbol));
}

void FormulaParser::expect_end() {
  if (next() != '\0') fail("the end");
}

std::string_view FormulaParser::word() {
  next();
  const std::size_t begin = at_;
  while (at_ < text_.size() && is_word(text_[at_])) ++at_;
  return text_.substr(begin, at_ - begin);
}

double FormulaParser::number() {
  next();
  double value = 0;
  const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
  if (error != std::errc()) fail("a number");
  at_ = static_cast<std::size_t>(end - text_.data());
  return value;
}

Formula FormulaParser::formula() {
  Formula out;
  sum(out);
  return out;
}

void FormulaParser::sum(Formula& out) {
  if (++depth_ > kDeepestFormula) fail("fewer brackets");
  product(out);
  while (next() == '+' || next() == '-') {
    const bool plus = take('+');
    if (!plus) expect('-');
    product(out);
    out.code_.push_back({plus ? Formula::Kind::add : Formula::Kind::subtract, 0, 0});
  }
  --depth_;
}

void FormulaParser::product(Formula& out) {
  factor(out);
  // A * between two elements of a frame is the frame's, and stands outside of any formula.
  while (next() == '*' || next() == '/') {
    const bool times = take('*');
    if (!times) expect('/');
    factor(out);
    out.code_.push_back({times ? Formula::Kind::multiply : Formula::Kind::divide, 0, 0});
  }
}

void FormulaParser::factor(Formula& out) {
  if (++depth_ > kDeepestFormula) fail("fewer signs");
  const char c = next();
  if (take('-')) {
    factor(out);
    out.code_.push_back({Formula::Kind::negate, 0, 0});
  } else if (take('(')) {
    sum(out);
    expect(')');
  } else if (std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '.') {
    out.code_.push_back({Formula::Kind::number, number(), 0});
  } else {
    name(out);
  }
  --depth_;
}

void FormulaParser::name(Formula& out) {
  const std::string_view found = word();
  if (found.empty()) fail("a number or a name");
  const auto index_of = [&](std::string_view wanted) {
    const auto place = std::find(parameters_.begin(), parameters_.end(), wanted);
    return static_cast<std::size_t>(place - parameters_.begin());
  };
  if ((found == "sin" || found == "cos") && take('(')) {
    sum(out);
    expect(')');
    out.code_.push_back({found == "sin" ? Formula::Kind::sin : Formula::Kind::cos, 0, 0});
    return;
  }
  Formula::Kind kind = Formula::Kind::value;
  std::size_t index = index_of(found);
  if (index == parameters_.size() && found.size() > 2) {
    const std::string_view ending = found.substr(found.size() - 2);
    if (ending == "_s" || ending == "_c") {
      kind = ending == "_s" ? Formula::Kind::step : Formula::Kind::start;
      index = index_of(found.substr(0, found.size() - 2));
    }
  }
  if (index == parameters_.size()) fail("a parameter, its step or its start value");
  out.code_.push_back({kind, 0, index});
}

std::vector<FrameElement> FormulaParser::frame() {
  std::vector<FrameElement> elements;
  do {
    const std::string_view kind = word();
    FrameElement element;
    expect('(');
    element.a = formula();
    if (kind == "trans") {
      expect(',');
      element.b = formula();
      expect(',');
      element.c = formula();
    } else if (kind == "rotx" || kind == "roty" || kind == "rotz") {
      element.kind = kind == "rotx"   ? FrameElement::Kind::rotx
                     : kind == "roty" ? FrameElement::Kind::roty
                                      : FrameElement::Kind::rotz;
    } else {
      fail("trans, rotx, roty or rotz");
    }
    expect(')');
    elements.push_back(std::move(element));
  } while (take('*'));
  return elements;
}

std::vector<FrameElement> parse_frame(std::string_view text,
                                      const std::vector<std::string>& parameters) {
  FormulaParser parser(text, parameters);
  std::vector<FrameElement> elements = parser.frame();
  parser.expect_end();
  return elements;
}

}  // namespace rubicon::verify
