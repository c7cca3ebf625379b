#pragma once

#include <functional>
#include <string>
#include <variant>

#include "src/exchange/urdf/import_machine.hpp"

namespace rubicon::urdf {

/// An import, with what is to be said of it.
struct GuardedImport {
  std::string messages;
  std::optional<MachineImport> machine;  ///< nothing after an error
};

/// Diagnostics as they are printed.
using Printer =
    std::function<std::string(const interpreter::Diagnostics&, const interpreter::SourceMap&)>;

/// `import_machine` in a child process that has no files, no network and limited memory: it asks
/// for each file over a socket, and gets those that `files` lets it have. What it answers is not
/// trusted. A message if it does not answer. Not to be called while other threads run.
std::variant<GuardedImport, std::string> import_guarded(const MachineTerms& terms,
                                                        const std::string& text,
                                                        PackageFiles& files, const Printer& print);

}  // namespace rubicon::urdf
