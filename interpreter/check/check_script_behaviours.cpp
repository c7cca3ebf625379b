#include <algorithm>
#include <utility>

#include "interpreter/check/check_script_parts.hpp"
#include "interpreter/functions/function_table.hpp"
#include "src/motion/guides/leg.hpp"
#include "src/motion/robot/tool_line.hpp"

namespace rubicon::interpreter::script_check {

namespace {

using syntax::Statement;

class BehaviourChecker {
 public:
  BehaviourChecker(const syntax::Script& script, const ScriptContext& context,
                   Diagnostics& diagnostics)
      : script_(script), context_(context), diagnostics_(diagnostics) {}

  Behaviours run() {
    for (std::size_t i = 0; i < script_.behaviours.size(); ++i) define(static_cast<int>(i));
    for (std::size_t i = 0; i < script_.behaviours.size(); ++i) {
      collect(script_.behaviours[i].statements, static_cast<int>(i), false);
    }
    collect(script_.statements, -1, false);
    group_uses();
    find_recursion();
    follow_main();
    return std::move(result_);
  }

 private:
  void define(int i) {
    const syntax::Name& name = script_.behaviours[i].name;
    const auto& bodies = context_.body_behaviours;
    if (std::find(bodies.begin(), bodies.end(), name.text) != bodies.end()) {
      diagnostics_.error("S14", name.span,
                         "'" + name.text +
                             "' is already the behaviour of the body of that name; "
                             "choose another name");
    }
    const auto [place, is_new] = result_.index.emplace(name.text, i);
    if (is_new && (name.text == kFollow || name.text == kLine)) {
      diagnostics_.warning(
          "W10", name.span,
          "this behaviour hides the one that every robot has: " +
              std::string(name.text == kFollow ? "follow, the next step of the leg"
                                               : "line, the next step of the tool's straight way"));
    }
    if (is_new) return;
    Diagnostic twice;
    twice.code = "S14";
    twice.span = name.span;
    twice.message = "behaviour '" + name.text + "' is defined twice";
    twice.notes.push_back({script_.behaviours[place->second].name.span, "first defined here"});
    diagnostics_.add(std::move(twice));
  }

  // Depth is bounded by the parser's limit on nesting.
  void collect(const std::vector<Statement>& statements, int user, bool in_loop) {
    for (const Statement& statement : statements) {
      if (statement.kind == Statement::Kind::use) {
        resolve(statement, user, in_loop);
        continue;
      }
      const bool repeats = in_loop || statement.kind == Statement::Kind::chain ||
                           statement.kind == Statement::Kind::cycle ||
                           statement.kind == Statement::Kind::first;
      collect(statement.elements, user, repeats);
      for (const syntax::Module& module : statement.modules) {
        collect(module.statements, user, repeats);
      }
    }
  }

  void resolve(const Statement& statement, int user, bool in_loop) {
    const std::string name = statement.name.text();
    if (statement.value) {
      check_stop(*statement.value);
      return;
    }
    const auto found = result_.index.find(name);
    if (found != result_.index.end()) {
      result_.uses.push_back({user, found->second, in_loop, statement.keyword});
      return;
    }
    const auto& bodies = context_.body_behaviours;
    if (std::find(bodies.begin(), bodies.end(), name) != bodies.end()) return;
    if (name == kFollow || name == kLine) {
      check_built_in(statement, name);
      return;
    }
    if (find_function(name) != nullptr) {
      diagnostics_.error(
          "S06", statement.keyword,
          "'" + name + "' is a function: it gives a value and cannot stand as a statement");
      return;
    }
    if (context_.robot == nullptr) return;  // it may be a body's behaviour
    std::string message = "unknown behaviour '" + name + "'";
    const robot::RobotModel& robot = *context_.robot;
    const bool is_body = std::any_of(robot.bodies.begin(), robot.bodies.end(),
                                     [&](const robot::Body& body) { return body.name == name; });
    if (is_body) {
      message += "; body '" + name + "' has no behaviour of its own";
    } else {
      const std::string near = suggester_.nearest(name, [&] {
        std::vector<std::string> candidates = bodies;
        for (const auto& each : script_.behaviours) candidates.push_back(each.name.text);
        candidates.emplace_back(kFollow);
        candidates.emplace_back(kLine);
        return candidates;
      });
      if (!near.empty()) message += "; did you mean " + near + "?";
    }
    diagnostics_.error("S05", statement.keyword, std::move(message));
  }

  void check_stop(const syntax::Expression& reason) {
    const std::string name = reason.name.text();
    if (name == "unreachable") return;
    diagnostics_.error("S05", reason.span, "a script cannot stop with '" + name + "'",
                       "write stop(unreachable); a script that ends at its goal needs no stop");
  }

