#include "src/results/page/report_page.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "src/exchange/encoding/base64.hpp"
#include "tests/unit/film/film_decoder.hpp"

namespace rubicon::page {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr std::string_view kPage =
    "<html><head><title>RUBICON</title></head><body>\n"
    R"(<script type="text/plain" id="film"></script>)"
    "\n<script>play()</script></body></html>\n";

/// The inverse of base64.
std::string decoded(std::string_view text) {
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char letter : text) {
    const auto value =
        std::string_view("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/")
            .find(letter);
    if (value == std::string_view::npos) break;
    bits = bits << 6 | static_cast<std::uint32_t>(value);
    count += 6;
    if (count >= 8) bytes += static_cast<char>(bits >> (count -= 8) & 255);
  }
  return bytes;
}

TEST(ReportPage, HoldsTheFilm) {
  std::string bytes = "RUBICONF";
  for (int i = 0; i < 1000; ++i) bytes += static_cast<char>(i * 7);
  const std::string page = report_page(kPage, {"a plan", bytes}, {"0a1b", ""});
  EXPECT_THAT(page, HasSubstr("<title>a plan - RUBICON</title>"));
  EXPECT_THAT(page, HasSubstr("<meta name=\"rubicon-trace\" content=\"0a1b\">"));
  EXPECT_THAT(page, Not(HasSubstr("rubicon-schedule")));
  const std::string begin = R"(<script type="text/plain" id="film">)";
  const std::size_t from = page.find(begin) + begin.size();
  const std::string packed = page.substr(from, page.find("</script>", from) - from);
  EXPECT_EQ(test::unpacked(decoded(packed)), bytes);
  EXPECT_THAT(page, HasSubstr("<script>play()</script></body></html>\n"));
}

TEST(ReportPage, NoTextOfAPlanIsMarkup) {
  const std::string evil = "</script><!-- ]]> <script>alert(1)</script> <b>\"&'";
  const std::string page = report_page(kPage, {"</title>" + evil, "RUBICONF" + evil}, {});
  EXPECT_THAT(page, HasSubstr("<title>&lt;/title&gt;&lt;/script&gt;&lt;!-- ]]&gt; &lt;script&gt;"
                              "alert(1)&lt;/script&gt; &lt;b&gt;\"&amp;' - RUBICON</title>"));
  EXPECT_THAT(page, Not(HasSubstr("alert(1)</script>")));
  EXPECT_THAT(page, Not(HasSubstr("<!--")));
  EXPECT_THAT(page, Not(HasSubstr("]]>")));
  std::size_t scripts = 0;
  for (std::size_t at = page.find("</script"); at != std::string::npos;
       at = page.find("</script", at + 1))
    ++scripts;
  EXPECT_EQ(scripts, 2u);
}

TEST(ReportPage, APageWithoutAPlaceIsAFault) {
  EXPECT_THROW(report_page("<html></html>", {"p", ""}, {}), std::logic_error);
  EXPECT_THROW(report_page(std::string(kPage) + std::string(kPage), {"p", ""}, {}),
               std::logic_error);
}

TEST(ReportPage, TheBuiltPageHasItsPlaces) {
  if (viewer_page().empty()) GTEST_SKIP() << "this build has no page";
  EXPECT_THAT(report_page(viewer_page(), {"p", "RUBICONF"}, {}),
              HasSubstr("<title>p - RUBICON</title>"));
}

TEST(Base64, AsTheStandardSays) {
  EXPECT_EQ(encoding::base64(""), "");
  EXPECT_EQ(encoding::base64("f"), "Zg==");
  EXPECT_EQ(encoding::base64("fo"), "Zm8=");
  EXPECT_EQ(encoding::base64("foo"), "Zm9v");
  EXPECT_EQ(encoding::base64("foob"), "Zm9vYg==");
  EXPECT_EQ(encoding::base64("\xff\xfe\xfd"), "//79");
}

}  // namespace
}  // namespace rubicon::page
