// A report contains the text of a program only as base64, at its marker in the viewer.

#include <gtest/gtest.h>

#include "view/report/page_report.h"

namespace kadr::report_test {
namespace {

constexpr const char* text = "(</script><img src=x onerror=alert(1)>)\nG21 G90 F600\nG0 X0 Y0 Z5\nG1 X20\nM2\n";

tl::expected<std::string, std::string> made(std::string_view viewer, const std::string& licences) {
  OpeningRequest request;
  request.path = "report_test.ngc";
  request.control = "linuxcnc";
  request.text = text;
  const auto opened = open_for_page(request);
  EXPECT_TRUE(opened) << opened.error();
  const auto run = ProgramRun::make(*opened, {});
  EXPECT_TRUE(run);
  (*run)->execute();
  const SourceText source(OpenedText{text_source(text), Encoding::utf8});
  return report_html(viewer, {**run, source, "<b>.ngc", "1", Lang::en, {}, {}, nullptr, nullptr, licences});
}

TEST(Report, StandsInItsPlace) {
  const auto html = made("<p>@KADR_REPORT_DATA@</p>", "");
  ASSERT_TRUE(html) << html.error();
  EXPECT_TRUE(html->starts_with("<p>"));
  EXPECT_TRUE(html->ends_with("</p>"));
  const std::string inside = html->substr(3, html->size() - 7);
  EXPECT_GT(inside.size(), 500U);
  EXPECT_EQ(inside.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/="), std::string::npos);
}

TEST(Report, WithoutAPlaceIsRefused) { EXPECT_FALSE(made("<p></p>", "")); }

TEST(Report, IsTheSameForTheSame) { EXPECT_EQ(*made("@KADR_REPORT_DATA@", "x"), *made("@KADR_REPORT_DATA@", "x")); }

}  // namespace
}  // namespace kadr::report_test
