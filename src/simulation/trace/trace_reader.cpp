#include "src/simulation/trace/trace_reader.hpp"

#include <fmt/format.h>
#include <simdjson.h>

#include <array>
#include <cstring>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>

#include "src/simulation/trace/header.hpp"
#include "src/simulation/trace/json_object_simdjson.hpp"
#include "src/simulation/trace/record_fields.hpp"
#include "src/simulation/trace/record_values_simdjson.hpp"

namespace rubicon::trace {

namespace {

[[noreturn]] void refuse(const std::string& why) {
  throw std::invalid_argument("this is no line of a trace: " + why);
}

/// Throws unless the line is a JSON object. What is wrong with a line is looked for once it could
/// not be read, and may take its time.
void expect_object(std::string_view line) {
  if (line.empty()) refuse("it is empty");
  simdjson::dom::parser parser;
  simdjson::dom::element root;
  const auto error = parser.parse(line.data(), line.size()).get(root);
  if (error != simdjson::SUCCESS) {
    const bool cut = line.starts_with('{') && !line.ends_with('}');
    refuse(fmt::format("{} ({}); run the plan again",
                       cut ? "it is cut off" : "expected JSON, found damaged text",
                       simdjson::error_message(error)));
  }
  if (!root.is_object()) {
    refuse(fmt::format("the line should be an object, found {}", shown(root)));
  }
}

[[noreturn]] void refuse_text(std::string_view line) {
  expect_object(line);
  refuse("it cannot be read");
}

[[noreturn]] void refuse_type(std::string_view line, std::string_view type) {
  expect_object(line);
  if (type == "header") refuse("a second header");
  refuse(fmt::format("there is no type '{}'; a later rubicon may know it", shown_text(type)));
}

[[noreturn]] void refuse_value(std::string_view line, std::string_view name, const char* expected) {
  expect_object(line);
  simdjson::dom::parser parser;
  const simdjson::dom::element root = parser.parse(line.data(), line.size());
  simdjson::dom::element found;
  if (root[name].get(found) != simdjson::SUCCESS) refuse_text(line);
  refuse(fmt::format("'{}' should be {}, found {}", name, expected, shown(found)));
}

/// What a line that begins as rubicon writes it says of its type; "" for other lines.
std::string_view first_type(std::string_view line) {
  constexpr std::string_view kBegin = R"({"type":")";
  if (!line.starts_with(kBegin)) return {};
  line.remove_prefix(kBegin.size());
  const std::size_t end = line.find_first_of("\"\\");
  return end == std::string_view::npos || line[end] == '\\' ? std::string_view()
                                                            : line.substr(0, end);
}

/// One member of a record: how it is called, and how it is read.
template <typename R>
struct Member {
  std::string_view name;
  bool required;
  void (*read)(RecordValues& values, RecordValues::Value& from, Record& record, R& into);
};

template <typename R, auto M>
constexpr Member<R> member_of(const Field<M>& field) {
  return {field.name, field.required,
          [](RecordValues& values, RecordValues::Value& from, Record&, R& into) {
            values.read(from, into.*M);
          }};
}

/// All members of a record as they are written: those that every record has come first.
template <typename R>
constexpr auto kMembers = std::apply(
    [](const auto&... fields) {
      using Value = RecordValues::Value;
      return std::array{Member<R>{"type", true, [](RecordValues&, Value&, Record&, R&) {}},
                        Member<R>{"task", true,
                                  [](RecordValues& values, Value& from, Record& record, R&) {
                                    values.read(from, record.task);
                                  }},
                        Member<R>{"robot", true,
                                  [](RecordValues& values, Value& from, Record& record, R&) {
                                    values.read(from, record.robot);
                                  }},
                        member_of<R>(fields)...};
    },
    RecordFields<R>::kFields);

/// The number of a member by its name; beyond the last for one that is not known. Members mostly
/// come in their order.
template <typename R>
std::size_t index_of(simdjson::ondemand::field& field, std::size_t next) {
  constexpr auto& members = kMembers<R>;
  const char* raw = field.key().raw();  // a quote ends it
  for (std::size_t i = 0; i < members.size(); ++i) {
    const std::size_t index = (next + i) % members.size();
    const std::string_view name = members[index].name;
    if (std::memcmp(raw, name.data(), name.size()) == 0 && raw[name.size()] == '"') return index;
  }
  std::string_view name;
  if (field.unescaped_key().get(name) != simdjson::SUCCESS) return members.size();
  std::size_t index = 0;
  while (index < members.size() && members[index].name != name) ++index;
  return index;
}

}  // namespace

