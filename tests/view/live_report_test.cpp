// A live report: the files of a program inside the page without a server.

#include "view/report/live_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kadr::live_report_test {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

constexpr std::string_view page = "<html><body><script id=\"kadr-engine-wasm\">AAAA</script>\n</body>\n</html>\n";

TEST(LiveReport, KnowsThePage) {
  EXPECT_TRUE(is_page_alone(page));
  EXPECT_FALSE(is_page_alone("<html><body></body></html>"));
  EXPECT_FALSE(is_page_alone("<script id=\"kadr-engine-wasm\">"));
  EXPECT_FALSE(is_page_alone(""));
}

TEST(LiveReport, FilesStandAtTheEndOfThePageAsBase64Only) {
  const auto html =
      live_report_html(page, {"part.nc", "fanuc", "", "part.json"}, {{"part.nc", "</script><img src=x>\xFF"}, {"part.json", "{}"}});
  ASSERT_TRUE(html.has_value()) << html.error();
  EXPECT_THAT(*html,
              StartsWith("<html><body><script id=\"kadr-engine-wasm\">AAAA</script>\n<script type=\"text/plain\" id=\"kadr-files\">"));
  EXPECT_THAT(*html, EndsWith("</script>\n</body>\n</html>\n"));
  EXPECT_THAT(*html, Not(HasSubstr("<img")));
  EXPECT_THAT(*html, Not(HasSubstr("part.nc")));
}

TEST(LiveReport, OtherFilesMakeAnotherPage) {
  const auto a = live_report_html(page, {"part.nc", "", "", ""}, {{"part.nc", "M30"}});
  const auto b = live_report_html(page, {"part.nc", "", "", ""}, {{"part.nc", "M02"}});
  ASSERT_TRUE(a && b);
  EXPECT_NE(*a, *b);
}

}  // namespace
}  // namespace kadr::live_report_test
