#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "tests/support/header_json.hpp"

namespace rubicon::test {

/// The header of a trace of one robot `r` with parameters x and y and the script `s.motion`.
inline std::string hand_header(const std::string& detail = "steps") {
  return whole_header({{"form", "short"},
                       {"detail", detail},
                       {"files",
                        {{{"path", "s.motion"},
                          {"text", "chain {\n  move_to(x, 3),\n  move_dir(y, 1)\n};\n"}}}},
                       {"robots",
                        {{{"name", "r"},
                          {"start", {{"x", 0}, {"y", 0}}},
                          {"bodies", {{{"name", "arm"}}}}}}}})
      .dump();
}

/// A record of the task `p` of robot `r`; `members` follow its type.
inline std::string hand_record(const std::string& type, const std::string& members) {
  return fmt::format(R"({{"type":"{}","task":"p","robot":"r"{}{}}})", type,
                     members.empty() ? "" : ",", members);
}

/// An attempt in line `line` of the script.
inline std::string hand_try(int n, const std::string& parameter, int line, bool ok, double t,
                            double x, double y, const std::string& reason = "limit x") {
  return hand_record(
      "try",
      fmt::format(R"("n":{},"command":"move_to","parameter":"{}","file":"s.motion","line":{},)"
                  R"("column":3,"ok":{},"reason":"{}","t":{},"q":{{"x":{},"y":{}}})",
                  n, parameter, line, ok, ok ? "" : reason, t, x, y));
}

/// The end of a motion; `members` are all but those that no debugger looks at.
inline std::string hand_end(const std::string& members) {
  return hand_record("end", R"("period":null,"residual":{},"vars":{},"rejected":{"at goal":0,)"
                            R"("no direction":0,"limit":0,"hit":0},)" +
                                members);
}

inline std::string hand_loop(const std::string& type, const std::string& more = "") {
  return hand_record(type, R"("kind":"chain","file":"s.motion","line":1,"column":1)" + more);
}

}  // namespace rubicon::test
