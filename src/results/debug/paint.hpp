#pragma once

#include <string>

namespace rubicon::debug {

/// Colours of a terminal, or none.
struct Paint {
  bool on = false;

  std::string bold(const std::string& text) const { return with("\x1b[1m", text); }
  std::string dim(const std::string& text) const { return with("\x1b[2m", text); }
  std::string good(const std::string& text) const { return with("\x1b[32m", text); }
  std::string bad(const std::string& text) const { return with("\x1b[1;31m", text); }
  std::string mark(const std::string& text) const { return with("\x1b[36m", text); }

 private:
  std::string with(const char* code, const std::string& text) const {
    return on ? code + text + "\x1b[0m" : text;
  }
};

}  // namespace rubicon::debug
