#include "src/cli/input_file.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>

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

[[noreturn]] void fail_empty(const std::string& path) {
  throw WrongInput(fmt::format("{}:1: expected the header of a trace, found nothing", path));
}

/// Whether two names mean one file, be it there or yet to be written.
bool is_same_file(const std::string& one, const std::string& other) {
  std::error_code error;
  if (std::filesystem::equivalent(one, other, error)) {
    return std::filesystem::is_regular_file(one, error);
  }
  const auto whole = [&](const std::string& path) {
    return std::filesystem::weakly_canonical(std::filesystem::absolute(path, error), error);
  };
  return !std::filesystem::exists(one, error) && !whole(one).empty() && whole(one) == whole(other);
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
  std::ifstream file = open_input(path);
  int number = 0;
  for (std::string line; std::getline(file, line);) {
    ++number;
    try {
      take(line);
    } catch (const std::invalid_argument& error) {
      throw WrongInput(fmt::format("{}:{}: {}", path, number, error.what()));
    } catch (const verify::UnreadableInput& error) {  // it names the line itself
      throw WrongInput(fmt::format("{}:{}", path, error.what()));
    }
  }
  expect_whole(path, file);
  if (number == 0) fail_empty(path);
}

std::string read_trace_header(const std::string& path) {
  std::ifstream file = open_input(path);
  std::string line;
  std::getline(file, line);
  expect_whole(path, file);
  if (line.empty()) fail_empty(path);
  return line;
}

std::optional<std::string> overwriting(const std::vector<std::string>& inputs,
                                       const std::vector<std::string>& outputs) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    if (!is_file_name(outputs[i])) continue;
    for (const std::string& input : inputs) {
      if (is_same_file(input, outputs[i])) {
        return fmt::format("'{}' is read here: write to another file", outputs[i]);
      }
    }
    for (std::size_t k = 0; k < i; ++k) {
      if (is_file_name(outputs[k]) && is_same_file(outputs[k], outputs[i])) {
        return fmt::format("two outputs cannot go into one file, '{}'", outputs[i]);
      }
    }
  }
  return std::nullopt;
}

}  // namespace rubicon::cli
