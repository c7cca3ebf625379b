#include "src/results/report/diagnostic_printer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>

#include "src/results/palette/palette.hpp"

namespace rubicon::report {

namespace {

using interpreter::Diagnostic;
using interpreter::Position;
using interpreter::Severity;
using interpreter::SourceMap;
using interpreter::Span;

/// Longest excerpt of a source line, in bytes; longer lines are shown round the place.
constexpr std::size_t kMaxExcerpt = 160;

const char* level(Severity severity) {
  switch (severity) {
    case Severity::error:
      return "error";
    case Severity::warning:
      return "warning";
    case Severity::note:
      return "note";
  }
  return "";
}

std::string colour_of(Severity severity) {
  const palette::Terminal& colours = palette::kTerminal;
  const std::string_view code = severity == Severity::error     ? colours.bad
                                : severity == Severity::warning ? colours.warn
                                                                : colours.note;
  return fmt::format("\x1b[{}m", code);
}

/// Longest message, in bytes; a name of ten megabytes is cut in the middle.
constexpr std::size_t kMaxMessage = 1000;

bool continues(char byte) { return (static_cast<unsigned char>(byte) & 0xC0) == 0x80; }

/// Length of the well-formed UTF-8 sequence at `i`, 0 if there is none.
std::size_t sequence_length(std::string_view text, std::size_t i) {
  const auto byte = static_cast<unsigned char>(text[i]);
  const std::size_t length = byte < 0x80                   ? 1
                             : byte >= 0xF0 && byte < 0xF5 ? 4
                             : byte >= 0xE0                ? 3
                             : byte >= 0xC2                ? 2
                                                           : 0;
  if (length == 0 || byte >= 0xF5 || i + length > text.size()) return 0;
  for (std::size_t k = 1; k < length; ++k) {
    if (!continues(text[i + k])) return 0;
  }
  return length;
}

/// What a terminal may safely show: control characters (but tab) and broken UTF-8 become '?'.
std::string printable(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = sequence_length(text, i);
    const auto byte = static_cast<unsigned char>(text[i]);
    if (length == 0 || (byte < 0x20 && byte != '\t') || byte == 0x7f) {
      result += '?';
      i += 1;
    } else {
      result.append(text.substr(i, length));
      i += length;
    }
  }
  return result;
}

/// A message that fits: a long one keeps its beginning and its end.
std::string shortened_message(const std::string& text) {
  if (text.size() <= kMaxMessage) return printable(text);
  std::size_t head = kMaxMessage / 2;
  while (continues(text[head])) --head;
  std::size_t tail = text.size() - kMaxMessage / 2;
  while (continues(text[tail])) ++tail;
  return printable(text.substr(0, head)) + " ... " + printable(text.substr(tail));
}

/// The source line of a span and carets under it.
std::string excerpt(const SourceMap& sources, const Span& span, const char* colour,
                    const char* reset) {
  const Position position = sources.position(span);
  std::string_view line = sources.line(span.file, position.line);
  const std::uint32_t start =
      sources.file(span.file).line_starts[static_cast<std::size_t>(position.line - 1)];
  std::size_t at = std::min<std::size_t>(span.begin - start, line.size());
  std::size_t length =
      std::min<std::size_t>(std::max(span.end, span.begin + 1) - span.begin, line.size() - at);
  std::string left;
  std::string right;
  if (line.size() > kMaxExcerpt) {
    std::size_t from = at > kMaxExcerpt / 2 ? at - kMaxExcerpt / 2 : 0;
    while (from > 0 && continues(line[from])) --from;
    left = from > 0 ? "..." : "";
    right = from + kMaxExcerpt < line.size() ? "..." : "";
    line = line.substr(from, kMaxExcerpt);
    at -= from;
    length = std::min(length, line.size() - at);
  }
  std::string caret(left.size(), ' ');
  const std::string before = printable(line.substr(0, at));
  for (const char byte : before) {
    if (byte == '\t')
      caret += '\t';
    else if (!continues(byte))
      caret += ' ';
  }
  caret += '^';
  const std::string marked = printable(line.substr(at, length));
  const auto width =
      std::count_if(marked.begin(), marked.end(), [](char c) { return !continues(c); });
  if (width > 1) caret.append(static_cast<std::size_t>(width - 1), '~');
  return fmt::format("  {}{}{}\n  {}{}{}\n", left, printable(line), right, colour, caret, reset);
}

std::string place(const SourceMap& sources, const Span& span) {
  if (span.file == interpreter::kNoFile) return "rubicon: ";
  const Position position = sources.position(span);
  return fmt::format("{}:{}:{}: ", printable(sources.file(span.file).path), position.line,
                     position.column);
}

nlohmann::ordered_json lsp_position(const SourceMap& sources, const Span& span,
                                    std::uint32_t offset) {
  if (span.file == interpreter::kNoFile) return {{"line", 0}, {"character", 0}};
  const Position position = sources.position(span.file, offset);
  const std::uint32_t start =
      sources.file(span.file).line_starts[static_cast<std::size_t>(position.line - 1)];
  const std::string_view before =
      std::string_view(sources.file(span.file).text).substr(start, offset - start);
  int units = 0;
  for (const char byte : before) {
    if (!continues(byte)) units += static_cast<unsigned char>(byte) >= 0xF0 ? 2 : 1;
  }
  return {{"line", position.line - 1}, {"character", units}};
}

nlohmann::ordered_json lsp_range(const SourceMap& sources, const Span& span) {
  return {{"start", lsp_position(sources, span, span.begin)},
          {"end", lsp_position(sources, span, std::max(span.begin, span.end))}};
}

std::string uri(const SourceMap& sources, const Span& span) {
  return span.file == interpreter::kNoFile ? std::string()
                                           : printable(sources.file(span.file).path);
}

std::string full_message(const Diagnostic& diagnostic) {
  return diagnostic.hint.empty() ? diagnostic.message : diagnostic.message + "; " + diagnostic.hint;
}

}  // namespace

