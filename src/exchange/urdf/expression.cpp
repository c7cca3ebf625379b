#include "src/exchange/urdf/expression.hpp"

#include <fmt/format.h>

#include <array>
#include <cctype>
#include <tuple>
#include <utility>
#include <vector>

#include "src/motion/math/angles.hpp"

namespace rubicon::urdf {

namespace {

bool starts_name(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool in_name(char c) { return starts_name(c) || (c >= '0' && c <= '9'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Recursive descent, from `a if b else c` down to names and numbers. Where `live` is false the
/// text is read and not evaluated: the other way of a condition may divide by zero.
class Evaluator {
 public:
  Evaluator(std::string_view text, const NameLookup& lookup, std::size_t& steps)
      : text_(text), lookup_(lookup), steps_(steps) {}

  Value run() {
    next();
    Value value = conditional(true);
    if (!token_.empty()) unexpected();
    return value;
  }

 private:
  /// A name, a number, a quoted text or an operator; empty at the end.
  void next() {
    if (steps_ == 0) throw ExpressionError{"the expressions of this file take too many steps"};
    --steps_;
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
    const std::size_t begin = at_;
    if (at_ == text_.size()) {
      token_ = {};
      return;
    }
    const char c = text_[at_];
    if (starts_name(c)) {
      while (at_ < text_.size() && (in_name(text_[at_]) || text_[at_] == '.')) ++at_;
    } else if (is_digit(c) || (c == '.' && at_ + 1 < text_.size() && is_digit(text_[at_ + 1]))) {
      read_number();
    } else if (c == '\'' || c == '"') {
      const std::size_t end = text_.find(c, at_ + 1);
      if (end == std::string_view::npos) throw ExpressionError{"a text in it has no end"};
      at_ = end + 1;
    } else {
      read_operator();
    }
    token_ = text_.substr(begin, at_ - begin);
  }

  void read_number() {
    while (at_ < text_.size() && (in_name(text_[at_]) || text_[at_] == '.')) {
      const bool exponent = text_[at_] == 'e' || text_[at_] == 'E';
      ++at_;
      if (exponent && at_ < text_.size() && (text_[at_] == '-' || text_[at_] == '+')) ++at_;
    }
  }

  void read_operator() {
    constexpr std::array<std::string_view, 6> kTwo = {"**", "//", "<=", ">=", "==", "!="};
    for (const std::string_view each : kTwo) {
      if (text_.substr(at_).starts_with(each)) {
        at_ += 2;
        return;
      }
    }
    ++at_;
  }

  [[noreturn]] void unexpected() const {
    if (token_.empty()) throw ExpressionError{"it ends where a value is expected"};
    if (token_ == "[" || token_ == "{") {
      throw ExpressionError{"lists, tables and indexes are not read here"};
    }
    throw ExpressionError{fmt::format("'{}' is not expected there", token_)};
  }

  bool accept(std::string_view wanted) {
    if (token_ != wanted) return false;
    next();
    return true;
  }

  void expect(std::string_view wanted) {
    if (!accept(wanted)) {
      if (!token_.empty()) unexpected();
      throw ExpressionError{fmt::format("expected '{}' before its end", wanted)};
    }
  }

  Value conditional(bool live) {
    const Deeper deeper(depth_);
    // What stands before `if` is evaluated afterwards: only then it is known whether it counts.
    const auto before = std::make_pair(at_, token_);
    disjunction(false);
    if (!live) {
      if (!accept("if")) return {};
      disjunction(false);
      expect("else");
      return conditional(false);
    }
    if (token_ != "if") {
      std::tie(at_, token_) = before;
      return disjunction(live);
    }
    next();
    const bool chosen = check(disjunction(live), live);
    expect("else");
    Value otherwise = conditional(live && !chosen);
    if (!chosen) return otherwise;
    const auto behind = std::make_pair(at_, token_);
    std::tie(at_, token_) = before;
    Value value = disjunction(true);
    std::tie(at_, token_) = behind;
    return value;
  }

  static bool check(const Value& value, bool live) { return live && is_true(value); }

  /// Python's own rule: a text is true unless it is empty.
  static bool is_true(const Value& value) {
    const auto* text = std::get_if<std::string>(&value);
    return text != nullptr ? !text->empty() : truth(value);
  }

  Value disjunction(bool live) {
    Value value = conjunction(live);
    while (accept("or")) {
      const bool decided = check(value, live);
      Value right = conjunction(live && !decided);
      if (!decided) value = std::move(right);
    }
    return value;
  }

  Value conjunction(bool live) {
    Value value = negation(live);
    while (accept("and")) {
      const bool goes_on = check(value, live);
      Value right = negation(goes_on);
      if (goes_on) value = std::move(right);
    }
    return value;
  }

  Value negation(bool live) {
    bool turned = false, any = false;
    while (accept("not")) {
      turned = !turned;
      any = true;
    }
    Value value = comparison(live);
    if (!any) return value;
    return live ? is_true(value) != turned : false;
  }

  Value comparison(bool live) {
    Value left = sum(live);
    bool holds = true, any = false;
    while (token_ == "<" || token_ == "<=" || token_ == ">" || token_ == ">=" || token_ == "==" ||
           token_ == "!=") {
      const std::string operation(token_);
      next();
      Value right = sum(live);
      if (live) holds = holds && std::get<bool>(binary(operation, left, right));
      left = std::move(right);
      any = true;
    }
    return any ? Value(holds) : left;
  }

  Value sum(bool live) {
    Value value = product(live);
    while (token_ == "+" || token_ == "-") value = apply(value, &Evaluator::product, live);
    return value;
  }

  Value product(bool live) {
    Value value = factor(live);
    while (token_ == "*" || token_ == "/" || token_ == "//" || token_ == "%") {
      value = apply(value, &Evaluator::factor, live);
    }
    return value;
  }

  Value apply(const Value& left, Value (Evaluator::*operand)(bool), bool live) {
    const std::string operation(token_);
    next();
    Value right = (this->*operand)(live);
    return live ? binary(operation, left, right) : left;
  }

  Value factor(bool live) {
    bool negated = false;
    while (token_ == "-" || token_ == "+") {
      negated = negated != (token_ == "-");
      next();
    }
    Value value = atom(live);
    if (accept("**")) {
      const Deeper deeper(depth_);
      Value exponent = factor(live);
      if (live) value = binary("**", value, exponent);
    }
    return negated && live ? negative(value) : value;
  }

  Value atom(bool live) {
    if (token_.empty()) unexpected();
    const std::string_view token = token_;
    if (token == "(") {
      const Deeper deeper(depth_);
      next();
      Value value = conditional(live);
      expect(")");
      return refuse_index(std::move(value));
    }
    if (token.front() == '\'' || token.front() == '"') {
      next();
      return refuse_index(std::string(token.substr(1, token.size() - 2)));
    }
    if (is_digit(token.front()) || token.front() == '.') {
      next();
      Value value = literal_value(std::string(token));
      if (std::holds_alternative<std::string>(value)) {
        throw ExpressionError{fmt::format("'{}' is not a number", token)};
      }
      return value;
    }
    if (!starts_name(token.front())) unexpected();
    next();
    return named(std::string(token), live);
  }

  Value refuse_index(Value value) const {
    if (token_ == "[" || token_.starts_with(".")) {
      throw ExpressionError{"lists, tables, indexes and methods are not read here"};
    }
    return value;
  }

  Value named(std::string name, bool live) {
    if (name.starts_with("math.")) name.erase(0, 5);
    if (token_ == "(") {
      if (!is_function(name)) {
        throw ExpressionError{fmt::format("the function '{}' is not known here", name)};
      }
      const Deeper deeper(depth_);
      next();
      std::vector<Value> arguments;
      while (token_ != ")") {
        arguments.push_back(conditional(live));
        if (!accept(",")) break;
      }
      expect(")");
      return refuse_index(live ? call(name, arguments) : Value(std::int64_t{0}));
    }
    refuse_index({});
    if (name == "True" || name == "False") return name == "True";
    if (!live) return std::int64_t{0};
    if (std::optional<Value> value = lookup_(name)) return *std::move(value);
    if (name == "pi") return math::kPi;
    if (name == "tau") return 2 * math::kPi;
    if (name == "e") return 2.718281828459045;
    if (name.find('.') != std::string::npos) {
      throw ExpressionError{
          fmt::format("'{}': lists, tables, indexes and methods are not read here", name)};
    }
    throw ExpressionError{fmt::format("the property '{}' is not known", name)};
  }

  std::string_view text_;
  const NameLookup& lookup_;
  std::size_t& steps_;
  std::size_t at_ = 0;
  std::string_view token_;
  int depth_ = 0;
};

}  // namespace

Value evaluate(std::string_view expression, const NameLookup& lookup, std::size_t& steps) {
  return Evaluator(expression, lookup, steps).run();
}

}  // namespace rubicon::urdf
