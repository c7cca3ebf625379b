#pragma once

#include <vector>

#include "interpreter/syntax/syntax.hpp"

/// What a plan says of networks of cells. It stands beside syntax::Plan, which has their names
/// only.
namespace rubicon::syntax {

/// What stands in one network that only a network of cells may have.
struct GridItem {
  /// map "FILE"; scenario "FILE";
  struct File {
    Name key;
    String file;
  };
  /// agent NAME from (4, 2) to (7, 8);
  struct Agent {
    Name name;
    FloorPlace from, to;
    Span span;
  };

  /// job NAME from (4, 2) to (7, 8) at 30;
  struct Job {
    Name name;
    FloorPlace from, to;
    std::vector<Number> arrives;  ///< empty: from the beginning
    Span span;
  };

  Name network;
  std::vector<Name> policies;
  std::vector<NumberItem> numbers;  ///< of the policy
  std::vector<File> files;
  std::vector<Number> agents;  ///< agents 100;
  std::vector<Agent> named;
  std::vector<Number> jobs;  ///< jobs 1000;
  std::vector<Job> named_jobs;
  std::vector<Span> in_blocks;  ///< parts of it that stand in `for` or `when`
};

}  // namespace rubicon::syntax
