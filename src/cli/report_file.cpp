#include "src/cli/report_file.hpp"

#include "src/results/page/report_page.hpp"

namespace rubicon::cli {

void ReportWriter::line(std::string_view text) {
  trace_.add(text);
  trace_.add("\n");
  film_.line(text);
}

std::string ReportWriter::page(const std::string& schedule) {
  page::PageOrigin origin;
  origin.trace = encoding::hex(trace_.finish());
  if (!schedule.empty()) origin.schedule = encoding::sha256_hex(schedule);
  return page::report_page(page::viewer_page(), film_.finish(schedule), origin);
}

}  // namespace rubicon::cli
