#pragma once

#include <functional>
#include <string>
#include <variant>

#include "src/exchange/urdf/import_machine.hpp"

namespace rubicon::urdf {

/// Whether this is a build with sanitizers: they reserve terabytes of address space and open pipes
/// to look at memory, so that the child has no limit of memory and no filter of system calls.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kSanitized = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif
#else
inline constexpr bool kSanitized = false;
#endif

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
