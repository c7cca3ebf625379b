#pragma once

#include <functional>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace rubicon::cli {

/// A file of a result that cannot be used, in a message for the user that begins with its name.
class WrongInput : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// All bytes of a file. Throws WrongInput where it is not there, is none (a pipe that nobody writes
/// to must not hang) or cannot be read to its end.
std::string read_input(const std::string& path);

/// Gives each line of a trace, packed (gzip) or not, to `take`. Throws WrongInput as above and for
/// an empty file; what `take` throws as std::invalid_argument or verify::UnreadableInput becomes
/// one with the line.
void each_trace_line(const std::string& path, const std::function<void(const std::string&)>& take);

/// The same for the first line of a trace, its header.
std::string read_trace_header(const std::string& path);

/// What is wrong with a call that would write over one of the files that it reads, or write two
/// outputs into one file, however these are spelled, linked or hard linked; a message, or nothing.
/// Empty names and "-" are no files. Every command that writes a file asks this with all files that
/// it read (DiskFiles::read), also those that its plan names, before it writes, and where it can
/// before it computes.
std::optional<std::string> overwriting(const std::set<std::string>& inputs,
                                       const std::vector<std::string>& outputs);

}  // namespace rubicon::cli
