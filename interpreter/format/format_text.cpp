#include <algorithm>

#include "interpreter/format/format_tokens.hpp"
#include "interpreter/parse/parse.hpp"

namespace rubicon::interpreter {

namespace {

constexpr std::size_t kColumns = 100;
constexpr std::size_t kIndent = 2;
/// Further indentation of a statement's second and later lines.
constexpr std::size_t kContinuation = 4;

std::size_t width_of(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xc0u) != 0x80u;
  }));
}

/// Prints tokens: a statement a line, what stands in braces on one line if it stood on one and
/// fits, else an element or statement a line. Never adds, drops or moves a token, so the meaning
/// stays.
class Printer {
 public:
  explicit Printer(std::vector<FormatToken> tokens) : tokens_(std::move(tokens)) { measure(); }

  std::string print() {
    print_block(0, tokens_.size(), 0, Block::statements);
    end_line();
    return std::move(out_);
  }

 private:
  enum class Block { statements, list, which };

  /// Where the matching braces are, how wide ranges are and whether they cross lines.
  void measure() {
    const std::size_t count = tokens_.size();
    match_.assign(count, count);
    width_.assign(count + 1, 0);
    breaks_.assign(count + 1, 0);
    depth_.assign(count + 1, 0);
    next_code_.assign(count + 1, count);
    std::vector<std::size_t> braces;
    std::vector<std::size_t> parentheses;
    const auto close = [this](std::vector<std::size_t>& open, std::size_t i) {
      if (open.empty()) return;
      match_[open.back()] = i;
      open.pop_back();
    };
    for (std::size_t i = 0; i < count; ++i) {
      const FormatToken& token = tokens_[i];
      if (token.is("{")) braces.push_back(i);
      if (token.is("(")) parentheses.push_back(i);
      if (token.is("}")) close(braces, i);
      if (token.is(")")) close(parentheses, i);
      width_[i + 1] = width_[i] + (token.space_before ? 1 : 0) + width_of(token.text);
      const int opens = token.is("(") || token.is("[") ? 1 : 0;
      const int closes = token.is(")") || token.is("]") ? 1 : 0;
      depth_[i + 1] = depth_[i] + opens - closes;
      breaks_[i + 1] =
          breaks_[i] + (token.first_on_line || token.multi_line || token.ends_line() ? 1 : 0);
    }
    for (std::size_t i = count; i-- > 0;)
      next_code_[i] = tokens_[i].is_comment() ? next_code_[i + 1] : i;
  }

  bool code_is(std::size_t i, std::string_view text) const {
    const std::size_t code = next_code_[std::min(i, tokens_.size())];
    return code < tokens_.size() && tokens_[code].is(text);
  }

  bool is_label(std::size_t i) const {
    return tokens_[i].is("default") || tokens_[i].is("when") ||
           (tokens_[i].kind == Token::Kind::name && code_is(i + 1, ":"));
  }

  void end_line() {
    if (!line_empty_) out_ += '\n';
    line_empty_ = true;
    column_ = 0;
  }

  void write(std::string_view text, std::size_t indent, bool space) {
    if (line_empty_) {
      out_.append(indent, ' ');
      column_ = indent;
    } else if (space) {
      out_ += ' ';
      ++column_;
    }
    out_ += text;
    column_ += width_of(text);
    line_empty_ = false;
  }

  /// How wide what stands between two commas is, from its first token, with the comma or semicolon
  /// behind it.
  std::size_t width_of_part(std::size_t i) const {
    int parentheses = 0;
    std::size_t end = i;
    for (; end + 1 < tokens_.size() && !tokens_[end + 1].is_comment(); ++end) {
      if (tokens_[end].is("(")) ++parentheses;
      if (tokens_[end].is(")")) --parentheses;
      if (parentheses == 0 && (tokens_[end].is(",") || tokens_[end].is(";"))) break;
    }
    return width_[end + 1] - width_[i] - (tokens_[i].space_before ? 1 : 0);
  }