std::string print_text(const std::vector<Diagnostic>& diagnostics, const SourceMap& sources,
                       bool colour) {
  const char* bold = colour ? "\x1b[1m" : "";
  const char* reset = colour ? "\x1b[0m" : "";
  std::string text;
  int errors = 0;
  int warnings = 0;
  for (const Diagnostic& diagnostic : diagnostics) {
    errors += diagnostic.severity == Severity::error;
    warnings += diagnostic.severity == Severity::warning;
    const std::string tint = colour ? colour_of(diagnostic.severity) : "";
    text += fmt::format("{}{}{}{}{}: {}{}{}{}\n", bold, place(sources, diagnostic.span), reset,
                        tint, level(diagnostic.severity), reset, bold,
                        shortened_message(diagnostic.message), reset);
    if (diagnostic.span.file != interpreter::kNoFile) {
      text += excerpt(sources, diagnostic.span, tint.c_str(), reset);
    }
    for (const auto& related : diagnostic.notes) {
      text += fmt::format("  see {}{}\n", place(sources, related.span),
                          shortened_message(related.message));
    }
    if (!diagnostic.hint.empty())
      text += fmt::format("  hint: {}\n", shortened_message(diagnostic.hint));
  }
  if (errors + warnings > 0) {
    const auto counted = [](int count, const char* word) {
      return fmt::format("{} {}{}", count, word, count == 1 ? "" : "s");
    };
    text += errors > 0 && warnings > 0
                ? counted(errors, "error") + ", " + counted(warnings, "warning")
            : errors > 0 ? counted(errors, "error")
                         : counted(warnings, "warning");
    text += '\n';
  }
  return text;
}

std::string print_brief(const Diagnostic& diagnostic, const SourceMap& sources) {
  const Position position = sources.position(diagnostic.span);
  return fmt::format("{}:{}: {}: {}", position.line, position.column, level(diagnostic.severity),
                     diagnostic.message);
}

std::string print_json(const std::vector<Diagnostic>& diagnostics, const SourceMap& sources) {
  nlohmann::ordered_json files = nlohmann::ordered_json::array();
  for (const Diagnostic& diagnostic : diagnostics) {
    const std::string file = uri(sources, diagnostic.span);
    auto entry = std::find_if(files.begin(), files.end(),
                              [&](const auto& one) { return one.at("uri") == file; });
    if (entry == files.end()) {
      files.push_back({{"uri", file}, {"diagnostics", nlohmann::ordered_json::array()}});
      entry = files.end() - 1;
    }
    nlohmann::ordered_json object = {{"range", lsp_range(sources, diagnostic.span)},
                                     {"severity", static_cast<int>(diagnostic.severity) + 1},
                                     {"code", diagnostic.code},
                                     {"source", "rubicon"},
                                     {"message", shortened_message(full_message(diagnostic))}};
    if (!diagnostic.notes.empty()) {
      auto& related = object["relatedInformation"] = nlohmann::ordered_json::array();
      for (const auto& note : diagnostic.notes) {
        related.push_back(
            {{"location",
              {{"uri", uri(sources, note.span)}, {"range", lsp_range(sources, note.span)}}},
             {"message", shortened_message(note.message)}});
      }
    }
    (*entry)["diagnostics"].push_back(std::move(object));
  }
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const std::string file = printable(sources.file(static_cast<interpreter::FileId>(i)).path);
    const bool told = std::any_of(files.begin(), files.end(),
                                  [&](const auto& one) { return one.at("uri") == file; });
    if (!told) files.push_back({{"uri", file}, {"diagnostics", nlohmann::ordered_json::array()}});
  }
  return files.dump(2) + "\n";
}

}  // namespace rubicon::report
