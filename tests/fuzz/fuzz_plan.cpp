#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "interpreter/check/plan_model.hpp"
#include "tests/unit/grammar/format_oracle.hpp"

namespace {

/// The text alone: no robot, no mesh, and it imports itself.
class OneText : public rubicon::interpreter::FileProvider {
 public:
  explicit OneText(std::string_view text) : text_(text) {}
  std::variant<std::string, rubicon::interpreter::FileFailure> read_text(
      const std::string& path) override {
    if (path.ends_with(".robot")) return rubicon::interpreter::FileFailure{"there is no such file"};
    return text_;
  }
  std::variant<std::shared_ptr<const rubicon::geometry::TriangleMesh>,
               rubicon::interpreter::FileFailure>
  read_mesh(const rubicon::interpreter::MeshRequest&) override {
    return rubicon::interpreter::FileFailure{"there is no such file"};
  }

 private:
  std::string text_;
};

}  // namespace

/// Any bytes as a plan: no crash, no hang, the formatter keeps its promises, and what is repeated,
/// counted and imported stays within bounds.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const std::string fault =
      rubicon::grammar_test::check_formatting(text, rubicon::interpreter::TextKind::plan);
  if (!fault.empty()) {
    std::fputs(fault.c_str(), stderr);
    std::abort();
  }
  OneText files(text);
  rubicon::interpreter::SourceMap sources;
  rubicon::interpreter::Diagnostics diagnostics;
  load_plan("p.plan", sources, files, diagnostics);
  return 0;
}
