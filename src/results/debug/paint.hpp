#pragma once

#include <string>
#include <string_view>

#include "src/results/palette/palette.hpp"

namespace rubicon::debug {

/// Colours of a terminal, or none.
struct Paint {
  bool on = false;

  std::string bold(const std::string& text) const { return with("1", text); }
  std::string dim(const std::string& text) const { return with("2", text); }
  std::string good(const std::string& text) const { return with(palette::kTerminal.good, text); }
  std::string bad(const std::string& text) const { return with(palette::kTerminal.bad, text); }
  std::string mark(const std::string& text) const { return with(palette::kTerminal.mark, text); }

 private:
  std::string with(std::string_view code, const std::string& text) const {
    return on ? "\x1b[" + std::string(code) + "m" + text + "\x1b[0m" : text;
  }
};

}  // namespace rubicon::debug
