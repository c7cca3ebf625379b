#include <utility>

#include "interpreter/check/check_script_expression.hpp"
#include "interpreter/check/check_script_parts.hpp"

namespace rubicon::interpreter::script_check {

namespace {

using syntax::Statement;

// Entries of all summaries together. Scripts people write stay far below; past it the check gives
// up and leaves reading an unset variable to the run-time error.
constexpr std::size_t kMaxSummaryEntries = 2'000'000;

/// What running a behaviour means for variables.
struct Summary {
  struct Need {
    int variable = 0;
    Span read;
  };
  std::vector<Need> needs;  ///< read before the behaviour sets them
  std::vector<int> sets;    ///< set whenever it has run
  bool uncertain = false;   ///< something in it did not parse
};

/// Definite assignment in textual order (LANGUAGE S10). Variables set are kept in a flag each and a
/// trail, so that a branch is undone in the time it took.
class AssignmentChecker {
 public:
  explicit AssignmentChecker(const Subject& subject) : subject_(subject) {}

  void run() {
    for (const auto& behaviour : subject_.script.behaviours) note_targets(behaviour.statements);
    note_targets(subject_.script.statements);
    summaries_.resize(subject_.script.behaviours.size());
    for (const int behaviour : subject_.behaviours.order) {
      if (subject_.behaviours.recursive[behaviour]) {
        summaries_[behaviour].uncertain = true;
        continue;
      }
      summarise(behaviour);
      if (entries_ > kMaxSummaryEntries) return;
    }
    in_main_ = true;
    uncertain_ = false;
    walk(subject_.script.statements);
    for (std::size_t i = 0; i < summaries_.size(); ++i) {
      if (!subject_.behaviours.reachable[i]) report_never_set(summaries_[i]);
    }
  }

 private:
  int index_of(const syntax::QualifiedName& name) {
    const auto [place, is_new] = variables_.emplace(name.text(), static_cast<int>(names_.size()));
    if (is_new) {
      names_.push_back(place->first);
      is_set_.push_back(false);
      is_target_.push_back(false);
      reported_.push_back(false);
      needed_by_.push_back(-1);
      seen_in_branch_.push_back(0);
    }
    return place->second;
  }

  void note_targets(const std::vector<Statement>& statements) {
    for (const Statement& statement : statements) {
      if (statement.kind == Statement::Kind::assignment)
        is_target_[index_of(statement.name)] = true;
      note_targets(statement.elements);
      for (const syntax::Module& module : statement.modules) note_targets(module.statements);
    }
  }

  void summarise(int behaviour) {
    current_ = behaviour;
    uncertain_ = false;
    const std::size_t mark = trail_.size();
    walk(subject_.script.behaviours[behaviour].statements);
    Summary& summary = summaries_[behaviour];
    summary.sets = undo_to(mark);
    summary.uncertain = uncertain_;
    entries_ += summary.sets.size() + summary.needs.size();
  }

  void set(int variable) {
    if (is_set_[variable]) return;
    is_set_[variable] = true;
    trail_.push_back(variable);
  }

  std::vector<int> undo_to(std::size_t mark) {
    std::vector<int> undone(trail_.begin() + static_cast<std::ptrdiff_t>(mark), trail_.end());
    for (const int variable : undone) is_set_[variable] = false;
    trail_.resize(mark);
    return undone;
  }

  void read(int variable, Span place, const Span* use) {
    if (uncertain_ || is_set_[variable]) return;
    if (in_main_) {
      report(variable, place, use);
    } else if (needed_by_[variable] != current_) {
      needed_by_[variable] = current_;
      summaries_[current_].needs.push_back({variable, place});
    }
  }

  void report(int variable, Span place, const Span* use) {
    // One missing assignment is one mistake, however often the variable is read.
    if (reported_[variable]) return;
    reported_[variable] = true;
    Diagnostic unset;
    unset.code = "S10";
    unset.span = place;
    unset.message = "variable '" + names_[variable] + "' is read before it is set";
    if (!is_target_[variable]) {
      const std::string near = suggester_.nearest(names_[variable], [&] {
        std::vector<std::string> candidates;
        for (std::size_t i = 0; i < names_.size(); ++i) {
          if (is_target_[i]) candidates.push_back(names_[i]);
        }
        return candidates;
      });
      if (!near.empty()) unset.message += "; did you mean " + near + "?";
    }
    if (use != nullptr) unset.notes.push_back({*use, "the behaviour is run here"});
    subject_.diagnostics.add(std::move(unset));
  }

