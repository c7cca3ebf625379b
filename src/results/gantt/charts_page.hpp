#pragma once

#include <string>

#include "src/results/report/charts_text.hpp"

namespace rubicon::gantt {

/// A page on a network with policy charts, one HTML text that needs no other file: when robots are
/// where (the picture), the network in plan view with its classes of lanes and what was closed, how
/// far robots have to see, and all charts one after the other.
std::string charts_page(const report::ChartsResult& result);

/// The network in plan view, as one SVG text.
std::string network_picture(const report::ChartsResult& result);

}  // namespace rubicon::gantt
