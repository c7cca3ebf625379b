#include "src/exchange/ifc/step_file.hpp"

#include <algorithm>
#include <optional>

#include "src/exchange/ifc/step_characters.hpp"
#include "src/exchange/ifc/step_values.hpp"

namespace rubicon::ifc {

namespace {

bool is_keyword(char c) { return (c >= 'A' && c <= 'Z') || is_digit(c) || c == '_' || c == '-'; }

/// What a message shows of a word of the file.
constexpr std::size_t kLongestShown = 40;

/// A word as a message may show it: printable, not long.
std::string shown(std::string_view word) {
  std::string result;
  for (const char c : word.substr(0, kLongestShown)) result += c > ' ' && c < 0x7f ? c : '?';
  return result;
}

}  // namespace

/// One pass over the text. An error ends it.
class StepReader {
 public:
  explicit StepReader(std::string_view text) : text_(text) {}

  std::variant<StepFile, StepError> read() {
    if (!read_sections()) return StepError{line_of(at_), message_};
    return std::move(file_);
  }

 private:
  bool fail(std::string message) {
    message_ = std::move(message);
    return false;
  }

  std::size_t line_of(std::size_t place) const {
    return 1 + static_cast<std::size_t>(std::count(
                   text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(place), '\n'));
  }

  bool at_end() const { return at_ >= text_.size(); }
  bool is(char c) const { return at_ < text_.size() && text_[at_] == c; }

  /// Passes over blanks and comments; false if a comment is not closed.
  bool skip() {
    while (at_ < text_.size()) {
      if (is_blank(text_[at_])) {
        ++at_;
      } else if (text_.compare(at_, 2, "/*") == 0) {
        const std::size_t end = text_.find("*/", at_ + 2);
        if (end == std::string_view::npos) return fail("a comment is not closed");
        at_ = end + 2;
      } else {
        break;
      }
    }
    return true;
  }

  bool expect(char c, const char* where) {
    if (!skip()) return false;
    if (!is(c)) {
      const std::string found = at_end() ? "the end of the file" : "'" + shown(rest(1)) + "'";
      return fail(std::string("expected '") + c + "' " + where + ", found " + found);
    }
    ++at_;
    return true;
  }

  std::string_view rest(std::size_t most) const { return text_.substr(at_, most); }

