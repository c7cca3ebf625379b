#pragma once

#include <string_view>

/// The texts of help. Those of commands are what `rubicon help NAME` prints, and docs/commands
/// carries them; a test compares.
namespace rubicon::cli::pages {

/// What stands before and behind the list of commands in the overview.
extern const std::string_view kOverviewBegin, kOverviewEnd;

extern const std::string_view kCheck, kRun, kStudy, kWhy, kGuides, kFlow, kLayout, kReport, kDebug,
    kTest, kVerify, kImport, kExport, kFmt, kHelp;

}  // namespace rubicon::cli::pages