  void report_never_set(const Summary& summary) {
    if (summary.uncertain || uncertain_) return;
    for (const Summary::Need& need : summary.needs) {
      if (!is_target_[need.variable]) report(need.variable, need.read, nullptr);
    }
  }

  void read_all(const syntax::ExpressionPtr& expression) {
    if (!expression) return;
    for_each_subexpression(*expression, [this](const syntax::Expression& part) {
      if (part.kind == syntax::Expression::Kind::variable) {
        read(index_of(part.name), part.span, nullptr);
      }
    });
  }

  void walk(const std::vector<Statement>& statements) {
    for (const Statement& statement : statements) walk(statement);
  }

  void walk(const Statement& statement) {
    switch (statement.kind) {
      case Statement::Kind::assignment:
        read_all(statement.value);
        set(index_of(statement.name));
        break;
      case Statement::Kind::move_to:
      case Statement::Kind::move_dir:
        read_all(statement.value);
        break;
      case Statement::Kind::together:
        walk(statement.elements);
        break;
      case Statement::Kind::wait:
        break;
      case Statement::Kind::use:
        walk_use(statement);
        break;
      case Statement::Kind::chain:
      case Statement::Kind::cycle:
      case Statement::Kind::first:
      case Statement::Kind::each:
        walk_elements(statement);
        break;
      case Statement::Kind::which:
        walk_which(statement);
        break;
      case Statement::Kind::broken:
        uncertain_ = true;
        break;
    }
  }

  void walk_use(const Statement& statement) {
    if (statement.value) {  // stop: what follows is not reached
      for (std::size_t i = 0; i < is_target_.size(); ++i) {
        if (is_target_[i]) set(static_cast<int>(i));
      }
      return;
    }
    const auto found = subject_.behaviours.index.find(statement.name.text());
    if (found == subject_.behaviours.index.end()) return;
    const Summary& summary = summaries_[found->second];
    for (const Summary::Need& need : summary.needs) read(need.variable, need.read, &statement.span);
    for (const int variable : summary.sets) set(variable);
    uncertain_ = uncertain_ || summary.uncertain;
  }

  void walk_elements(const Statement& statement) {
    std::size_t i = 0;
    for (;
         i < statement.elements.size() && statement.elements[i].kind == Statement::Kind::assignment;
         ++i) {
      walk(statement.elements[i]);
    }
    const std::size_t mark = trail_.size();
    for (; i < statement.elements.size(); ++i) walk(statement.elements[i]);
    undo_to(mark);
    // The exit condition may be tested when no more than the leading assignments have run.
    read_all(statement.until);
  }

  void walk_which(const Statement& statement) {
    bool has_default = false;
    std::vector<std::vector<int>> branches;
    for (const syntax::Module& module : statement.modules) {
      for (const syntax::Label& label : module.labels) {
        has_default = has_default || label.kind == syntax::Label::Kind::otherwise;
        read_all(label.condition);
      }
      const std::size_t mark = trail_.size();
      walk(module.statements);
      branches.push_back(undo_to(mark));
    }
    if (!has_default) return;
    std::vector<int> in_all;
    for (const std::vector<int>& branch : branches) {
      for (const int variable : branch) {
        if (++seen_in_branch_[variable] == branches.size()) in_all.push_back(variable);
      }
    }
    for (const std::vector<int>& branch : branches) {
      for (const int variable : branch) seen_in_branch_[variable] = 0;
    }
    for (const int variable : in_all) set(variable);
  }

  const Subject& subject_;
  Suggester suggester_;
  std::map<std::string, int> variables_;
  std::vector<std::string> names_;
  std::vector<bool> is_set_, is_target_, reported_;
  std::vector<int> needed_by_;               // the last behaviour in whose needs it is
  std::vector<std::size_t> seen_in_branch_;  // scratch of walk_which
  std::vector<int> trail_;                   // variables in the order they were set
  std::vector<Summary> summaries_;
  std::size_t entries_ = 0;
  int current_ = -1;  // the behaviour being summarised
  bool in_main_ = false;
  bool uncertain_ = false;  // a statement before this one did not parse and may have set anything
};

}  // namespace

void check_assignment(const Subject& subject) { AssignmentChecker(subject).run(); }

}  // namespace rubicon::interpreter::script_check
