#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <system_error>
#include <utility>

#include "src/cli/input_file.hpp"
#include "src/exchange/files/result_folder_io.hpp"

namespace rubicon::cli {

/// The files that `rubicon run --out` wrote into a folder. What reads them throws WrongInput.
class ResultFiles {
 public:
  explicit ResultFiles(std::string folder) : folder_(std::move(folder)) {}

  std::string schedule_path() const { return files::result_path(folder_, "schedule.json"); }
  std::string trace_path() const { return files::result_trace(folder_); }

  bool has_schedule() const { return is_there(schedule_path()); }
  bool has_trace() const { return is_there(trace_path()); }
  std::string schedule_json() const { return read_input(schedule_path()); }
  std::string trace_header() const { return read_trace_header(trace_path()); }
  void each_trace_line(const std::function<void(const std::string&)>& take) const {
    cli::each_trace_line(trace_path(), take);
  }

 private:
  static bool is_there(const std::string& path) {
    std::error_code error;
    return std::filesystem::exists(path, error);
  }

  std::string folder_;
};

}  // namespace rubicon::cli
