#include "src/results/verify/schedule/check_report.hpp"

#include <fmt/format.h>

#include <string>

#include "src/exchange/encoding/sha256.hpp"

namespace rubicon::verify {

namespace {

/// What the head of a report gives under a name; "" if nothing.
std::string_view mark(std::string_view report, std::string_view name) {
  const std::string begin = fmt::format("<meta name=\"{}\" content=\"", name);
  const std::size_t at = report.find(begin);
  if (at == std::string_view::npos) return {};
  const std::string_view rest = report.substr(at + begin.size());
  return rest.substr(0, rest.find('"'));
}

void expect(std::string_view found, std::string_view digest, const char* what, Faults& faults) {
  if (found == digest) return;
  Fault fault;
  fault.kind = FaultKind::report;
  fault.file = ResultFile::report;
  fault.text = fmt::format("it was made of another {}, with SHA-256 {:.16}..., not {:.16}...", what,
                           found, digest);
  faults.push_back(std::move(fault));
}

}  // namespace

bool says_its_origin(std::string_view report) { return !mark(report, "rubicon-trace").empty(); }

void check_report(std::string_view report, std::string_view trace_digest,
                  const std::optional<std::string>& schedule_json, Faults& faults) {
  if (!says_its_origin(report)) return;
  expect(mark(report, "rubicon-trace"), trace_digest, "trace", faults);
  // A report of a trace alone has no schedule.
  const std::string_view schedule = mark(report, "rubicon-schedule");
  if (schedule.empty() || !schedule_json) return;
  expect(schedule, encoding::sha256_hex(*schedule_json), "schedule.json", faults);
}

}  // namespace rubicon::verify