  /// Whether a part of a list begins here that would not fit on this line, but on the next.
  bool begins_line(std::size_t i, std::size_t indent) const {
    // Inside of parentheses and brackets any blank will do.
    if (i == 0 || !tokens_[i - 1].is(",") || depth_[i] > 0) return false;
    const std::size_t width = width_of_part(i);
    return column_ + 1 + width > kColumns && indent + kContinuation + width <= kColumns;
  }

  /// A token inside a statement; goes to the next line where it would not fit and a blank allows
  /// it.
  void write_token(std::size_t i, std::size_t indent, bool at_start, bool may_wrap) {
    const FormatToken& token = tokens_[i];
    const bool separator_follows =
        i + 1 < tokens_.size() && (tokens_[i + 1].is(",") || tokens_[i + 1].is(";"));
    if (may_wrap && !line_empty_ && token.space_before &&
        (begins_line(i, indent) ||
         column_ + 1 + width_of(token.text) + (separator_follows ? 1 : 0) > kColumns)) {
      end_line();
    }
    write(token.text, at_start ? indent : indent + kContinuation, token.space_before);
  }

  void write_comment(std::size_t i, std::size_t indent) {
    const FormatToken& token = tokens_[i];
    if (token.first_on_line) end_line();
    if (!line_empty_ && token.ends_line()) out_ += ' ';
    write(token.text, indent, true);
    if (token.ends_line() || (i + 1 < tokens_.size() && tokens_[i + 1].first_on_line)) end_line();
  }

  /// Whether the braces at `i`, with what closes their statement, stay on this line.
  bool stays_on_line(std::size_t i) const {
    const std::size_t close = match_[i];
    if (breaks_[close + 1] != breaks_[i + 1]) return false;
    std::size_t end = close + 1;
    if (end < tokens_.size() && tokens_[end].is("until") && end + 1 < tokens_.size() &&
        match_[end + 1] < tokens_.size()) {
      end = match_[end + 1] + 1;
    }
    if (end < tokens_.size() && (tokens_[end].is(";") || tokens_[end].is(","))) ++end;
    return column_ + width_[end] - width_[i] <= kColumns;
  }

  /// Whether the simple statement at `i` stays on the line of the one before it.
  bool shares_line(std::size_t i, std::size_t end) const {
    if (is_label(i)) return false;
    for (std::size_t k = i; k < end && !breaks_at(k); ++k) {
      if (tokens_[k].is("{")) return false;
      if (tokens_[k].is(";")) return column_ + width_[k + 1] - width_[i] <= kColumns;
    }
    return false;
  }

  bool breaks_at(std::size_t i) const { return breaks_[i + 1] != breaks_[i]; }

  Block kind_of_block(std::size_t i) const {
    while (i > 0 && tokens_[i - 1].is_comment()) --i;
    if (i == 0) return Block::statements;
    const FormatToken& word = tokens_[i - 1];
    for (const char* loop : {"chain", "cycle", "first", "each", "together"}) {
      if (word.is(loop)) return Block::list;
    }
    return word.is("which") ? Block::which : Block::statements;
  }

