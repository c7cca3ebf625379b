#pragma once

#include <bitset>
#include <initializer_list>
#include <memory>
#include <string_view>

#include "src/simulation/trace/record_kind.hpp"

namespace rubicon::trace {

// Who looks into a header or a record includes header.hpp or record.hpp.
struct TraceHeader;
struct Record;
struct InText;
struct TaskStart;
struct GoalStart;
struct Assignment;
struct LoopStart;
struct LoopEnd;
struct Choice;
struct Attempt;
struct Wait;
struct Work;
struct Pause;
struct Attach;
struct Detach;
struct Removal;
struct MotionEnd;
struct TaskEnd;
struct Stop;
struct GuidePlan;
struct WayPoint;
struct Moving;
struct Breakdown;
struct LostDays;
struct Turn;
struct ColdJoint;
struct Soil;
struct Foreseen;
struct Forbidden;
struct Think;

/// Reads the first line of a trace. Throws std::invalid_argument, with a message for the user, for
/// what is none: another format, another version, a member that is missing, there twice or of the
/// wrong kind.
TraceHeader read_header(std::string_view line);

/// Some kinds of records.
class RecordKinds {
 public:
  RecordKinds(std::initializer_list<RecordKind> kinds) {
    for (const RecordKind kind : kinds) kinds_.set(static_cast<std::size_t>(kind));
  }
  static RecordKinds all() {
    RecordKinds kinds{};
    kinds.kinds_.set();
    return kinds;
  }
  bool contains(RecordKind kind) const { return kinds_.test(static_cast<std::size_t>(kind)); }

 private:
  std::bitset<kRecordTypes.size()> kinds_;
};

/// Reads the lines of a trace, one after the other, as typed values. Records of kinds that are not
/// wanted are passed over without a look at their members.
class TraceReader {
 public:
  explicit TraceReader(RecordKinds wanted = RecordKinds::all());
  TraceReader(TraceReader&&) noexcept;
  TraceReader& operator=(TraceReader&&) noexcept;
  ~TraceReader();

  /// Hands the first line to `on_header` (a TraceHeader&&) and each wanted record to `on_record` (a
  /// const Record&, valid during the call). Throws std::invalid_argument, with a message for the
  /// user, for what is no line of a trace: damaged text, an unknown type, a member that is missing,
  /// there twice or of the wrong kind, a header in the wrong place.
  template <typename OnHeader, typename OnRecord, typename Header = TraceHeader>
  void read(std::string_view line, OnHeader&& on_header, OnRecord&& on_record) {
    if (!has_header_) {
      // Through the parameter Header, so that TraceHeader may be incomplete until this is used.
      Header (*const as_header)(std::string_view) = read_header;
      on_header(as_header(line));
      has_header_ = true;
    } else if (const Record* record = read_record(line)) {
      on_record(*record);
    }
  }

  /// Whether a header was read, and taken without a throw.
  bool has_header() const { return has_header_; }

 private:
  /// Null for a record of a kind that is not wanted.
  const Record* read_record(std::string_view line);

  class Decoder;
  RecordKinds wanted_;
  bool has_header_ = false;
  std::unique_ptr<Decoder> decoder_;
};

}  // namespace rubicon::trace
