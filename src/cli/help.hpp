#pragma once

#include <string_view>
#include <vector>

namespace rubicon::cli {

/// The help of one command: what `rubicon help CMD` and `rubicon CMD --help` print.
/// docs/commands/CMD.md carries the same text; a test compares them.
struct HelpPage {
  std::string_view name;
  std::string_view summary;
  std::string_view text;
};

const std::vector<HelpPage>& help_pages();
const HelpPage* find_help(std::string_view name);
/// What `rubicon` and `rubicon help` print.
std::string_view overview();

}  // namespace rubicon::cli
