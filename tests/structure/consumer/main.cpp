#include <cstdio>

#include "interpreter/parse/parse.hpp"
#include "src/motion/math/angles.hpp"

namespace {

// Warned about by the options the library itself is built with: they must not reach its users.
int whole_part(double value) { return value; }

}  // namespace

int main() {
  using namespace rubicon;
  interpreter::SourceMap sources;
  interpreter::Diagnostics diagnostics;
  const auto file = sources.add("consumer.motion", "chain { move_to(x goal(x)) };\n");
  interpreter::parse_script(sources, file, diagnostics);
  if (diagnostics.errors() != 1 || whole_part(2 * math::sin_deg(30)) != 1) {
    std::puts("the installed library gives wrong answers");
    return 1;
  }
  std::puts(diagnostics.all().front().message.c_str());
}
