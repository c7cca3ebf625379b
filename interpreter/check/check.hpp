#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "interpreter/syntax/diagnostic.hpp"
#include "interpreter/syntax/file_provider.hpp"
#include "interpreter/syntax/syntax.hpp"
#include "src/motion/robot/robot_model.hpp"

namespace rubicon::interpreter {

/// What a script may refer to.
struct ScriptContext {
  const robot::RobotModel* robot = nullptr;  ///< null: only the checks that need no robot
  int body = -1;  ///< >= 0: the behaviour of this body; its parameters are known unqualified
  std::vector<std::string>
      body_behaviours;  ///< bodies that have a behaviour of their own, usable by name
  std::vector<std::string> plan_situations;  ///< set by the plan
  bool has_plan = false;                     ///< W08 is given only with a plan
};

/// The behaviour that every robot has: the next step of the leg to the waypoint.
inline constexpr const char* kFollow = "follow";

/// The behaviour that every robot has: the next step of the straight way of its tool.
inline constexpr const char* kLine = "line";

/// Situations every plan may meet without naming them.
inline constexpr const char* kBuiltInSituations[] = {"transport", "place",   "via",       "safety",
                                                     "guided",    "working", "travelling"};

/// All static checks of LANGUAGE section 10 on one script (S05-S14, W01-W08, N01, N02). Broken
/// statements are passed over.
void check_script(const syntax::Script& script, const ScriptContext& context,
                  Diagnostics& diagnostics);

/// The parameter a script name means: exact, or of `body` first where `body` >= 0; -1 none, -2
/// ambiguous.
int resolve_parameter(const robot::RobotModel& robot, int body, const syntax::QualifiedName& name);

/// A robot file that was read and checked, with its behaviour. Trees are kept: compile reads them.
struct CheckedRobot {
  std::string path;
  robot::RobotModel model;
  std::vector<Span> body_spans;          ///< per body: its name token
  std::optional<syntax::Script> script;  ///< the robot's own behaviour, from a file or inline
  std::vector<std::optional<syntax::Script>> body_scripts;  ///< per body
  std::vector<syntax::GuideDeclaration> guides = {};        ///< in file order
  bool usable = false;                                      ///< no error in it or its scripts
};

/// Reads and checks a robot file and the behaviour it names. `plan_situations` null: no plan.
/// Errors go to `diagnostics`.
std::shared_ptr<const CheckedRobot> load_robot(const std::string& path, SourceMap& sources,
                                               FileProvider& files,
                                               const std::vector<std::string>* plan_situations,
                                               Diagnostics& diagnostics);

/// A script that a plan gives a robot.
struct GivenScript {
  syntax::String written;
  std::string path;
};

/// The same for a robot whose text is already in `sources`; `script`: in place of that of its file.
std::shared_ptr<const CheckedRobot> check_robot(FileId file, SourceMap& sources,
                                                FileProvider& files,
                                                const std::vector<std::string>* plan_situations,
                                                Diagnostics& diagnostics,
                                                const GivenScript* script = nullptr);

}  // namespace rubicon::interpreter
