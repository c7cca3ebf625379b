#include "src/results/gantt/charts_page.hpp"

#include <fmt/format.h>

#include <string_view>

#include "src/results/gantt/charts_picture.hpp"
#include "src/results/gantt/svg_style.hpp"
#include "src/results/gantt/svg_text.hpp"

namespace rubicon::gantt {

namespace {

constexpr std::string_view kPageStyle =
    "body{margin:0 auto;max-width:1640px;padding:0 20px 40px;font:15px/1.5 Helvetica,Arial,"
    "'Liberation Sans',sans-serif}"
    "svg{display:block;width:100%;height:auto;margin:16px 0}"
    "pre{overflow-x:auto;font:13px/1.45 'DejaVu Sans Mono',Menlo,Consolas,monospace}"
    "h2{margin:28px 0 4px;font-size:18px}summary{cursor:pointer;font-size:18px;font-weight:bold}"
    "details{margin-top:28px}";

std::string_view outcome_sentence(report::ChartsOutcome outcome) {
  if (outcome == report::ChartsOutcome::all_at_goals) return "All robots come to their goals.";
  if (outcome == report::ChartsOutcome::not_all_at_goals)
    return "Not all robots come to their goals.";
  return "Not settled: the robots push each other on without end.";
}

}  // namespace

std::string charts_page(const report::ChartsResult& result) {
  const std::string name = xml_text(result.description.name);
  std::string page = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta "
      "name=\"viewport\" content=\"width=device-width\">\n<title>Charts of network {}</title>\n"
      "<style>body{{color:{};background:{}}}{}</style>\n</head>\n<body>\n",
      name, kColours.text, kColours.panel, kPageStyle);
  page += fmt::format("<p>{}</p>\n", outcome_sentence(report::outcome_of(result.course)));
  page += charts_picture(result) + network_picture(result);
  const std::string sensing = report::sensing_table(result);
  if (!sensing.empty()) {
    page += "<h2>How far robots have to see</h2>\n<pre>" + xml_text(sensing) + "</pre>\n";
  }
  page += "<details open>\n<summary>All charts, one after the other</summary>\n<pre>" +
          xml_text(report::charts_table(result)) + "</pre>\n</details>\n</body>\n</html>\n";
  return page;
}

}  // namespace rubicon::gantt
