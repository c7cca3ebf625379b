#include "src/results/verify/schedule/check_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>

#include "src/exchange/encoding/gzip.hpp"
#include "src/exchange/encoding/sha256.hpp"
#include "src/results/verify/input/json_fields.hpp"

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

void report_fault(std::string text, Faults& faults) {
  Fault fault;
  fault.kind = FaultKind::report;
  fault.file = ResultFile::report;
  fault.text = std::move(text);
  faults.push_back(std::move(fault));
}

void expect(std::string_view found, std::string_view digest, const char* what, Faults& faults) {
  if (found == digest) return;
  report_fault(fmt::format("it was made of another {}, with SHA-256 {:.16}..., not {:.16}...", what,
                           found, digest),
               faults);
}

/// The text of the film in a page; "" if there is none.
std::string_view film_text(std::string_view report) {
  constexpr std::string_view kBegin = "<script type=\"text/plain\" id=\"film\">";
  const std::size_t at = report.find(kBegin);
  if (at == std::string_view::npos) return {};
  const std::string_view rest = report.substr(at + kBegin.size());
  return rest.substr(0, rest.find('<'));
}

/// Bytes of base64, appended; what is no digit of it is passed over.
class Base64Reader {
 public:
  Base64Reader() {
    values_.fill(-1);
    constexpr std::string_view kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (std::size_t i = 0; i < kDigits.size(); ++i) {
      values_[static_cast<unsigned char>(kDigits[i])] = static_cast<int>(i);
    }
  }

  void read(std::string_view text, std::string& bytes) {
    for (const char letter : text) {
      const int value = values_[static_cast<unsigned char>(letter)];
      if (value < 0) continue;
      bits_ = bits_ << 6 | static_cast<std::uint32_t>(value);
      count_ += 6;
      if (count_ < 8) continue;
      count_ -= 8;
      bytes += static_cast<char>(bits_ >> count_ & 0xff);
    }
  }

 private:
  std::array<int, 256> values_ = {};
  std::uint32_t bits_ = 0;
  int count_ = 0;
};

/// What the film tells in JSON: eight bytes, a version and the length of that text stand before it.
/// Nothing where it cannot be read.
std::optional<Json> film_head(std::string_view report) {
  constexpr std::size_t kBefore = 16, kPiece = 1 << 16;
  std::string bytes;
  std::size_t end = kBefore;
  const auto size = [&] {
    std::size_t sum = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      sum |= std::size_t{static_cast<unsigned char>(bytes[12 + i])} << (8 * i);
    }
    return sum;
  };
  try {
    encoding::GzipReader unpack([&](std::string_view piece) {
      if (bytes.size() < end) bytes += piece;
      if (bytes.size() >= kBefore) end = kBefore + size();
    });
    Base64Reader base64;
    std::string_view rest = film_text(report);
    while (!rest.empty() && bytes.size() < end) {
      std::string packed;
      base64.read(rest.substr(0, kPiece), packed);
      rest.remove_prefix(std::min(kPiece, rest.size()));
      unpack.read(packed);
    }
    if (bytes.size() < end) return std::nullopt;
    return parse_json(bytes.substr(kBefore, end - kBefore));
  } catch (const UnreadableInput&) {
    return std::nullopt;
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
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
  const std::optional<Json> film = film_head(report);
  if (!film || !film->is_object()) {
    report_fault("what it shows cannot be read", faults);
  } else if (!film->contains("schedule") || film->at("schedule") != parse_json(*schedule_json)) {
    report_fault("the schedule that it shows is not schedule.json", faults);
  }
}

}  // namespace rubicon::verify
