#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "tests/unit/grammar/format_oracle.hpp"

/// Any bytes as a behaviour: no crash, no hang, and the formatter keeps its promises.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const std::string fault =
      rubicon::grammar_test::check_formatting(text, rubicon::interpreter::TextKind::script);
  if (!fault.empty()) {
    std::fputs(fault.c_str(), stderr);
    std::abort();
  }
  return 0;
}
