// config/toml_scan: the limits of a TOML text are checked before it is parsed.

#include "config/toml_scan.h"

#include <gtest/gtest.h>

#include <fstream>

#include "config/control/control_file.h"
#include "config/language.h"
#include "config/read_file.h"
#include "config/tools/toml_tools.h"

namespace kadr::toml_scan_test {
namespace {

std::string limit(std::string_view text) { return toml_limit_message(text, "a.toml"); }

std::string times(int n, std::string_view text) {
  std::string all;
  for (int i = 0; i < n; ++i) all += text;
  return all;
}

TEST(toml_scan, what_took_the_stack) {
  EXPECT_EQ(limit("x = 1\na" + times(49'999, ".a") + " = 1"), "a.toml:2:32: a key of more than 16 parts");
  EXPECT_EQ(limit("[a" + times(49'999, ".a") + "]"), "a.toml:1:33: a key of more than 16 parts");
  EXPECT_EQ(limit("[[a" + times(49'999, " . \"a\"") + "]]"), "a.toml:1:95: a key of more than 16 parts");
  EXPECT_EQ(limit("x = " + times(100'000, "[")), "a.toml:1:37: more than 32 brackets in brackets");
  EXPECT_EQ(limit("x = " + times(100'000, "[\n")), "a.toml:33:1: more than 32 brackets in brackets");
  EXPECT_EQ(limit("x = " + times(100'000, "{a=")), "a.toml:1:101: more than 32 brackets in brackets");
  EXPECT_EQ(limit("x = ['''a''''',\"\"\"b\"\"\"\"\"," + times(100, "[")).substr(0, 9), "a.toml:1:");
  EXPECT_EQ(limit("x = [" + times(200'000, "1,") + "]").substr(0, 7), "a.toml:");
}

TEST(toml_scan, brackets_and_points_in_texts_and_comments_do_not_count) {
  const std::string brackets = times(100, "["), points = times(100, ".");
  EXPECT_EQ(limit("# " + brackets + points + "\nx = \"" + brackets + "\\\"" + points + "\"\ny = '" + brackets + "\\'\n"), "");
  EXPECT_EQ(limit("x = \"\"\"\n" + brackets + "\"\" \\\"\"\"" + points + "\n\"\"\"\ny = '''" + brackets + "''" + points + "'''\n"), "");
  EXPECT_EQ(limit(times(1000, "[a.b]\nc.d = [[1.5, 2], {e = 1}] # x\n[[f]]\n")), "");
}

TEST(toml_scan, our_own_files_are_far_within) {
  for (const char* name : {"controls/nct.toml", "controls/nct-parameters.toml", "controls/mach3.toml", "controls/alarms.toml"})
    EXPECT_EQ(limit(read_file(std::string(KADR_ROOT) + "/" + name).value()), "") << name;
}

TEST(toml_parsed, faults_have_line_and_column) {
  const auto error_of = [](std::string_view text) { return toml_tools::parsed(text, "a.toml").error(); };
  EXPECT_TRUE(error_of("x = 1\ny = [1, \n z").starts_with("a.toml:3:2: Error while parsing ")) << error_of("x = 1\ny = [1, \n z");
  EXPECT_EQ(error_of("\xFF\xFEx"), "a.toml:1:1: the file is UTF-16; save it as UTF-8");
  EXPECT_EQ(error_of(std::string_view("x = 1\0", 6)), "a.toml:1:6: a NUL byte: this is no text");
  set_process_language(Lang::ru);
  EXPECT_EQ(error_of("x = 1\ny = [1, 2"), "a.toml:2:10: неверно записан список [ … ]");
  set_process_language(Lang::en);
  EXPECT_TRUE(toml_tools::parsed("\xEF\xBB\xBFx = 1\r\ny = 2\r\n", "a.toml"));
}

}  // namespace
}  // namespace kadr::toml_scan_test
