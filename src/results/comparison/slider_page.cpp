#include "src/results/comparison/slider_page.hpp"

#include <fmt/format.h>

#include "src/results/gantt/svg_text.hpp"
#include "src/results/palette/palette.hpp"

namespace rubicon::comparison {

namespace {

constexpr const char* kLayerScript = R"(
const layers = document.querySelectorAll("svg .layer");
const slider = document.getElementById("value");
const told = document.getElementById("told");
const values = slider.dataset.values.split("|");
const show = () => {
  layers.forEach((layer, k) => layer.setAttribute("display", k % values.length === slider.valueAsNumber ? "inline" : "none"));
  told.textContent = values[slider.valueAsNumber];
  slider.setAttribute("aria-valuetext", told.textContent);
};
slider.addEventListener("input", show);
show();
)";

}  // namespace

std::string layer_begin(bool shown) {
  return fmt::format("<g class=\"layer\" display=\"{}\">\n", shown ? "inline" : "none");
}

std::string slider_page(const SliderPage& page) {
  const palette::Drawing& colours = palette::kDrawing;
  std::string values;
  for (const std::string& value : page.values) {
    values += (values.empty() ? "" : "|") + gantt::xml_text(value);
  }
  const std::string name = gantt::xml_text(page.name);
  const std::string first = gantt::xml_text(page.values[page.first]);
  return fmt::format(
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>{0}</title>\n<style>\n"
      "body {{ margin: 16px; font: 14px sans-serif; color: {1}; background: {2}; }}\n"
      "svg {{ display: block; max-width: 100%; height: auto; }}\n"
      "form {{ display: flex; gap: 12px; align-items: center; max-width: 728px; }}\n"
      "input {{ flex: 1; }}\noutput {{ min-width: 7em; font-variant-numeric: tabular-nums; }}\n"
      "</style>\n</head>\n<body>\n<form onsubmit=\"return false\">\n"
      "<label for=\"value\">{3}</label>\n"
      "<input type=\"range\" id=\"value\" min=\"0\" max=\"{4}\" step=\"1\" value=\"{5}\" "
      "autocomplete=\"off\" data-values=\"{6}\">\n"
      "<output id=\"told\" for=\"value\">{7}</output>\n</form>\n"
      "{8}<script>{9}</script>\n</body>\n</html>\n",
      gantt::xml_text(page.title), colours.text, colours.panel, name, page.values.size() - 1,
      page.first, values, first, page.svg, kLayerScript);
}

}  // namespace rubicon::comparison
