#include "src/simulation/trace/formula_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <stdexcept>
#include <utility>

#include "src/simulation/trace/digit.hpp"
#include "src/simulation/trace/json_builder.hpp"

namespace rubicon::trace {

namespace {

using robot::Formula;
using robot::FormulaOp;
using robot::FrameElement;
using robot::FrameFormula;
using Kind = FormulaOp::Kind;

/// Brackets and signs within each other; keeps a hostile header from overflowing the stack.
constexpr int kDeepest = 200;

/// Names are those of a robot file; a body and its parameter have a point between them.
bool is_word(char c) {
  return is_digit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '.' ||
         static_cast<unsigned char>(c) >= 0x80;
}

/// Recursive descent, from left to right.
class FormulaReader {
 public:
  FormulaReader(std::string_view text, const std::vector<std::string>& parameters)
      : text_(text), parameters_(parameters) {}

  Formula formula() {
    Formula out;
    sum(out);
    return out;
  }

  FrameFormula frame() {
    FrameFormula elements;
    do {
      elements.push_back(element());
    } while (take('*'));
    return elements;
  }

  void expect_end() {
    if (next() != '\0') fail("the end");
  }

 private:
  [[noreturn]] void fail(std::string_view expected) const {
    std::string text;
    append_string(text, text_);
    throw std::invalid_argument(
        fmt::format("expected {} at character {} of {}", expected, at_ + 1, text));
  }

  /// The next character that is no space; 0 at the end.
  char next() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
  }

  bool take(char symbol) {
    if (next() != symbol) return false;
    ++at_;
    return true;
  }

  void expect(char symbol) {
    if (!take(symbol)) fail(fmt::format("'{}'", symbol));
  }

  std::string_view word() {
    next();
    const std::size_t begin = at_;
    while (at_ < text_.size() && is_word(text_[at_])) ++at_;
    return text_.substr(begin, at_ - begin);
  }

  double number() {
    double value = 0;
    const auto [end, error] =
        std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
    if (error != std::errc()) fail("a number");
    at_ = static_cast<std::size_t>(end - text_.data());
    return value;
  }

  void deeper() {
    if (++depth_ > kDeepest) fail("fewer brackets and signs");
  }

  static void add(Formula& out, Kind kind) { out.code.push_back({kind, 0, 0}); }

  void sum(Formula& out) {
    deeper();
    product(out);
    for (char sign = next(); sign == '+' || sign == '-'; sign = next()) {
      expect(sign);
      product(out);
      add(out, sign == '+' ? Kind::add : Kind::subtract);
    }
    --depth_;
  }

  void product(Formula& out) {
    factor(out);
    for (char sign = next(); sign == '*' || sign == '/'; sign = next()) {
      expect(sign);
      factor(out);
      add(out, sign == '*' ? Kind::multiply : Kind::divide);
    }
  }

  void factor(Formula& out) {
    deeper();
    const char c = next();
    if (take('-')) {
      factor(out);
      add(out, Kind::negate);
    } else if (take('(')) {
      sum(out);
      expect(')');
    } else if (is_digit(c) || c == '.') {
      out.code.push_back({Kind::constant, 0, number()});
    } else {
      name(out);
    }
    --depth_;
  }

  /// The number of a parameter; how many there are for what is none.
  std::size_t index_of(std::string_view name) const {
    return static_cast<std::size_t>(std::find(parameters_.begin(), parameters_.end(), name) -
                                    parameters_.begin());
  }

  void name(Formula& out) {
    const std::string_view found = word();
    if (found.empty()) fail("a number or a name");
    if ((found == "sin" || found == "cos") && take('(')) {
      sum(out);
      expect(')');
      add(out, found == "sin" ? Kind::sin : Kind::cos);
      return;
    }
    Kind kind = Kind::parameter;
    std::size_t index = index_of(found);
    if (index == parameters_.size() && (found.ends_with("_s") || found.ends_with("_c"))) {
      kind = found.ends_with("_s") ? Kind::step : Kind::start;
      index = index_of(found.substr(0, found.size() - 2));
    }
    if (index == parameters_.size()) fail("a parameter, its step or its start value");
    out.code.push_back({kind, static_cast<int>(index), 0});
  }

  FrameElement element() {
    const std::string_view kind = word();
    FrameElement read;
    if (kind == "rotx") {
      read.kind = FrameElement::Kind::rotx;
    } else if (kind == "roty") {
      read.kind = FrameElement::Kind::roty;
    } else if (kind == "rotz") {
      read.kind = FrameElement::Kind::rotz;
    } else if (kind != "trans") {
      fail("trans, rotx, roty or rotz");
    }
    expect('(');
    read.a = formula();
    if (read.kind == FrameElement::Kind::trans) {
      expect(',');
      read.b = formula();
      expect(',');
      read.c = formula();
    }
    expect(')');
    return read;
  }

  std::string_view text_;
  const std::vector<std::string>& parameters_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

}  // namespace

Formula read_formula(std::string_view text, const std::vector<std::string>& parameters) {
  FormulaReader reader(text, parameters);
  Formula formula = reader.formula();
  reader.expect_end();
  return formula;
}

FrameFormula read_frame(std::string_view text, const std::vector<std::string>& parameters) {
  FormulaReader reader(text, parameters);
  FrameFormula frame = reader.frame();
  reader.expect_end();
  return frame;
}

}  // namespace rubicon::trace
