#include "src/results/page/report_page.hpp"

#include <cstddef>
#include <stdexcept>

#include "src/exchange/encoding/base64.hpp"
#include "src/exchange/encoding/gzip.hpp"

namespace rubicon::page {

namespace {

// A page has each of its own once (viewer/index.html, viewer/study.html).
constexpr std::string_view kTitle = "<title>RUBICON</title>";
constexpr std::string_view kFilm = R"(<script type="text/plain" id="film">)";
constexpr std::string_view kStudyTitle = "<title>RUBICON study</title>";
constexpr std::string_view kStudy = R"(<script type="application/json" id="study">)";
constexpr std::string_view kSlotEnd = "</script>";

/// Where the only `text` begins in `page`.
std::size_t only_place(std::string_view page, std::string_view text) {
  const std::size_t place = page.find(text);
  if (place == std::string_view::npos || page.find(text, place + 1) != std::string_view::npos) {
    throw std::logic_error("the page should have once: " + std::string(text));
  }
  return place;
}

std::string escaped(std::string_view text) {
  std::string result;
  for (const char letter : text) {
    switch (letter) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      default:
        result += letter;
    }
  }
  return result;
}

/// A line of the head that says what the page was made of; nothing where it is not known.
std::string mark(std::string_view name, std::string_view digest) {
  if (digest.empty()) return {};
  std::string line = "\n<meta name=\"";
  line.append(name).append("\" content=\"").append(digest).append("\">");
  return line;
}

/// A page with `head` behind its title, which names `name`, and `content` behind `slot`, which ends
/// its empty element. Throws std::logic_error if the page has no place for them.
std::string filled(std::string_view page, std::string_view title, std::string_view slot,
                   std::string_view name, std::string_view head, std::string_view content) {
  const std::size_t title_at = only_place(page, title);
  const std::size_t after_title = title_at + title.size();
  const std::size_t place =
      only_place(page, std::string(slot) + std::string(kSlotEnd)) + slot.size();
  if (place < after_title) throw std::logic_error("the page should begin with its title");
  std::string result;
  result.reserve(page.size() + name.size() + head.size() + content.size());
  result += page.substr(0, title_at);
  result += "<title>" + escaped(name) + " - RUBICON</title>";
  result += head;
  result += page.substr(after_title, place - after_title);
  result += content;
  result += page.substr(place);
  return result;
}

}  // namespace

std::string report_page(std::string_view viewer_page, const film::Film& film,
                        const PageOrigin& origin) {
  return filled(viewer_page, kTitle, kFilm, film.plan,
                mark("rubicon-trace", origin.trace) + mark("rubicon-schedule", origin.schedule),
                encoding::base64(encoding::gzip(film.bytes)));
}

std::string study_page(std::string_view empty_study_page, std::string_view json,
                       std::string_view name) {
  // No text of a plan can become markup.
  std::string safe;
  safe.reserve(json.size());
  for (const char letter : json) {
    if (letter == '<') {
      safe += "\\u003c";
    } else {
      safe += letter;
    }
  }
  return filled(empty_study_page, kStudyTitle, kStudy, name, {}, safe);
}

}  // namespace rubicon::page
