#pragma once

#include <string>

#include "interpreter/syntax/study.hpp"
#include "interpreter/syntax/syntax.hpp"

/// Syntax trees as text without places: two texts mean the same if these are equal.
namespace rubicon::grammar_test {

std::string tree_text(const syntax::Expression& expression);
std::string tree_text(const syntax::Script& script);
std::string tree_text(const syntax::Robot& robot);
std::string tree_text(const syntax::Plan& plan);
std::string tree_text(const syntax::Study& study);

}  // namespace rubicon::grammar_test
