// config/json_scan: a text that is not JSON is refused with a message and the position of the fault.

#include "config/json_scan.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <nlohmann/json.hpp>

#include "config/language.h"
#include "config/setup/setup.h"

namespace kadr::json_scan_test {
namespace {

std::string fault(std::string_view text) { return json_fault_message(text, ""); }

TEST(json_scan, json) {
  for (const char* text :
       {"{}", " [1, -0.5, 1e3, 0, -0, 1E+2, 2.5e-3]\r\n", R"({"a": {"b": [true, false, null, "ж\n\"\\\/\u0416\uD834\uDD1E"]}})",
        "\xEF\xBB\xBF{}", "\"a\"", "1e-999", R"({"a": {"x": 1}, "b": {"x": 1}})"})
    EXPECT_EQ(fault(text), "") << text;
}

TEST(json_scan, faults_have_a_place) {
  struct Case {
    const char* text;
    const char* sentence;
  };
  const Case cases[] = {
      {"", "line 1, column 1: the text ends where a value must stand"},
      {"{\n  \"a\": 1,\n}", "line 3, column 1: a comma before '}'"},
      {"[1,]", "line 1, column 4: a comma before ']'"},
      {"{\"a\" 1}", "line 1, column 6: '1' where ':' behind a key must stand"},
      {"{\"a\": 1 \"b\": 2}", "line 1, column 9: '\"' where ',' or '}' must stand"},
      {"{a: 1}", "line 1, column 2: 'a' where a key in double quotes must stand"},
      {"{'a': 1}", "line 1, column 2: ''' where a key in double quotes must stand"},
      {"{\"a\": 'b'}", "line 1, column 7: a text stands in double quotes"},
      {"{\"a\": G54}", "line 1, column 7: 'G54' is no value: a text stands in double quotes"},
      {"{\"a\": NaN}", "line 1, column 7: 'NaN' is no number"},
      {"{\"a\": Infinity}", "line 1, column 7: 'Infinity' is no number"},
      {"{\"a\": -Infinity}", "line 1, column 7: '-Infinity' is no number: write 12, -0.5 or 1e3"},
      {"{\"a\": 1e999}", "line 1, column 7: 1e999 is too great for a number"},
      {"[01]", "line 1, column 2: '01' is no number: write 12, -0.5 or 1e3"},
      {"[+1]", "line 1, column 2: '+1' is no number: write 12, -0.5 or 1e3"},
      {"[.5]", "line 1, column 2: '.5' is no number: write 12, -0.5 or 1e3"},
      {"[1.]", "line 1, column 2: '1.' is no number: write 12, -0.5 or 1e3"},
      {"[0x10]", "line 1, column 2: '0x10' is no number: write 12, -0.5 or 1e3"},
      {"{\"X\": 1, \"Ж\": 2, \"X\": 3}", "line 1, column 18: the key 'X' stands twice in one table"},
      {"{\"X\": 1, \"\\u0058\": 3}", "line 1, column 10: the key 'X' stands twice in one table"},
      {"{} {}", "line 1, column 4: something stands after the end: '{'"},
      {"{\"a\": \"b", "line 1, column 7: a text without its closing quote"},
      {"{\"a\": \"b\n\"}", "line 1, column 9: a line end or control character within a text: \\n, \\t"},
      {"[\"\\x\"]", "line 1, column 3: an unknown \\ in a text; there are \\\" \\\\ \\/ \\b \\f \\n \\r \\t \\u0416"},
      {"[\"\\uDC00\"]", "line 1, column 3: an unknown \\ in a text; there are \\\" \\\\ \\/ \\b \\f \\n \\r \\t \\u0416"},
      {"[\"\xC3\"]", "line 1, column 3: bytes that are no UTF-8"},
      {"{} // shop", "line 1, column 4: something stands after the end: '/'"},
      {"{ // shop\n}", "line 1, column 3: JSON has no comments"},
      {"\xFF\xFE{\0", "line 1, column 1: the file is UTF-16; save it as UTF-8"},
  };
  for (const Case& c : cases) EXPECT_EQ(fault(c.text), c.sentence) << c.text;
}

TEST(json_scan, limits) {
  EXPECT_EQ(fault(std::string(32, '[') + std::string(32, ']')), "");
  EXPECT_EQ(fault(std::string(33, '[') + std::string(33, ']')), "line 1, column 33: more than 32 brackets in brackets");
  EXPECT_EQ(fault(std::string(10'000'000, '[')), "line 1, column 33: more than 32 brackets in brackets");
  std::string many = "[0";
  for (int i = 0; i < 500'000; ++i) many += ",0";
  EXPECT_EQ(fault(many + "]").substr(0, 60), "line 1, column 1000000: more than 500000 values");
}

TEST(json_scan, set_up) {
  EXPECT_EQ(parse_setup("{\"tool\": 1,\n\"tool\": 2}").error(), "line 2, column 1: the key 'tool' stands twice in one table");
  EXPECT_EQ(parse_setup("{\"start\": {\"X\": 1e999}}").error(), "line 1, column 17: 1e999 is too great for a number");
}

TEST(json_scan, russian) {
  set_process_language(Lang::ru);
  EXPECT_EQ(fault("[1,]"), "строка 1, позиция 4: запятая перед ']'");
  EXPECT_EQ(fault("{\"a\" 1}"), "строка 1, позиция 6: '1' вместо: ':' после ключа");
  EXPECT_EQ(fault("[NaN]"), "строка 1, позиция 2: «NaN» — не число");
  EXPECT_EQ(fault(std::string(33, '[')), "строка 1, позиция 33: скобки вложены более чем на 32 уровня");
  set_process_language(Lang::en);
}

/// Short texts of JSON's own characters get the same verdict as from the parser, except for duplicate keys.
RC_GTEST_PROP(json_scan, as_the_parser, ()) {
  const std::vector<std::string> pieces = {"{",  "}",  "[", "]",    ":",    ",", "\"a\"", "\"b\"", "1",       "-",
                                           ".5", "e1", "0", "true", "null", " ", "\\",    "\"",    "\\u00e9", "ж"};
  std::string text;
  for (const auto which : *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, static_cast<int>(pieces.size()))))
    text += pieces[static_cast<std::size_t>(which)];
  const bool parses = nlohmann::json::accept(text);
  const std::string fault_text = fault(text);
  if (parses && !fault_text.empty()) RC_ASSERT(fault_text.find("stands twice") != std::string::npos);
  if (!parses) RC_ASSERT(!fault_text.empty());
}

}  // namespace
}  // namespace kadr::json_scan_test
