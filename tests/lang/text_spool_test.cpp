// lang/text/text_spool: a text that is built piece by piece is the same whether it stays in memory or not.

#include "lang/text/text_spool.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <vector>

namespace kadr::text_spool_test {
namespace {

/// Returns lines of 1 to 40 characters; some characters are two bytes long.
std::string some_text(std::size_t lines) {
  std::string text;
  for (std::size_t i = 0; i < lines; ++i) {
    for (std::size_t k = 0; k <= i * 7 % 40; ++k) text += k % 5 == 4 ? "Ж" : "X";
    text += '\n';
  }
  return text;
}

std::shared_ptr<ByteSource> spooled(const std::string& text, std::size_t in_memory) {
  TextSpool spool(in_memory);
  for (std::size_t at = 0; at < text.size(); at += 13) spool.append(std::string_view(text).substr(at, 13));
  EXPECT_EQ(spool.size(), text.size());
  return spool.source();
}

std::string part_of(ByteSource& source, std::uint64_t at, std::size_t size) {
  std::string part(size, '\0');
  part.resize(source.read(at, part.data(), size));
  return part;
}

// The text is in memory, partly in the file, or all in the file; it is read whole and from any position.
TEST(TextSpool, IsTheTextWhereverItStands) {
  const std::string text = some_text(3000);
  for (const std::size_t in_memory :
       {std::size_t{1}, std::size_t{1000}, text.size() - 1, text.size(), text.size() + 1, std::size_t{1} << 22}) {
    const auto source = spooled(text, in_memory);
    EXPECT_EQ(source->size(), text.size());
    EXPECT_EQ(whole_text(*source), text);
    for (const std::uint64_t at :
         {std::uint64_t{0}, std::uint64_t{999}, std::uint64_t{text.size() - 5}, std::uint64_t{text.size()}, std::uint64_t{text.size() + 9}})
      for (const std::size_t size : {std::size_t{1}, std::size_t{12}, std::size_t{5000}, text.size()})
        EXPECT_EQ(part_of(*source, at, size), at > text.size() ? "" : text.substr(at, size)) << in_memory << " " << at << " " << size;
  }
}

TEST(TextSpool, StaysInMemoryWhereNoFileCanBeMade) {
  const char* const before = std::getenv("TMPDIR");
  const std::string kept = before == nullptr ? "" : before;
  setenv("TMPDIR", "/dev/null", 1);
  const std::string text = some_text(500);
  EXPECT_EQ(whole_text(*spooled(text, 100)), text);
  if (before == nullptr) unsetenv("TMPDIR");
  else setenv("TMPDIR", kept.c_str(), 1);
}

std::vector<std::string> pieces_of(const std::string& text) {
  std::vector<std::string> pieces;
  EXPECT_TRUE(each_piece(*text_source(text), [&](std::string_view piece) {
    pieces.emplace_back(piece);
    return true;
  }));
  return pieces;
}

TEST(TextSpool, PiecesEndWithWholeLines) {
  const std::string text = some_text(60'000) + "the last one has no end";
  const std::vector<std::string> pieces = pieces_of(text);
  ASSERT_GT(pieces.size(), 3U);
  std::string all;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    all += pieces[i];
    EXPECT_TRUE(i + 1 == pieces.size() || pieces[i].ends_with('\n')) << i;
  }
  EXPECT_EQ(all, text);
  EXPECT_TRUE(pieces_of("").empty());
}

TEST(TextSpool, PiecesOfALongLineEndWithWholeCharacters) {
  std::string text = "X";
  while (text.size() < 1'000'000) text += "Ж";
  std::string all;
  for (const std::string& piece : pieces_of(text)) {
    EXPECT_NE(static_cast<unsigned char>(piece.front()) & 0xC0U, 0x80U);
    all += piece;
  }
  EXPECT_EQ(all, text);
}

TEST(TextSpool, PiecesEndWhereTheyAreNotWanted) {
  int taken = 0;
  EXPECT_FALSE(each_piece(*text_source(some_text(60'000)), [&](std::string_view) { return ++taken < 2; }));
  EXPECT_EQ(taken, 2);
}

}  // namespace
}  // namespace kadr::text_spool_test