  /// Tokens [i, end) of one block, each statement or element on a line of its own.
  void print_block(std::size_t i, std::size_t end, std::size_t indent, Block block) {
    const std::size_t outer = indent;
    bool at_start = true;   // of a statement or element
    bool line_due = false;  // a statement ended: the next token starts a line
    bool after_label = false;
    bool on_label_line = false;  // statements stay behind their label where they stood there
    bool in_until = false;
    bool first = true;  // no blank line behind '{'
    int parentheses = 0;
    for (; i < end; first = false) {
      const FormatToken& token = tokens_[i];
      const bool trails = token.is_comment() && !token.first_on_line && !line_empty_;
      on_label_line = on_label_line && !line_empty_;
      if (line_due && on_label_line && !token.is_comment() && shares_line(i, end)) line_due = false;
      if (line_due && !trails) {
        end_line();
        line_due = on_label_line = false;
      }
      if (at_start && !first && token.blank_lines > 0 && line_empty_) out_ += '\n';
      const std::size_t code = next_code_[i];
      const bool label = block == Block::which && at_start && code < end && is_label(code);
      if (at_start) indent = after_label && !label && line_empty_ ? outer + kIndent : outer;
      if (token.is_comment()) {
        write_comment(i, at_start ? indent : indent + kContinuation);
        ++i;
        continue;
      }
      if (label) {
        i = print_label(i, outer);
        after_label = true;
        on_label_line = i < end && !tokens_[i].first_on_line;
        line_due = !on_label_line;
        continue;
      }
      if (token.is("{")) {
        i = print_braces(i, indent, at_start);
        at_start = false;
        if (!code_is(i, ";") && !code_is(i, ",") && !code_is(i, "until"))
          at_start = line_due = true;
        continue;
      }
      if (token.is("until")) in_until = code_is(i + 1, "(");
      if (token.is("(")) ++parentheses;
      if (token.is(")")) --parentheses;
      write_token(i, indent, at_start, !at_start);
      at_start = false;
      ++i;
      const bool ends =
          token.is(";") || (block == Block::list && token.is(",") && parentheses == 0) ||
          (in_until && token.is(")") && parentheses == 0 && !code_is(i, ";") && !code_is(i, ","));
      if (ends) {
        at_start = line_due = true;
        in_until = false;
      }
    }
    end_line();
  }

  std::size_t print_label(std::size_t i, std::size_t indent) {
    int parentheses = 0;
    bool at_start = true;
    while (true) {
      const FormatToken& token = tokens_[i];
      if (token.is_comment()) {
        write_comment(i, indent + kContinuation);
      } else {
        if (token.is("(")) ++parentheses;
        if (token.is(")")) --parentheses;
        write_token(i, indent, at_start, true);
        at_start = false;
      }
      ++i;
      if (parentheses == 0 && token.is(":")) return i;
    }
  }

  std::size_t print_braces(std::size_t i, std::size_t indent, bool at_start) {
    const std::size_t close = match_[i];
    if (close == i + 1 || stays_on_line(i)) {
      for (; i <= close; ++i) write(tokens_[i].text, indent, tokens_[i].space_before);
      return i;
    }
    write("{", at_start ? indent : indent + kContinuation, true);
    const Block block = kind_of_block(i);
    ++i;
    // A remark behind '{' stays there.
    while (i < close && tokens_[i].is_comment() && !tokens_[i].first_on_line) {
      write_comment(i, indent + kIndent);
      ++i;
    }
    end_line();
    print_block(i, close, indent + kIndent, block);
    write("}", indent, false);
    return close + 1;
  }

  std::vector<FormatToken> tokens_;
  std::vector<std::size_t> match_;      ///< of '{' and '(': where it is closed
  std::vector<int> depth_;              ///< parentheses and brackets open before the token
  std::vector<std::size_t> width_;      ///< columns of the tokens before, on one line
  std::vector<std::size_t> breaks_;     ///< tokens before that start or hold a new line
  std::vector<std::size_t> next_code_;  ///< the token here or behind that is no comment
  std::string out_;
  std::size_t column_ = 0;
  bool line_empty_ = true;
};

bool parses(const SourceMap& sources, FileId file, TextKind kind) {
  Diagnostics diagnostics;
  switch (kind) {
    case TextKind::script:
      parse_script(sources, file, diagnostics);
      break;
    case TextKind::robot:
      parse_robot(sources, file, diagnostics);
      break;
    case TextKind::plan:
      parse_plan(sources, file, diagnostics);
      break;
    case TextKind::study:
      parse_study(sources, file, diagnostics);
      break;
  }
  return !diagnostics.has_errors();
}

}  // namespace

std::string format_text(std::string_view text, TextKind kind) {
  SourceMap sources;
  const FileId file = sources.add("", std::string(text));
  if (!parses(sources, file, kind)) return std::string(text);
  return Printer(format_tokens(sources.file(file).text, kind)).print();
}

}  // namespace rubicon::interpreter
