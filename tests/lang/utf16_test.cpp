// lang/text/utf16: recognises a UTF-16 text, and reads it as UTF-8 from any position.

#include "lang/text/utf16.h"

#include <gtest/gtest.h>

namespace kadr::utf16_test {
namespace {

std::string bytes_of(std::u16string_view text, ByteOrder order) {
  std::string bytes;
  for (const char16_t unit : text) {
    const char low = static_cast<char>(unit & 0xFF), high = static_cast<char>(unit >> 8);
    bytes += order == ByteOrder::little ? low : high;
    bytes += order == ByteOrder::little ? high : low;
  }
  return bytes;
}

std::string all_of(ByteSource& source, std::size_t piece) {
  std::string text, part(piece, '\0');
  for (;;) {
    const std::size_t got = source.read(text.size(), part.data(), part.size());
    if (got == 0) return text;
    text.append(part, 0, got);
  }
}

std::string read(std::string bytes, const GivenEncoding& given = {}) {
  const OpenedText text = as_text(text_source(std::move(bytes)), given);
  EXPECT_EQ(text.encoding, Encoding::utf8);
  return all_of(*text.source, 1000);
}

constexpr std::u16string_view program = u"N1 G01 X10 (Сверло № 5)\r\nN2 M30\r\n";
const std::string program_utf8 = "N1 G01 X10 (Сверло № 5)\r\nN2 M30\r\n";

TEST(utf16, is_known_by_its_mark) {
  EXPECT_EQ(look_at_utf16("\xFF\xFE"), ByteOrder::little);
  EXPECT_EQ(look_at_utf16("\xFE\xFF"), ByteOrder::big);
  EXPECT_EQ(read(bytes_of(u"\uFEFF", ByteOrder::little) + bytes_of(program, ByteOrder::little)), "\xEF\xBB\xBF" + program_utf8);
  EXPECT_EQ(read(bytes_of(u"\uFEFF", ByteOrder::big) + bytes_of(program, ByteOrder::big)), "\xEF\xBB\xBF" + program_utf8);
}

TEST(utf16, is_known_by_every_other_byte) {
  EXPECT_EQ(read(bytes_of(program, ByteOrder::little)), program_utf8);
  EXPECT_EQ(read(bytes_of(program, ByteOrder::big)), program_utf8);
}

TEST(utf16, other_texts_are_none) {
  const std::string texts[] = {"",
                               "N",
                               "N1 G90\n",
                               program_utf8,
                               std::string(200, '\0') + "\xB1\x8D\n",
                               std::string("N1\0\0G1", 6),
                               "\xCE\x31\x20\xC7\x39\x30",
                               std::string("\x7F\x45\x4C\x46\0\0\0\0\1\0\2\0", 12)};
  for (const std::string& text : texts) EXPECT_EQ(look_at_utf16(text), std::nullopt) << text;
}

TEST(utf16, what_is_said_holds_but_the_mark_is_in_the_file_itself) {
  GivenEncoding given;
  ASSERT_TRUE(read_encoding("UTF-16LE", given));
  EXPECT_EQ(read(bytes_of(u"€€", ByteOrder::little), given), "€€");  // not a program: only the declared encoding reveals it
  EXPECT_EQ(read(bytes_of(u"\uFEFF€", ByteOrder::big), given), "\xEF\xBB\xBF€");
  ASSERT_TRUE(read_encoding("utf-16", given));
  EXPECT_EQ(read(bytes_of(program, ByteOrder::big), given), program_utf8);
  EXPECT_EQ(read(bytes_of(u"€€", ByteOrder::little), given), "€€");
  EXPECT_FALSE(read_encoding("utf-17", given));
  ASSERT_TRUE(read_encoding("cp1251", given));
  const OpenedText text = as_text(text_source(bytes_of(program, ByteOrder::little)), given);
  EXPECT_EQ(text.encoding, Encoding::cp1251);
}

// U+1F600 is D83D DE00; lone surrogates and an odd byte at the end become U+FFFD.
TEST(utf16, pairs_and_what_is_damaged) {
  const auto text = [](std::u16string_view units, std::size_t cut = 0) {
    const std::string bytes = bytes_of(units, ByteOrder::big);
    std::string to;
    EXPECT_EQ(append_utf16(bytes.substr(0, bytes.size() - cut), ByteOrder::big, true, to), bytes.size() - cut);
    return to;
  };
  EXPECT_EQ(text(u"A\xD83D\xDE00Z"), "A😀Z");
  EXPECT_EQ(text(u"A\xD83DZ"), "A\uFFFDZ");
  EXPECT_EQ(text(u"A\xDE00Z"), "A\uFFFDZ");
  EXPECT_EQ(text(u"A\xD83D"), "A\uFFFD");
  EXPECT_EQ(text(u"\xD83D\xD83D\xDE00"), "\uFFFD😀");
  EXPECT_EQ(text(u"AZ", 1), "A\uFFFD");
}

TEST(utf16, a_character_that_is_cut_waits_for_the_next_piece) {
  std::string to;
  EXPECT_EQ(append_utf16(bytes_of(u"A\xD83D", ByteOrder::little), ByteOrder::little, false, to), 2u);
  EXPECT_EQ(append_utf16("\x41", ByteOrder::little, false, to), 0u);
  EXPECT_EQ(to, "A");
}

// The text is longer than several pieces of 32 KiB, with characters of
// one, two, three and four bytes; it is read from every kind of position.
TEST(utf16, any_place_is_read_as_from_the_beginning) {
  std::u16string units;
  for (int i = 0; i < 9000; ++i) units += i % 3 == 0 ? u"N1 X10\n" : i % 3 == 1 ? u"(Ж№)\n" : u"(\xD83D\xDE00)\n";
  const OpenedText text = as_text(text_source(bytes_of(u"\uFEFF" + units, ByteOrder::little)));
  const std::string whole = all_of(*text.source, std::size_t{1} << 20);
  ASSERT_EQ(whole.size(), text.source->size());
  EXPECT_EQ(all_of(*text.source, 777), whole);
  EXPECT_TRUE(whole.ends_with("(Ж№)\n(😀)\n"));
  std::string part(100, '\0');
  for (std::size_t at = 0; at < whole.size(); at += 331) {
    const std::size_t got = text.source->read(at, part.data(), part.size());
    ASSERT_EQ(part.substr(0, got), whole.substr(at, 100)) << at;
  }
  EXPECT_EQ(text.source->read(whole.size(), part.data(), part.size()), 0u);
}

}  // namespace
}  // namespace kadr::utf16_test
