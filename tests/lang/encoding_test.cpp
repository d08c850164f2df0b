// lang/text/encoding: finds the encoding of a text and converts its bytes to UTF-8. Spec s2c42 1.

#include "lang/text/encoding.h"

#include <gtest/gtest.h>
#include <iconv.h>

#include "lang/text/tape.h"

namespace kadr::encoding_test {
namespace {

/// Returns the bytes of the text in an encoding, converted by iconv.
std::string written(std::string text, const char* iconv_name) {
  std::string bytes(text.size(), '\0');
  const iconv_t converter = iconv_open(iconv_name, "UTF-8");
  char* from = text.data();
  char* to = bytes.data();
  std::size_t from_left = text.size();
  std::size_t to_left = bytes.size();
  EXPECT_EQ(iconv(converter, &from, &from_left, &to, &to_left), 0u) << text;
  iconv_close(converter);
  bytes.resize(bytes.size() - to_left);
  return bytes;
}

struct OneByte {
  Encoding encoding;
  const char* iconv_name;
};
constexpr OneByte one_byte[] = {{Encoding::cp1251, "CP1251"}, {Encoding::koi8r, "KOI8-R"}, {Encoding::cp866, "CP866"}};

std::string punched(std::string_view text) { return encode_tape(text, 0).value(); }

std::string read(std::string_view bytes, Encoding encoding) {
  std::string text;
  EXPECT_TRUE(append_utf8(bytes, encoding, text));
  return text;
}

void expect_detected(const std::string& text) {
  for (const auto& [encoding, iconv_name] : one_byte)
    EXPECT_EQ(detect_encoding(written(text, iconv_name)), encoding) << text << " in " << iconv_name;
  EXPECT_EQ(detect_encoding(text), Encoding::utf8) << text;
}

TEST(encoding_names, each_name_leads_back_to_its_encoding) {
  for (const Encoding e : {Encoding::utf8, Encoding::cp1251, Encoding::koi8r, Encoding::cp866, Encoding::iso7})
    EXPECT_EQ(encoding_named(name_of(e)), e);
}

TEST(encoding_names, case_and_hyphens_do_not_matter) {
  EXPECT_EQ(encoding_named("KOI8-R"), Encoding::koi8r);
  EXPECT_EQ(encoding_named("Windows-1251"), Encoding::cp1251);
  EXPECT_EQ(encoding_named("CP866"), Encoding::cp866);
  EXPECT_EQ(encoding_named("utf8"), Encoding::utf8);
  EXPECT_EQ(encoding_named("latin1"), std::nullopt);
}

TEST(append_utf8, russian_text_is_the_same_from_every_encoding) {
  const std::string text = "N10 G01 X100 (Сверло Ф8, ещё проход)";
  for (const auto& [encoding, iconv_name] : one_byte) EXPECT_EQ(read(written(text, iconv_name), encoding), text);
  EXPECT_EQ(read(text, Encoding::utf8), text);
}

TEST(append_utf8, appends_behind_what_is_there) {
  std::string text = "A";
  ASSERT_TRUE(append_utf8("B", Encoding::utf8, text));
  EXPECT_EQ(text, "AB");
}

TEST(append_utf8, byte_without_meaning_is_named_and_the_text_before_it_kept) {
  std::string text;
  const Status status = append_utf8("N10 \x98", Encoding::cp1251, text);  // CP1251 has no character 0x98
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().id, AlarmId::bad_encoding);
  EXPECT_EQ(status.error().where, (Span{4, 5}));
  EXPECT_EQ(text, "N10 ");
}

TEST(append_utf8, utf8_that_is_too_long_cut_or_a_surrogate_is_bad) {
  for (const char* bad : {"\xC0\x80", "\xE0\x80\x80", "\xD0", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\x80", "\xFF"}) {
    std::string text;
    EXPECT_FALSE(append_utf8(bad, Encoding::utf8, text));
  }
}

TEST(append_utf8, tape_loses_its_eighth_track) { EXPECT_EQ(read(punched("N1G1X8000"), Encoding::iso7), "N1G1X8000\n"); }

TEST(append_utf8, tape_row_of_odd_parity_is_named) {
  std::string text;
  const Status status = append_utf8("N1", Encoding::iso7, text);  // '1' is 0x31, three holes; 'N' is 0x4E, four holes
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().id, AlarmId::parity_error);
  EXPECT_EQ(status.error().args[0].number(), 2);
  EXPECT_EQ(status.error().where, (Span{1, 2}));
}

TEST(append_utf8, tape_leaves_out_nul_del_and_cr) {
  std::string rows("\0\xFF\x8D", 3);  // blank tape, all holes, CR with its parity
  EXPECT_EQ(read(rows + punched("N3") + rows, Encoding::iso7), "N3\n");
}

TEST(append_utf8, tape_switches_to_russian_letters_and_back) {
  // SO, С = KOI8-R 0xF3 without bit 8, SI; then a Latin s with the same code
  const std::string rows = {static_cast<char>(0x8E), static_cast<char>(with_even_parity(0x73)), 0x0F,
                            static_cast<char>(with_even_parity(0x73))};
  EXPECT_EQ(read(rows, Encoding::iso7), "Сs");
}

TEST(detect_encoding, ascii_fits_every_encoding) { EXPECT_EQ(detect_encoding("%\nN1 G0 X10 LF\n"), std::nullopt); }

TEST(detect_encoding, literal_end_of_block_is_enough) {
  expect_detected("% ПС\nN1 G0 X1000 ПС\n");
  expect_detected("ПС");
}

TEST(detect_encoding, one_word_is_enough) {
  for (const char* word : {"СВЕРЛО", "ФРЕЗА",  "РЕЗЬБА", "РЕЗЕЦ",  "КАРМАН", "КОНЕЦ",  "СТОП",   "ПОДХОД", "ОСЬ",    "ШАГ",   "УГОЛ",
                           "ДЕТАЛЬ", "сверло", "фреза",  "резьба", "конец",  "проход", "деталь", "ход",    "Сверло", "Фреза", "Подвод"})
    expect_detected("(" + std::string(word) + ")");
}

TEST(detect_encoding, sentence_in_small_letters_or_capitals) {
  expect_detected("(сверлить отверстия по контуру, ещё раз проверить)");
  expect_detected("(СВЕРЛИТЬ ОТВЕРСТИЯ ПО КОНТУРУ, ЕЩЁ РАЗ ПРОВЕРИТЬ)");
  expect_detected("(Фреза концевая Ф20, обороты 800)");
}

TEST(detect_encoding, number_sign_does_not_mislead) {
  EXPECT_EQ(detect_encoding(written("(ФРЕЗА №5)", "CP1251")), Encoding::cp1251);
  EXPECT_EQ(detect_encoding(written("(ФРЕЗА №5)", "CP866")), Encoding::cp866);
}

TEST(detect_encoding, utf8_sample_may_end_within_a_character) {
  std::string sample = "(СВЕРЛО)";
  for (const std::string end : {"\xD0", "\xE2", "\xE2\x84"}) EXPECT_EQ(detect_encoding(sample + end), Encoding::utf8);
}

TEST(detect_encoding, tape_image) {
  EXPECT_EQ(detect_encoding(encode_tape("%\nN1 G1 X8000\nN2 M2\n", 40).value()), Encoding::iso7);
  EXPECT_EQ(detect_encoding(encode_tape("%\nN1 G1 X8000 (СВЕРЛО)\nN2 M2\n", 40).value()), Encoding::iso7);
}

TEST(detect_encoding, tape_image_with_one_damaged_row_of_twenty) {
  std::string rows = punched("%\nN1 G1 X8000\nN2 G0 Z1000\nN3 M2\n");
  rows[5] = static_cast<char>(rows[5] ^ 0x10);
  EXPECT_EQ(detect_encoding(rows), Encoding::iso7);
}

TEST(look_alike, cyrillic_letters_that_look_latin) {
  EXPECT_EQ(look_alike(U'Х'), 'X');
  EXPECT_EQ(look_alike(U'с'), 'C');
  EXPECT_EQ(look_alike(U'Н'), 'H');
  EXPECT_EQ(look_alike(U'у'), 'Y');
  EXPECT_EQ(look_alike(U'І'), 'I');
  EXPECT_EQ(look_alike(U'Ј'), 'J');
  EXPECT_EQ(look_alike(U'Ѕ'), 'S');
}

TEST(look_alike, others_do_not) {
  for (const char32_t letter : {U'З', U'Ж', U'я', U'X', U'5', U'\0'}) EXPECT_EQ(look_alike(letter), 0);
}

TEST(first_character, code_and_size) {
  EXPECT_EQ(first_character("Ф8").code, U'Ф');
  EXPECT_EQ(first_character("Ф8").size, 2u);
  EXPECT_EQ(first_character("").size, 0u);
}

}  // namespace
}  // namespace kadr::encoding_test
