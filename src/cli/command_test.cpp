#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "src/cli/commands.hpp"
#include "src/cli/input_file.hpp"
#include "src/cli/thread_count.hpp"
#include "src/exchange/files/atomic_file_io.hpp"
#include "src/exchange/files/disk_io.hpp"
#include "src/results/golden/golden_case.hpp"
#include "src/results/golden/golden_io.hpp"

namespace rubicon::cli {

namespace {

std::vector<std::string> selected_cases(const TestOptions& options) {
  std::vector<std::string> cases;
  std::set<std::string> known;
  for (const std::string& folder : options.folders) {
    for (std::string& one : golden::find_cases(folder)) {
      if (one.find(options.filter) == std::string::npos || !known.insert(one).second) continue;
      cases.push_back(std::move(one));
    }
  }
  return cases;
}

golden::CaseResult run_one(const std::string& folder) {
  files::DiskFiles disk;
  try {
    return golden::run_case(folder, golden::read_if_there(folder + "/expected.json"), disk);
  } catch (const std::exception& error) {
    golden::CaseResult result;
    result.name = folder;
    result.wrong_input = true;
    result.report = fmt::format("{}\n", error.what());
    return result;
  }
}

std::vector<golden::CaseResult> run_all(const std::vector<std::string>& cases, int jobs) {
  std::vector<golden::CaseResult> results(cases.size());
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < cases.size(); i = next++) results[i] = run_one(cases[i]);
  };
  const auto wanted = static_cast<std::size_t>(thread_count(jobs));
  std::vector<std::thread> threads;
  for (std::size_t i = 1; i < std::min(wanted, cases.size()); ++i) threads.emplace_back(work);
  work();
  for (std::thread& thread : threads) thread.join();
  return results;
}

std::string indented(const std::string& text) {
  std::string out;
  std::size_t begin = 0;
  while (begin < text.size()) {
    const std::size_t end = std::min(text.find('\n', begin), text.size() - 1);
    out += "  " + text.substr(begin, end - begin + 1);
    begin = end + 1;
  }
  return out;
}

int update(const std::vector<golden::CaseResult>& results) {
  int code = kFine;
  for (const golden::CaseResult& result : results) {
    if (result.expected_json.empty()) {
      fmt::print("wrong  {}\n{}", result.name, indented(result.report));
      code = kWrongInput;
      continue;
    }
    for (const auto& [name, text] : {std::pair("/expected.json", &result.expected_json),
                                     std::pair("/expected.trace", &result.expected_trace)}) {
      if (golden::read_if_there(result.name + name) == *text) continue;
      if (const auto failure = files::write_file(result.name + name, *text)) {
        fmt::print(stderr, "rubicon: error: {}\n", *failure);
        return kWrongInput;
      }
      fmt::print("wrote  {}{}\n", result.name, name);
    }
  }
  return code;
}

}  // namespace

int run_test(const TestOptions& options) {
  const std::vector<std::string> cases = selected_cases(options);
  if (cases.empty()) {
    fmt::print(stderr,
               "rubicon: error: no case found: no folder with a site.plan at or below '{}'{}\n",
               fmt::join(options.folders, "', '"),
               options.filter.empty() ? "" : fmt::format(" with '{}' in its path", options.filter));
    return kWrongInput;
  }
  std::set<std::string> inputs;
  for (const std::string& each : cases) {
    for (const char* name : {"/site.plan", "/expected.json", "/expected.trace"}) {
      inputs.insert(each + name);
    }
  }
  if (const auto mistake = overwriting(inputs, {options.junit})) {
    fmt::print(stderr, "rubicon: error: {}\n", *mistake);
    return kWrongInput;
  }
  const std::vector<golden::CaseResult> results = run_all(cases, options.jobs);
  if (options.update) return update(results);

  int failed = 0;
  bool wrong = false;
  for (const golden::CaseResult& result : results) {
    if (result.passed) continue;
    ++failed;
    wrong = wrong || result.wrong_input;
    fmt::print("FAILED  {}\n{}", result.name, indented(result.report));
  }
  fmt::print("{} passed, {} failed\n", static_cast<int>(results.size()) - failed, failed);
  if (!options.junit.empty()) {
    if (const auto failure = files::write_file(options.junit, golden::junit_xml(results))) {
      fmt::print(stderr, "rubicon: error: {}\n", *failure);
      return kWrongInput;
    }
  }
  return wrong ? kWrongInput : failed > 0 ? kInfeasible : kFine;
}

}  // namespace rubicon::cli
