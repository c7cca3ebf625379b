#include "interpreter/syntax/diagnostic.hpp"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace rubicon::interpreter {

namespace {

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

/// Edits that still count as the same name misspelt: names of up to 4 letters are too alike for
/// two.
std::size_t allowed_edits(std::size_t letters) { return letters <= 1 ? 0 : letters <= 4 ? 1 : 2; }

/// Optimal string alignment distance (insert, delete, replace, transpose neighbours), case ignored;
/// `limit + 1` if it is more than `limit`.
std::size_t edit_distance(const std::string& a, const std::string& b, std::size_t limit) {
  const std::size_t rows = a.size();
  const std::size_t columns = b.size();
  if (rows > columns + limit || columns > rows + limit) return limit + 1;
  std::vector<std::size_t> before(columns + 1), previous(columns + 1), current(columns + 1);
  for (std::size_t j = 0; j <= columns; ++j) previous[j] = j;
  for (std::size_t i = 1; i <= rows; ++i) {
    current[0] = i;
    std::size_t best = i;
    for (std::size_t j = 1; j <= columns; ++j) {
      const std::size_t replace = previous[j - 1] + (lower(a[i - 1]) == lower(b[j - 1]) ? 0 : 1);
      current[j] = std::min({previous[j] + 1, current[j - 1] + 1, replace});
      if (i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) &&
          lower(a[i - 2]) == lower(b[j - 1])) {
        current[j] = std::min(current[j], before[j - 2] + 1);
      }
      best = std::min(best, current[j]);
    }
    if (best > limit) return limit + 1;
    std::swap(before, previous);
    std::swap(previous, current);
  }
  return previous[columns];
}

}  // namespace

void Diagnostics::error(std::string code, Span span, std::string message, std::string hint) {
  add({Severity::error, std::move(code), span, std::move(message), {}, std::move(hint)});
}

void Diagnostics::warning(std::string code, Span span, std::string message, std::string hint) {
  add({Severity::warning, std::move(code), span, std::move(message), {}, std::move(hint)});
}

void Diagnostics::note(std::string code, Span span, std::string message, std::string hint) {
  add({Severity::note, std::move(code), span, std::move(message), {}, std::move(hint)});
}

void Diagnostics::add(Diagnostic diagnostic) {
  if (diagnostic.severity == Severity::error) ++errors_;
  all_.push_back(std::move(diagnostic));
}

std::vector<Diagnostic> Diagnostics::sorted() const {
  std::vector<Diagnostic> result;
  std::set<std::tuple<FileId, std::uint32_t, std::string>> seen;
  for (const Diagnostic& diagnostic : all_) {
    if (seen.emplace(diagnostic.span.file, diagnostic.span.begin, diagnostic.message).second) {
      result.push_back(diagnostic);
    }
  }
  std::stable_sort(result.begin(), result.end(), [](const Diagnostic& a, const Diagnostic& b) {
    return std::tie(a.span.file, a.span.begin) < std::tie(b.span.file, b.span.begin);
  });
  return result;
}

void Diagnostics::name_copies(std::size_t from, const SourceMap& sources) {
  struct First {
    std::size_t index;
    std::size_t others = 0;
  };
  std::map<std::tuple<FileId, std::uint32_t, std::string>, First> firsts;
  std::size_t kept = from;
  for (std::size_t i = from; i < all_.size(); ++i) {
    Diagnostic& diagnostic = all_[i];
    if (diagnostic.span.copy != 0) {
      const auto [place, is_new] = firsts.emplace(
          std::tuple(diagnostic.span.file, diagnostic.span.begin, diagnostic.code), First{kept});
      if (!is_new) {
        ++place->second.others;
        if (diagnostic.severity == Severity::error) --errors_;
        continue;
      }
      const std::string suggestion = "; did you mean ";
      const std::size_t at =
          std::min(diagnostic.message.rfind(suggestion), diagnostic.message.size());
      diagnostic.message.insert(at, " (" + sources.copy_text(diagnostic.span) + ")");
    }
    if (kept != i) all_[kept] = std::move(diagnostic);
    ++kept;
  }
  all_.resize(kept);
  for (const auto& [place, first] : firsts) {
    if (first.others == 0) continue;
    all_[first.index].notes.push_back(
        {all_[first.index].span,
         "the same in " + std::to_string(first.others) + " more of its copies"});
  }
}

std::string did_you_mean(const std::string& name, const std::vector<std::string>& candidates) {
  std::string best;
  std::size_t nearest = allowed_edits(name.size()) + 1;
  for (const std::string& candidate : candidates) {
    if (candidate == name) continue;
    const std::size_t limit = std::min(allowed_edits(name.size()), allowed_edits(candidate.size()));
    const std::size_t distance = edit_distance(name, candidate, limit);
    if (distance <= limit && distance < nearest) {
      nearest = distance;
      best = candidate;
    }
  }
  return best;
}

}  // namespace rubicon::interpreter
