#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "interpreter/check/check.hpp"

/// What the parts of check_script share; nothing here is for other files.
namespace rubicon::interpreter::script_check {

/// One place where a behaviour is run by name.
struct Use {
  int user = -1;         ///< index of the behaviour it stands in, -1: the main sequence
  int used = -1;         ///< index of the behaviour it runs
  bool in_loop = false;  ///< something around it repeats it
  Span span;
};

/// The behaviours of a script and who runs whom. Of two with the same name the first counts.
struct Behaviours {
  std::map<std::string, int> index;  ///< by name
  std::vector<Use> uses;             ///< text order within each behaviour
  std::vector<bool> recursive;       ///< per behaviour: it runs itself, directly or through others
  std::vector<int>
      order;  ///< all behaviours, used ones before their users (but for recursive ones)
  std::vector<bool> reachable;   ///< run by the main sequence, directly or through others
  std::vector<bool> on_its_own;  ///< reachable and nowhere repeated by a loop
};

/// One script with all that its checks need to know.
struct Subject {
  const syntax::Script& script;
  const ScriptContext& context;
  const Behaviours& behaviours;
  Diagnostics& diagnostics;
};

/// Did-you-mean among names that the script itself defines. A file of wrong names costs no more
/// than a few suggestions.
class Suggester {
 public:
  /// The candidate nearest to `name`, empty if there is none. `list` is called once, at the first
  /// need.
  template <typename List>
  std::string nearest(const std::string& name, const List& list) {
    if (left_ == 0) return {};
    if (left_-- == kMaxSuggestions) candidates_ = list();
    return did_you_mean(name, candidates_);
  }

 private:
  // Each compares with all candidates; nobody reads more of them in one run.
  static constexpr int kMaxSuggestions = 100;
  int left_ = kMaxSuggestions;
  std::vector<std::string> candidates_;
};

/// Adds the names of all variables that the statements assign, also within structures.
void collect_targets(const std::vector<syntax::Statement>& statements,
                     std::set<std::string>& targets);

/// Resolves all uses; S05 (behaviours), S06 (a function's name as a statement), S14 (recursion,
/// defined twice).
Behaviours check_behaviours(const syntax::Script& script, const ScriptContext& context,
                            Diagnostics& diagnostics);

/// Names, arguments and kinds of all expressions and commands: S05, S06, S08, S09, S11, S12, S15,
/// W01, W02, W03, W07, W09.
void check_kinds(const Subject& subject);

/// Variables that are read before they are set: S10.
void check_assignment(const Subject& subject);

/// Shape of loops, each, which and together: S13, S14, W04-W08, N01, N02.
void check_structure(const Subject& subject);

}  // namespace rubicon::interpreter::script_check
