// lang/text/written_letters: replaces letters that an encoding cannot express; the bytes read back as the text.

#include "lang/text/written_letters.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "lang/text/tape.h"

namespace kadr::written_letters_test {
namespace {

WrittenLetters letters(std::string_view name) { return written_letters_named(name).value(); }
std::string written(std::string_view text, std::string_view name) { return transliterated(text, letters(name)).text; }

TEST(WrittenLetters, Names) {
  EXPECT_TRUE(letters("ascii").ascii);
  EXPECT_EQ(letters("Windows-1251").encoding, Encoding::cp1251);
  EXPECT_FALSE(written_letters_named("koi9"));
  EXPECT_FALSE(has_russian(letters("ascii")));
  EXPECT_FALSE(has_russian(letters("eia")));
  for (const char* const name : {"utf-8", "cp1251", "koi8-r", "cp866", "iso7"}) EXPECT_TRUE(has_russian(letters(name))) << name;
}

TEST(WrittenLetters, RussianInLatinLetters) {
  EXPECT_EQ(written("(ФРЕЗА Ø10 — щека, объём)", "ascii"), "(FREZA D10 - shheka, obyom)");
  EXPECT_EQ(transliterated("(ЩЕКА Ø10)", letters("ascii")).characters, 5U);
  EXPECT_EQ(written("G1 X10 (plain)", "ascii"), "G1 X10 (plain)");
  EXPECT_EQ(written("(日本語)", "ascii"), "(\?\?\?)");
  EXPECT_EQ(written("(Ёмкость)", "utf-8"), "(Ёмкость)");
}

TEST(WrittenLetters, WhatIsNearestComesFirst) {
  EXPECT_EQ(written("(Ё «Ъ» 5°)", "iso7"), "(Е \"Ь\" 5 deg)");
  EXPECT_EQ(written("(ёлка → №2)", "cp866"), "(ёлка -> №2)");
  EXPECT_EQ(written("(«пуск» …)", "cp1251"), "(«пуск» …)");
}

TEST(WrittenLetters, BrokenUtf8) {
  EXPECT_EQ(written("a\xff\xd0", "ascii"), "a\?\?");
  EXPECT_FALSE(bytes_of("a\xff", letters("cp1251")));
}

TEST(WrittenLetters, WhatABytesCodeHasNot) {
  const auto made = bytes_of("G1 (日)", letters("cp1251"));
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().id, AlarmId::bad_encoding);
  EXPECT_EQ(made.error().where, (Span{4, 7}));
  EXPECT_FALSE(bytes_of("G1 (A:5)", letters("eia"))) << "EIA has no :";
}

/// Generates texts of a few characters of each kind.
rc::Gen<std::string> texts() {
  return rc::gen::map(rc::gen::container<std::vector<std::string>>(rc::gen::element<std::string>(
                          "A", "z", "5", " ", "(", ")", ".", "Ж", "ъ", "Ё", "ё", "Я", "«", "°", "№", "日", "é")),
                      [](const std::vector<std::string>& parts) {
                        std::string text;
                        for (const std::string& part : parts) text += part;
                        return text;
                      });
}

RC_GTEST_PROP(WrittenLettersProperty, what_is_written_is_read_again, ()) {
  const std::string text = *texts();
  const WrittenLetters of = letters(*rc::gen::element("ascii", "utf-8", "cp1251", "koi8-r", "cp866"));
  const Transliterated made = transliterated(text, of);
  RC_ASSERT(transliterated(made.text, of).characters == 0U);
  const auto bytes = bytes_of(made.text, of);
  RC_ASSERT(bytes.has_value());
  std::string again;
  RC_ASSERT(append_utf8(*bytes, of.encoding, again).has_value());
  RC_ASSERT(again == made.text);
  if (is_written_so(text, of)) RC_ASSERT(made.text == text && *bytes == text);
}

RC_GTEST_PROP(WrittenLettersProperty, a_tape_too, ()) {
  const Transliterated made = transliterated(*texts(), letters("iso7"));
  const auto rows = bytes_of(made.text, letters("iso7"));
  RC_ASSERT(rows.has_value());
  std::string line = made.text + "\n";
  if (made.text.empty()) line.clear();
  RC_ASSERT(decode_tape(*rows).text == line);
}

}  // namespace
}  // namespace kadr::written_letters_test
