#include "src/exchange/project_io/carried.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "interpreter/syntax/token.hpp"
#include "src/exchange/project_io/decode_text.hpp"

namespace rubicon::project_io {

namespace {

using interpreter::Token;

std::string unquoted(std::string_view text) {
  if (!text.empty() && text.front() == '"') text.remove_prefix(1);
  if (!text.empty() && text.back() == '"') text.remove_suffix(1);
  std::string result;
  while (!text.empty()) {
    const std::size_t mark = text.find('&');
    result += text.substr(0, mark);
    if (mark == std::string_view::npos) break;
    text.remove_prefix(mark);
    const std::size_t end = text.find(';');
    const std::string_view word = text.substr(0, end == std::string_view::npos ? 1 : end + 1);
    int code = 0;
    if (word == "&quot;") {
      result += '"';
    } else if (word == "&amp;") {
      result += '&';
    } else if (word.starts_with("&#") &&
               std::from_chars(word.data() + 2, word.data() + word.size() - 1, code).ec ==
                   std::errc() &&
               code > 0 && code < 128) {
      result += static_cast<char>(code);
    } else {
      result += word;
    }
    text.remove_prefix(word.size());
  }
  return clean_text(result);
}

void read_block(const interpreter::SourceMap& sources, interpreter::Span span,
                std::vector<CarriedRecord>& records) {
  const std::string& text = sources.file(span.file).text;
  const char* const end = text.data() + span.end;
  const char* at = text.data() + span.begin;
  // Other imports are of other things: `as schedule` is ours.
  Token before, token = interpreter::next_token(at, end);
  while (token.kind != Token::Kind::end && !token.is("{")) {
    before = token;
    token = interpreter::next_token(token.end, end);
  }
  if (token.kind == Token::Kind::end || !before.is("schedule")) return;
  at = token.end;
  CarriedRecord record;
  bool has_name = false;
  while (true) {
    token = interpreter::next_token(at, end);
    if (token.kind == Token::Kind::end || token.is("}")) return;
    at = token.end;
    const auto begin = static_cast<std::uint32_t>(token.begin - text.data());
    if (token.is(";")) {
      if (!record.keyword.empty()) records.push_back(std::move(record));
      record = {};
      has_name = false;
    } else if (record.keyword.empty()) {
      record.keyword = token.text();
      record.span = {span.file, begin, begin + static_cast<std::uint32_t>(token.text().size())};
    } else if (!has_name) {
      record.name = token.text();
      has_name = true;
    } else {
      const bool is_string = token.kind == Token::Kind::string;
      record.items.push_back(
          {is_string ? unquoted(token.text()) : std::string(token.text()), is_string});
    }
  }
}

}  // namespace

const std::string* CarriedRecord::value(std::string_view word) const {
  for (std::size_t i = 0; i + 1 < items.size(); i += 2) {
    if (!items[i].quoted && items[i].text == word) return &items[i + 1].text;
  }
  return nullptr;
}

std::vector<CarriedRecord> carried_records(const interpreter::PlanModel& plan,
                                           const interpreter::SourceMap& sources) {
  std::vector<CarriedRecord> records;
  for (const auto& use : plan.uses) {
    if ((use.what == "import" || use.what == "schedule") && use.span.file < sources.size()) {
      read_block(sources, use.span, records);
    }
  }
  return records;
}

std::string quoted(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"') {
      result += "&quot;";
    } else if (c == '&') {
      result += "&amp;";
    } else if (code < 0x20 || code == 0x7f) {
      result += fmt::format("&#{};", code);
    } else {
      result += c;
    }
  }
  return result + '"';
}

std::string CarriedWriter::changed(const CarriedWriter& usual) const {
  std::string result;
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    const Field& field = fields_[i];
    if (field.text == usual.fields_[i].text) continue;
    const bool bare = field.is_number && field.text.front() != '-';
    result += fmt::format(" {} {}", field.word, bare ? field.text : quoted(field.text));
  }
  return result;
}

}  // namespace rubicon::project_io
