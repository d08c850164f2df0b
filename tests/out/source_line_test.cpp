// out/text/source_line: what a terminal receives of texts from others.

#include "out/text/source_line.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <random>

namespace kadr::source_line_test {
namespace {

/// Looks at single bytes: ESC, BEL and other control characters; DEL; C1
/// as written in UTF-8, and a C1 byte that continues no UTF-8 character.
bool reaches_the_terminal(const std::string& text, bool lines) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if (lines && (byte == '\n' || byte == '\t')) continue;
    if (byte < 0x20 || byte == 0x7F) return true;
    if (byte == 0xC2 && i + 1 < text.size() && static_cast<unsigned char>(text[i + 1]) >= 0x80 &&
        static_cast<unsigned char>(text[i + 1]) < 0xA0)
      return true;
    if (byte >= 0x80 && byte < 0xA0 && (i == 0 || static_cast<unsigned char>(text[i - 1]) < 0x80)) return true;
  }
  return false;
}

RC_GTEST_PROP(SourceLine, ShowsEachControlCharacter, (const std::string& text)) {
  RC_ASSERT(!reaches_the_terminal(visible(text), true));
  RC_ASSERT(!reaches_the_terminal(visible_name(text), false));
  RC_ASSERT(!reaches_the_terminal(shortened_line(text, 50), false));
  RC_ASSERT(visible(visible(text)) == visible(text));
}

/// RapidCheck's own strings contain few bytes above 127.
TEST(SourceLine, ShowsEachControlCharacterAmongAllBytes) {
  std::mt19937 chance(1);
  const std::string likely("\x1b\x07\x9b\xc2\xe2\x80\xae\xd0\x90 a\n\x7f", 13);
  for (int i = 0; i < 100'000; ++i) {
    std::string text(1 + chance() % 12, '\0');
    for (char& c : text) c = chance() % 2 == 0 ? likely[chance() % likely.size()] : static_cast<char>(chance() % 256);
    ASSERT_FALSE(reaches_the_terminal(visible(text), true)) << testing::PrintToString(text);
    ASSERT_FALSE(reaches_the_terminal(visible_name(text), false)) << testing::PrintToString(text);
  }
}

TEST(SourceLine, LeavesTextAsItIs) {
  for (const std::string text : {"G1 X1 (деталь)\n", "a\tb", "→ ␛ 漢字 🙂", "", "\xC0\xF4\xF0\xE5\xE7\xE0"})
    EXPECT_EQ(visible(text), text);
}

TEST(SourceLine, ShowsPictures) {
  EXPECT_EQ(visible("a\x1b[31m\x07"), "a␛[31m␇");
  EXPECT_EQ(visible("a\xC2\x9B"
                    "b\x9B"),
            "a\xEF\xBF\xBD"
            "b\xEF\xBF\xBD");
  EXPECT_EQ(visible("a\u202Eb\u2069"), "a\uFFFDb\uFFFD");
  EXPECT_EQ(visible_name("a\nb\tc"), "a␊b␉c");
}

}  // namespace
}  // namespace kadr::source_line_test
