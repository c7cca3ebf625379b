#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace rubicon::comparison {

/// A picture with layers of which a slider shows one.
struct SliderPage {
  std::string title;
  std::string svg;                  ///< layers for each value in order, once or more
  std::string name;                 ///< of what the slider changes
  std::vector<std::string> values;  ///< with units
  std::size_t first = 0;            ///< shown at the beginning
};

/// As one HTML file that needs nothing else. Without scripts it shows the first layer.
std::string slider_page(const SliderPage& page);

/// The opening tag of a layer.
std::string layer_begin(bool shown);

}  // namespace rubicon::comparison
