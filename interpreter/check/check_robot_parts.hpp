#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "interpreter/check/check.hpp"
#include "interpreter/check/resolve_formula.hpp"
#include "interpreter/syntax/name_suggestion.hpp"

/// What the parts of check_robot share; nothing here is for other files.
namespace rubicon::interpreter::robot_check {

/// Most bodies of a robot; poses walk up the chain of bodies.
inline constexpr std::size_t kMaxBodies = 1000;

/// Most operations of a derived parameter once the derived parameters it uses are put in.
inline constexpr std::size_t kMaxFormulaSize = 10000;

/// A rope of the model, and where the file declares it.
struct DeclaredRope {
  int index = 0;  ///< of its body in the model
  Span span;
};

/// One robot on its way from syntax to model.
struct Subject {
  syntax::Robot& robot;  ///< its inline scripts are moved out at the end
  robot::RobotModel& model;
  Diagnostics& diagnostics;
  NameSuggestions suggestions = {};

  std::map<std::string, ResolvedFormula> constants = {};         ///< folded
  std::map<std::string, Span> constant_spans = {};               ///< all, also those to come
  std::vector<syntax::BodyItem*> bodies = {};                    ///< per model body
  std::vector<const syntax::ParameterItem*> parameters = {};     ///< per model parameter
  std::map<std::string, int> body_index = {};                    ///< by name
  std::map<std::string, DeclaredRope> ropes = {};                ///< by name
  std::vector<std::map<std::string, int>> body_parameters = {};  ///< per body: index by name
  std::vector<std::optional<ResolvedFormula>> derived = {};      ///< per parameter, where computed
  std::vector<bool> derived_done = {};                           ///< per parameter
  std::vector<int> derived_path =
      {};  ///< derived parameters being computed, each for the one before

  /// Names that a broken part of the file may have declared are not complained about.
  bool judges_names() const { return !robot.broken; }
  void twice(Span second, std::string message, Span first);
};

/// The names that a formula of one body may use.
class BodyNames : public FormulaNames {
 public:
  enum class Use { rule, frame, derived };
  BodyNames(Subject& subject, int body, Use use) : subject_(subject), body_(body), use_(use) {}
  /// R04 at the name.
  std::optional<ResolvedFormula> resolve(const syntax::QualifiedName& name,
                                         Diagnostics& diagnostics) override;

 private:
  std::optional<int> find_body(const syntax::QualifiedName& name);
  std::optional<ResolvedFormula> parameter(int index, const syntax::QualifiedName& name);
  std::optional<ResolvedFormula> step_or_start(int body, const syntax::QualifiedName& name);
  void report_unknown(int body, const syntax::QualifiedName& name);
  const char* use_text() const;

  Subject& subject_;
  int body_;
  Use use_;
};

/// The body of that name; -1 after reporting that there is none. `who` begins the message.
int find_body(Subject& subject, const syntax::Name& name, const char* who);

/// time_step and sensor: R01, R03, R07, F09.
void check_settings(Subject& subject);

/// How far the tool may be beside a straight way: R02, R07.
void check_deviation(Subject& subject);

/// Folds all constants: R02, R03, R16.
void check_constants(Subject& subject);

/// Declares bodies and parameters in file order: R02, R03, R05, R18.
void declare_bodies(Subject& subject);

/// Range, step, speed and the other attributes of all parameters: R01, R03, R06-R12, F09.
void check_attributes(Subject& subject);

/// Computes derived parameters in terms of the others: R15, and what their formulas deserve.
void check_derived(Subject& subject);

/// The value of derived parameter `index` in terms of parameters that are not derived; nothing
/// after reporting why there is none.
std::optional<ResolvedFormula> derived_formula(Subject& subject, int index);

/// Motion rules, and what follows from them (direct, free): R03, R13, R14, R21.
void check_rules(Subject& subject);

/// Frames, shapes, tool, touching bodies, load chart: R03, R05, R17, R20, F02-F13.
void check_geometry(Subject& subject, const std::string& path, FileProvider& files);

/// How far bodies keep from what is not of their robot: R02, R05, R07, R20.
void check_buffers(Subject& subject);

/// Ropes, as bodies of their own after all others: R02, R03, R05, R07, R20, F09. Before the
/// touching bodies are looked up.
void declare_ropes(Subject& subject);

/// Which angles are reduced to half a turn to either side: cyclic ones, and those derived from them
/// by whole turns. A cyclic one on which something else depends otherwise (half of it, a screw)
/// counts its turns instead and is no longer cyclic in the model: R22.
void check_turns(Subject& subject);

/// Display names, quanta and start values, once all else is known.
void complete_parameters(Subject& subject);

/// Reads and checks the behaviours of the robot and its bodies: R03, R19, F01 and those of scripts.
void check_behaviours(Subject& subject, CheckedRobot& checked, SourceMap& sources,
                      FileProvider& files, const std::vector<std::string>* plan_situations,
                      const GivenScript* script);

}  // namespace rubicon::interpreter::robot_check
