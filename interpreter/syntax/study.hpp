#pragma once

#include <optional>
#include <string>
#include <vector>

#include "interpreter/syntax/syntax.hpp"

/// The syntax tree of a study (NAME.study).
namespace rubicon::syntax {

/// A number as it was written.
struct Literal {
  Number number;
  double written = 0;  ///< in the unit that was written
  std::string text;    ///< "3.6 m"
};

/// One value of a parameter, or a range of them.
struct VariedValue {
  std::optional<String> text;
  Literal first;
  std::optional<Literal> last;
  std::optional<Literal> step;
  Span span;
};

/// vary bays 4, 6 to 10 by 2;
struct VaryItem {
  QualifiedName name;
  std::vector<VariedValue> values;
  Span span;
};

/// p80(finish(set[3])): its words, the outermost first.
struct Measure {
  std::vector<QualifiedName> words;
  Span span;
};

/// p80(finish) <= "2026-03-27 16:00"
struct Limit {
  Measure measure;
  Name comparison;  ///< <=, >=, < or >
  std::optional<String> text;
  Literal number;  ///< without text
  Span span;
};

/// runs at most 500 until width(p80(finish)) < 4 h;
struct RunsItem {
  bool at_most = false;
  Number count;
  std::optional<Limit> until;
  Span span;
};

struct DesignItem {
  Name kind;
  std::optional<Number> count;
  Span span;
};

struct SeedItem {
  Number value;
  Span span;
};

struct ChooseItem {
  Name direction;
  Measure measure;
  std::vector<Limit> with;
  Span span;
};

struct StudiedPlan {
  String file;
  Span span;
};

struct Study {
  Name name;
  std::vector<StudiedPlan> plans;
  std::vector<VaryItem> vary;
  std::vector<DesignItem> designs;
  std::vector<RunsItem> runs;
  std::vector<SeedItem> seeds;
  std::vector<Measure> asks;
  std::vector<ChooseItem> chooses;
  Span span;
  bool broken = false;  ///< there were mistakes of syntax in it
};

}  // namespace rubicon::syntax