  std::string_view word() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && is_keyword(text_[at_])) ++at_;
    return text_.substr(begin, at_ - begin);
  }

  /// From `(` to its `)`, with strings and comments inside; empty with a message if that is not
  /// there.
  std::string_view brackets() {
    const std::size_t begin = at_;
    int depth = 0;
    do {
      if (at_end()) return fail_view("the file ends inside a record");
      const char c = text_[at_];
      if (c == '(') {
        if (++depth > kDeepestBrackets) return fail_view("brackets are nested too deep");
        ++at_;
      } else if (c == ')') {
        --depth;
        ++at_;
      } else if (c == '\'' || c == '"') {
        const std::size_t end = text_.find(c, at_ + 1);
        if (end == std::string_view::npos) return fail_view("a text is not closed");
        at_ = end + 1;
      } else if (c == ';') {
        return fail_view("a bracket is not closed before ';'");
      } else if (c == '/') {
        const std::size_t before = at_;
        if (!skip()) return {};
        if (at_ == before) return fail_view("unexpected '/'");
      } else {
        ++at_;
      }
    } while (depth > 0);
    return text_.substr(begin, at_ - begin);
  }

  std::string_view fail_view(const char* message) {
    fail(message);
    return {};
  }

  bool read_sections() {
    if (text_.substr(0, 3) == "\xEF\xBB\xBF") at_ = 3;
    if (!skip()) return false;
    if (word() != "ISO-10303-21") return fail("expected ISO-10303-21; at the beginning");
    if (!expect(';', "after ISO-10303-21")) return false;
    bool has_data = false;
    while (skip()) {
      const std::size_t begin = at_;
      const std::string_view section = word();
      if (section == "END-ISO-10303-21") {
        return has_data ? finish() : fail("the file has no DATA section");
      }
      if (section == "HEADER") {
        if (!expect(';', "after HEADER") || !read_header()) return false;
      } else if (section == "DATA") {
        has_data = true;
        if (!skip()) return false;
        if (is('(') && brackets().empty()) return false;
        if (!expect(';', "after DATA") || !read_data()) return false;
      } else {
        at_ = begin;
        if (at_end()) return fail("the file is cut off: END-ISO-10303-21; is missing");
        return fail("expected HEADER; or DATA; or END-ISO-10303-21; found '" +
                    shown(rest(kLongestShown)) + "'");
      }
    }
    return false;
  }

  bool read_header() {
    while (skip()) {
      if (at_end()) return fail("the file is cut off in its header");
      const std::string_view keyword = word();
      if (keyword == "ENDSEC") return expect(';', "after ENDSEC");
      if (keyword.empty()) return fail("expected an entry of the header");
      if (!skip()) return false;
      if (!is('(')) return expect('(', "in the header");
      const std::string_view arguments = brackets();
      if (arguments.empty() || !expect(';', "after an entry of the header")) return false;
      if (keyword == "FILE_SCHEMA") file_.schema_ = first_text(arguments);
    }
    return false;
  }

  /// Of FILE_SCHEMA(('IFC4')).
  static std::string first_text(std::string_view arguments) {
    const std::optional<StepValues> values = StepValues::read(arguments);
    if (!values) return {};
    const StepItem list = (*values)[0];
    return list.kind() == StepKind::list && list.size() > 0 ? list[0].decoded() : list.decoded();
  }

  bool read_data() {
    while (skip()) {
      if (at_end()) return fail("the file is cut off in its data");
      if (!is('#')) {
        if (word() == "ENDSEC") return expect(';', "after ENDSEC");
        return fail("expected a record such as #12= or ENDSEC;");
      }
      if (!read_record()) return false;
    }
    return false;
  }

  bool read_record() {
    const std::size_t begin = ++at_;
    while (at_ < text_.size() && is_digit(text_[at_])) ++at_;
    StepRecord record;
    const std::optional<std::uint64_t> id = whole_number(text_.substr(begin, at_ - begin));
    if (!id) return fail("expected the number of a record after '#'");
    record.id = *id;
    if (!expect('=', "after the number of a record") || !skip()) return false;
    if (is('!')) ++at_;  // a keyword of the user's own
    record.keyword = word();
    if (!skip()) return false;
    if (!is('(')) return expect('(', "after the keyword of a record");
    record.arguments = brackets();
    if (record.arguments.empty() || !expect(';', "after a record")) return false;
    file_.records_.push_back(record);
    return true;
  }

  bool finish() {
    auto& index = file_.by_id_;
    index.reserve(file_.records_.size());
    for (std::size_t i = 0; i < file_.records_.size(); ++i) {
      index.emplace_back(file_.records_[i].id, static_cast<std::uint32_t>(i));
    }
    std::sort(index.begin(), index.end());
    const auto twice =
        std::adjacent_find(index.begin(), index.end(),
                           [](const auto& a, const auto& b) { return a.first == b.first; });
    if (twice == index.end()) return true;
    at_ =
        static_cast<std::size_t>(file_.records_[(twice + 1)->second].keyword.data() - text_.data());
    return fail("there are two records with the number #" + std::to_string(twice->first));
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::string message_;
  StepFile file_;
};

std::variant<StepFile, StepError> StepFile::read(std::string_view text) {
  return StepReader(text).read();
}

const StepRecord* StepFile::find(std::uint64_t id) const {
  const auto found = std::lower_bound(
      by_id_.begin(), by_id_.end(), id,
      [](const auto& entry, std::uint64_t wanted) { return entry.first < wanted; });
  if (found == by_id_.end() || found->first != id) return nullptr;
  return &records_[found->second];
}

}  // namespace rubicon::ifc
