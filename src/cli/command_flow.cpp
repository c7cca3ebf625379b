#include <cstdio>
#include <stdexcept>
#include <string>

#include "src/cli/commands.hpp"
#include "src/cli/fail.hpp"
#include "src/cli/trace_source.hpp"
#include "src/results/flow/material_flow.hpp"

namespace rubicon::cli {

namespace {

class ReplaySink : public trace::TraceSink {
 public:
  void line(std::string_view text) override { reader_.line(text); }
  void restart() override { reader_ = {}; }
  replay::Replay finish() { return reader_.finish(); }

 private:
  replay::ReplayReader reader_;
};

}  // namespace

int run_flow(const FlowOptions& options) {
  ReplaySink sink;
  if (!stream_trace(options.source, options.set, sink)) return kWrongInput;
  std::string text;
  try {
    const flow::MaterialFlow found = flow::material_flow(sink.finish());
    text = options.format == "json"  ? flow::flow_json(found)
           : options.format == "csv" ? flow::flow_csv(found)
                                     : flow::flow_text(found);
  } catch (const std::invalid_argument& error) {
    return fail(error.what());
  }
  std::fwrite(text.data(), 1, text.size(), stdout);
  return kFine;
}

}  // namespace rubicon::cli
