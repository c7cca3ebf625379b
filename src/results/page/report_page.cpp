#include "src/results/page/report_page.hpp"

#include <cstddef>
#include <stdexcept>

#include "src/exchange/encoding/base64.hpp"
#include "src/exchange/encoding/gzip.hpp"

namespace rubicon::page {

namespace {

// The page has each of them once (viewer/index.html).
constexpr std::string_view kTitle = "<title>RUBICON</title>";
constexpr std::string_view kFilmBegin = R"(<script type="text/plain" id="film">)";
constexpr std::string_view kFilmEnd = "</script>";

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

}  // namespace

std::string report_page(std::string_view viewer_page, const film::Film& film,
                        const PageOrigin& origin) {
  const std::string empty_film = std::string(kFilmBegin) + std::string(kFilmEnd);
  const std::size_t title = only_place(viewer_page, kTitle);
  const std::size_t place = only_place(viewer_page, empty_film) + kFilmBegin.size();
  const std::size_t after_title = title + kTitle.size();
  if (place < after_title) throw std::logic_error("the page should have its title before the film");
  const std::string packed = encoding::base64(encoding::gzip(film.bytes));

  std::string page;
  page.reserve(viewer_page.size() + packed.size() + film.plan.size());
  page += viewer_page.substr(0, title);
  page += "<title>" + escaped(film.plan) + " - RUBICON</title>";
  page += mark("rubicon-trace", origin.trace) + mark("rubicon-schedule", origin.schedule);
  page += viewer_page.substr(after_title, place - after_title);
  page += packed;
  page += viewer_page.substr(place);
  return page;
}

std::string study_page(std::string_view empty_study_page, std::string_view json,
                       std::string_view name) {
  constexpr std::string_view kStudyTitle = "<title>RUBICON study</title>";
  constexpr std::string_view kStudyBegin = R"(<script type="application/json" id="study">)";
  const std::size_t title = only_place(empty_study_page, kStudyTitle);
  const std::size_t place = only_place(empty_study_page, kStudyBegin) + kStudyBegin.size();
  const std::size_t after_title = title + kStudyTitle.size();
  if (place < after_title) {
    throw std::logic_error("the page should have its title before the study");
  }
  std::string page(empty_study_page.substr(0, title));
  page += "<title>" + escaped(name) + " - RUBICON</title>";
  page += empty_study_page.substr(after_title, place - after_title);
  for (const char letter : json) {
    // No text of a plan can become markup.
    if (letter == '<') {
      page += "\\u003c";
    } else {
      page += letter;
    }
  }
  page += empty_study_page.substr(place);
  return page;
}

}  // namespace rubicon::page
