#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "src/results/verify/input/formula.hpp"

namespace rubicon::verify {

/// Reads formulas and frames from left to right; throws UnreadableInput where the text is neither.
class FormulaParser {
 public:
  FormulaParser(std::string_view text, const std::vector<std::string>& parameters)
      : text_(text), parameters_(parameters) {}

  Formula formula();
  std::vector<FrameElement> frame();
  void expect_end();

 private:
  void sum(Formula& out);
  void product(Formula& out);
  void factor(Formula& out);
  void name(Formula& out);
  bool take(char symbol);
  void expect(char symbol);
  char next();
  std::string_view word();
  double number();
  [[noreturn]] void fail(std::string_view expected) const;

  std::string_view text_;
  const std::vector<std::string>& parameters_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

}  // namespace rubicon::verify