/// Decodes the lines behind the header.
class TraceReader::Decoder {
 public:
  const Record* read(std::string_view line, const RecordKinds& wanted) {
    const std::string_view type = first_type(line);
    std::optional<RecordKind> kind = record_kind(type);
    if (kind && !wanted.contains(*kind)) {
      if (!line.ends_with('}')) refuse_text(line);
      return nullptr;
    }
    begin(line);
    if (!kind) {
      kind = find_kind(line);
      if (!wanted.contains(*kind)) return nullptr;
      begin(line);
    }
    values_.clear();
    decode(line, *kind, std::make_index_sequence<kRecordTypes.size()>());
    return &record_;
  }

 private:
  /// Looks at the line from its beginning.
  void begin(std::string_view line) {
    // The parser reads a little past the end.
    padded_.assign(line);
    padded_.append(simdjson::SIMDJSON_PADDING, ' ');
    const simdjson::padded_string_view text(padded_.data(), line.size(), padded_.size());
    if (parser_.iterate(text).get(document_) != simdjson::SUCCESS ||
        document_.get_object().get(object_) != simdjson::SUCCESS) {
      refuse_text(line);
    }
  }

  /// Of a line whose type does not come first.
  RecordKind find_kind(std::string_view line) {
    simdjson::ondemand::value found;
    const auto error = object_.find_field_unordered("type").get(found);
    if (error == simdjson::NO_SUCH_FIELD) {
      expect_object(line);
      refuse("it has no 'type'");
    }
    if (error != simdjson::SUCCESS) refuse_text(line);
    std::string_view type;
    if (found.get(type) != simdjson::SUCCESS) refuse_value(line, "type", "a text");
    const auto kind = record_kind(type);
    if (!kind) refuse_type(line, std::string(type));
    return *kind;
  }

  template <std::size_t... I>
  void decode(std::string_view line, RecordKind kind, std::index_sequence<I...>) {
    using Decode = void (Decoder::*)(std::string_view);
    constexpr std::array<Decode, sizeof...(I)> kDecoders = {
        &Decoder::decode_as<std::variant_alternative_t<I, Record::What>>...};
    (this->*kDecoders[static_cast<std::size_t>(kind)])(line);
  }

  template <typename R>
  void decode_as(std::string_view line) {
    constexpr auto& members = kMembers<R>;
    R& what = record_.what.emplace<R>();
    std::array<bool, members.size()> seen{};
    std::size_t next = 0;
    for (auto each : object_) {
      simdjson::ondemand::field field;
      if (std::move(each).get(field) != simdjson::SUCCESS) refuse_text(line);
      const std::size_t index = index_of<R>(field, next);
      if (index == members.size()) continue;  // what else a line tells is of no concern
      const Member<R>& member = members[index];
      if (std::exchange(seen[index], true)) {
        expect_object(line);
        refuse(fmt::format("it has two '{}'", member.name));
      }
      try {
        member.read(values_, field.value(), record_, what);
      } catch (const WrongValue& wrong) {
        refuse_value(line, member.name, wrong.expected);
      }
      next = index + 1;
    }
    if (document_.current_location().error() != simdjson::OUT_OF_BOUNDS) refuse_text(line);
    for (std::size_t i = 0; i < members.size(); ++i) {
      if (!members[i].required || seen[i]) continue;
      expect_object(line);
      refuse(fmt::format("it has no '{}', which every '{}' has", members[i].name,
                         kRecordTypes[record_.what.index()]));
    }
  }

  std::string padded_;  ///< the line, with what the parser wants behind it
  simdjson::ondemand::parser parser_;
  simdjson::ondemand::document document_;
  simdjson::ondemand::object object_;
  RecordValues values_;
  Record record_;
};

TraceReader::TraceReader(RecordKinds wanted)
    : wanted_(wanted), decoder_(std::make_unique<Decoder>()) {}
TraceReader::TraceReader(TraceReader&&) noexcept = default;
TraceReader& TraceReader::operator=(TraceReader&&) noexcept = default;
TraceReader::~TraceReader() = default;

const Record* TraceReader::read_record(std::string_view line) {
  return decoder_->read(line, wanted_);
}

}  // namespace rubicon::trace
