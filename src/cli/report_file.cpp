#include "src/cli/report_file.hpp"

#include <stdexcept>

#include "src/results/flow/material_flow.hpp"
#include "src/results/page/report_page.hpp"

namespace rubicon::cli {

void ReportWriter::line(std::string_view text) {
  trace_.add(text);
  trace_.add("\n");
  film_.line(text);
  if (!has_steps_) return;
  try {
    replay_.line(text);
  } catch (const std::invalid_argument&) {
    has_steps_ = false;  // a trace without steps is a film of tasks, and has no flow of material
  }
}

/// "" of a trace that does not tell it.
std::string ReportWriter::flow_text() {
  if (!has_steps_) return {};
  try {
    return flow::flow_json(flow::material_flow(replay_.finish()));
  } catch (const std::invalid_argument&) {
    return {};
  }
}

std::string ReportWriter::page(const std::string& schedule) {
  page::PageOrigin origin;
  origin.trace = encoding::hex(trace_.finish());
  if (!schedule.empty()) origin.schedule = encoding::sha256_hex(schedule);
  return page::report_page(page::viewer_page(), film_.finish(schedule, flow_text()), origin);
}

}  // namespace rubicon::cli
