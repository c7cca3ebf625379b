#include "src/cli/input_file.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string_view>
#include <system_error>

#include "src/exchange/encoding/gzip.hpp"
#include "src/results/verify/input/fault.hpp"

namespace rubicon::cli {

namespace {

std::ifstream open_input(const std::string& path) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) {
    throw WrongInput(fmt::format(
        "{}: there is no such file; 'rubicon run PLAN --out DIR' makes the folder of a result",
        path));
  }
  if (!std::filesystem::is_regular_file(status)) {
    throw WrongInput(fmt::format("{}: this is not a file", path));
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) throw WrongInput(fmt::format("{}: the file cannot be read", path));
  return file;
}

/// `bad` is also set where the memory does not suffice.
void expect_whole(const std::string& path, const std::ios& stream) {
  if (stream.bad()) throw WrongInput(fmt::format("{}: the file cannot be read to its end", path));
}

/// No trace has a longer line (bytes); a small packed file can have one.
constexpr std::size_t kLongestTraceLine = std::size_t{1} << 30;

/// Gives the lines of what comes in pieces to `take`, until it returns false.
class LineSplitter {
 public:
  explicit LineSplitter(const std::function<bool(const std::string&)>& take) : take_(take) {}

  bool wants_more() const { return wants_more_; }
  void add(std::string_view piece) {
    while (wants_more_) {
      const std::size_t end = piece.find('\n');
      line_ += piece.substr(0, end);
      if (line_.size() > kLongestTraceLine)
        throw std::invalid_argument("a line is longer than 1 GB");
      if (end == std::string_view::npos) return;
      wants_more_ = take_(line_);
      line_.clear();
      piece.remove_prefix(end + 1);
    }
  }
  /// The last line need not end as the others do.
  void finish() {
    if (wants_more_ && !line_.empty()) take_(line_);
  }

 private:
  const std::function<bool(const std::string&)>& take_;
  std::string line_;
  bool wants_more_ = true;
};

/// Gives the lines of a file, packed or not, to `take`, until it returns false.
void each_line(const std::string& path, const std::function<bool(const std::string&)>& take) {
  std::ifstream file = open_input(path);
  LineSplitter lines(take);
  std::optional<encoding::GzipReader> unpack;
  std::vector<char> buffer(1 << 16);
  const auto next = [&] {
    file.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
    return std::string_view(buffer.data(), static_cast<std::size_t>(file.gcount()));
  };
  try {
    std::string_view piece = next();
    if (encoding::is_gzip(piece)) {
      unpack.emplace([&](std::string_view unpacked) { lines.add(unpacked); });
    }
    for (; !piece.empty() && lines.wants_more(); piece = next()) {
      if (unpack) {
        unpack->read(piece);
      } else {
        lines.add(piece);
      }
    }
    expect_whole(path, file);
    if (unpack && lines.wants_more()) unpack->finish();
    lines.finish();
  } catch (const std::invalid_argument& error) {
    throw WrongInput(fmt::format("{}: {}", path, error.what()));
  }
}

[[noreturn]] void fail_empty(const std::string& path) {
  throw WrongInput(fmt::format("{}:1: expected the header of a trace, found nothing", path));
}

/// The same text for all names, links and hard links of one file, be it there or yet to be written;
/// "" of what is no file, as a device.
std::string identity_of(const std::string& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) == 0) {
    return S_ISREG(status.st_mode) ? fmt::format("{}:{}", status.st_dev, status.st_ino) : "";
  }
  std::error_code error;
  return std::filesystem::weakly_canonical(std::filesystem::absolute(path, error), error).string();
}

bool is_file_name(const std::string& path) { return !path.empty() && path != "-"; }

}  // namespace

std::string read_input(const std::string& path) {
  const std::ifstream file = open_input(path);
  std::ostringstream text;
  text << file.rdbuf();
  expect_whole(path, text);
  return text.str();
}

void each_trace_line(const std::string& path, const std::function<void(const std::string&)>& take) {
  int number = 0;
  each_line(path, [&](const std::string& line) {
    ++number;
    try {
      take(line);
    } catch (const std::invalid_argument& error) {
      throw WrongInput(fmt::format("{}:{}: {}", path, number, error.what()));
    } catch (const verify::UnreadableInput& error) {  // it names the line itself
      throw WrongInput(fmt::format("{}:{}", path, error.what()));
    }
    return true;
  });
  if (number == 0) fail_empty(path);
}

std::string read_trace_header(const std::string& path) {
  std::string header;
  each_line(path, [&](const std::string& line) {
    header = line;
    return false;
  });
  if (header.empty()) fail_empty(path);
  return header;
}

std::optional<std::string> overwriting(const std::set<std::string>& inputs,
                                       const std::vector<std::string>& outputs) {
  std::set<std::string> read;
  std::set<std::string> written;
  for (const std::string& input : inputs) {
    if (is_file_name(input)) read.insert(identity_of(input));
  }
  for (const std::string& output : outputs) {
    if (!is_file_name(output)) continue;
    const std::string identity = identity_of(output);
    if (identity.empty()) continue;
    if (read.count(identity) != 0) {
      return fmt::format("'{}' is read here: write to another file", output);
    }
    if (!written.insert(identity).second) {
      return fmt::format("two outputs cannot go into one file, '{}'", output);
    }
  }
  return std::nullopt;
}

}  // namespace rubicon::cli
