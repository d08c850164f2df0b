// TextDocument against a slow twin that splits the whole text again after each change.

#include "lsp/text_document.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string>
#include <vector>

namespace kadr::text_document_test {

/// Splits a text at LF, CR LF and CR.
std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines(1);
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] == '\r' && at + 1 < text.size() && text[at + 1] == '\n') continue;
    if (text[at] == '\n' || text[at] == '\r') lines.emplace_back();
    else lines.back() += text[at];
  }
  return lines;
}

std::vector<std::string> lines_in(const TextDocument& document) {
  std::vector<std::string> lines;
  for (std::size_t n = 0; n < document.lines(); ++n) lines.emplace_back(document.line(n));
  return lines;
}

TEST(TextDocument, CountsColumnsInTheUnitOfTheEditor) {
  const std::string text = "N10 (Ж\xF0\x9F\x94\xA9) X1";  // a letter of two bytes, and a character of four bytes
  const std::size_t x = text.find('X');
  EXPECT_EQ(TextDocument(text, ColumnUnit::utf8).column_of(0, x), x);
  EXPECT_EQ(TextDocument(text, ColumnUnit::utf32).column_of(0, x), 9u);
  EXPECT_EQ(TextDocument(text, ColumnUnit::utf16).column_of(0, x), 10u);
  for (const ColumnUnit unit : {ColumnUnit::utf8, ColumnUnit::utf16, ColumnUnit::utf32}) {
    const TextDocument document(text, unit);
    EXPECT_EQ(document.byte_of({0, document.column_of(0, x)}), x);
  }
}

TEST(TextDocument, MovesPositionsOutsideOfTheTextToItsEdge) {
  TextDocument document("G0\nX1", ColumnUnit::utf16);
  EXPECT_EQ(document.byte_of({0, 99}), 2u);
  document.change({{7, 0}, {9, 9}}, "Y2");
  EXPECT_EQ(document.text(), "G0\nX1Y2");
}

// After any changes the lines are those of the whole text, and the changed lines are reported: all other lines are as they were.
RC_GTEST_PROP(TextDocument, KeepsItsLinesThroughChanges, ()) {
  const auto text = [] { return *rc::gen::container<std::string>(rc::gen::element('X', '1', ' ', '\n', '\r', '\xD0')); };
  TextDocument document(text(), ColumnUnit::utf8);
  for (int n = 0; n < 8; ++n) {
    const std::vector<std::string> before = lines_in(document);
    const auto position = [&] {
      return TextPosition{*rc::gen::inRange(0u, std::uint32_t(document.lines()) + 1), *rc::gen::inRange(0u, 9u)};
    };
    const TextPosition a = position(), b = position();
    const auto changed = document.change({std::min(a, b), std::max(a, b)}, text());
    RC_ASSERT(lines_in(document) == lines_of(document.text()));
    std::vector<std::string> wanted = before;
    const auto at = wanted.begin() + std::ptrdiff_t(changed.first);
    const auto kept = wanted.erase(at, at + std::ptrdiff_t(changed.removed));
    const std::vector<std::string> now = lines_in(document);
    wanted.insert(kept, now.begin() + std::ptrdiff_t(changed.first), now.begin() + std::ptrdiff_t(changed.first + changed.added));
    RC_ASSERT(wanted == now);
  }
}

}  // namespace kadr::text_document_test
