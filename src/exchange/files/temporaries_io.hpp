#pragma once

#include <memory>
#include <string>
#include <vector>

namespace rubicon::files {

struct TemporaryPaths;

/// Paths that are removed if INT, TERM, HUP or another signal that can be caught ends the program
/// while this stands: the files first, then the folders, which go only if they are empty. The
/// signal ends the program all the same.
class Temporaries {
 public:
  Temporaries();
  Temporaries(std::vector<std::string> files, std::vector<std::string> folders);
  Temporaries(Temporaries&& other) noexcept;
  Temporaries& operator=(Temporaries&& other) noexcept;
  ~Temporaries();

  /// Removes them now.
  void remove();
  /// They are no longer temporary.
  void release();

 private:
  std::unique_ptr<const TemporaryPaths> paths_;
};

/// While one of these stands, signals that end the program wait: for what must not stop half way.
class SignalHold {
 public:
  SignalHold();
  ~SignalHold();
  SignalHold(const SignalHold&) = delete;
  SignalHold& operator=(const SignalHold&) = delete;
};

}  // namespace rubicon::files