  /// `follow`, which every robot has whose rules allow legs, and `line`.
  void check_built_in(const Statement& statement, const std::string& name) {
    if (context_.robot == nullptr) return;
    robot::Mounting mounting;
    mounting.starts = context_.robot->start_values();
    const std::string refusal = name == kFollow
                                    ? guides::Leg(*context_.robot, mounting).refusal()
                                    : robot::ToolLine(*context_.robot, mounting, {}, {}).refusal();
    if (refusal.empty()) return;
    diagnostics_.error("S16", statement.keyword,
                       "robot '" + context_.robot->name + "' cannot " +
                           (name == kFollow ? "follow: " : "keep to a line: ") + refusal,
                       "write its steps with move_to");
  }

  void group_uses() {
    used_.resize(script_.behaviours.size());
    for (const Use& use : result_.uses) {
      if (use.user >= 0) used_[use.user].push_back(use.used);
    }
  }

  // Tarjan's strongly connected components without recursion (behaviours may use each other 100,000
  // deep); they come out with used behaviours before their users.
  void find_recursion() {
    const int count = static_cast<int>(script_.behaviours.size());
    std::vector<int> number(count, -1), low(count, 0), component(count, -1);
    std::vector<std::size_t> next(count, 0);
    std::vector<int> path, open;
    int numbers = 0, components = 0;
    for (int root = 0; root < count; ++root) {
      if (number[root] >= 0) continue;
      path.push_back(root);
      while (!path.empty()) {
        const int at = path.back();
        if (next[at] == 0 && number[at] < 0) {
          number[at] = low[at] = numbers++;
          open.push_back(at);
        }
        if (next[at] < used_[at].size()) {
          const int to = used_[at][next[at]++];
          if (number[to] < 0) {
            path.push_back(to);
          } else if (component[to] < 0) {
            low[at] = std::min(low[at], number[to]);
          }
          continue;
        }
        path.pop_back();
        if (!path.empty()) low[path.back()] = std::min(low[path.back()], low[at]);
        if (low[at] != number[at]) continue;
        int member = -1;
        do {
          member = open.back();
          open.pop_back();
          component[member] = components;
          result_.order.push_back(member);
        } while (member != at);
        ++components;
      }
    }
    result_.recursive.assign(count, false);
    for (const Use& use : result_.uses) {
      if (use.user < 0 || component[use.user] != component[use.used]) continue;
      result_.recursive[use.user] = result_.recursive[use.used] = true;
      diagnostics_.error("S14", use.span,
                         "behaviour '" + script_.behaviours[use.used].name.text + "' uses itself");
    }
  }

  void follow_main() {
    std::vector<int> in_loop, on_its_own;
    for (const Use& use : result_.uses) {
      if (use.user < 0) (use.in_loop ? in_loop : on_its_own).push_back(use.used);
    }
    // What a repeated behaviour uses is repeated too.
    std::vector<std::vector<int>> used_in_loop(used_.size());
    for (const Use& use : result_.uses) {
      if (use.user >= 0 && use.in_loop) used_in_loop[use.user].push_back(use.used);
    }
    std::vector<bool> reached(used_.size(), false), repeated(used_.size(), false);
    const auto spread = [](std::vector<int> open, const std::vector<std::vector<int>>& next,
                           std::vector<bool>& seen) {
      while (!open.empty()) {
        const int at = open.back();
        open.pop_back();
        if (seen[at]) continue;
        seen[at] = true;
        open.insert(open.end(), next[at].begin(), next[at].end());
      }
    };
    std::vector<int> all = in_loop;
    all.insert(all.end(), on_its_own.begin(), on_its_own.end());
    spread(std::move(all), used_, reached);
    for (std::size_t i = 0; i < used_.size(); ++i) {
      if (reached[i]) in_loop.insert(in_loop.end(), used_in_loop[i].begin(), used_in_loop[i].end());
    }
    spread(std::move(in_loop), used_, repeated);
    result_.reachable = reached;
    result_.on_its_own.resize(used_.size());
    for (std::size_t i = 0; i < used_.size(); ++i) {
      result_.on_its_own[i] = reached[i] && !repeated[i];
    }
  }

  const syntax::Script& script_;
  const ScriptContext& context_;
  Diagnostics& diagnostics_;
  Suggester suggester_;
  Behaviours result_;
  std::vector<std::vector<int>> used_;  // per behaviour: those it runs, text order
};

}  // namespace

Behaviours check_behaviours(const syntax::Script& script, const ScriptContext& context,
                            Diagnostics& diagnostics) {
  return BehaviourChecker(script, context, diagnostics).run();
}

}  // namespace rubicon::interpreter::script_check
