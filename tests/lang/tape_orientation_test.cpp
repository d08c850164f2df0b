// lang/text/tape_orientation, lang/text/eia: finds the code of a tape and which way round it lies. RS-244: odd parity in track 5.

#include "lang/text/tape_orientation.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "lang/text/eia.h"

namespace kadr::tape_orientation_test {
namespace {

constexpr std::string_view program = "%\nN1 G90 G0 X8000 Y13000\nN2 G1 X5123 Y-9314 F500\nN3 M2\n";
constexpr TapeOrientation orientations[] = {TapeOrientation::right, TapeOrientation::wrong_end, TapeOrientation::wrong_side,
                                            TapeOrientation::both};

TEST(eia, codes_of_the_standard_have_odd_parity) {
  int codes = 0;
  for (int row = 0; row < 256; ++row) {
    const auto character = eia_character(static_cast<std::uint8_t>(row));
    if (!character) continue;
    ++codes;
    EXPECT_TRUE(has_odd_parity(static_cast<std::uint8_t>(row))) << row;
    if (*character == 0) continue;
    EXPECT_EQ(eia_row(static_cast<char32_t>(*character)), row);
  }
  // figures; letters; , . / + - &; blank and tab; the two ends; brackets; those without a character
  EXPECT_EQ(codes, 10 + 26 + 6 + 2 + 2 + 2 + 4);
}

TEST(eia, rows_by_hand) {
  // 3 has holes in tracks 1, 2 and the parity track 5; N in 1, 3, 7; X in 1, 2, 3, 5, 6
  EXPECT_EQ(eia_row(U'3'), 0b0001'0011);
  EXPECT_EQ(eia_row(U'N'), 0b0100'0101);
  EXPECT_EQ(eia_row(U'x'), 0b0011'0111);
  EXPECT_EQ(eia_row(U'\n'), 0b1000'0000);
  EXPECT_FALSE(eia_row(U':'));
  EXPECT_FALSE(eia_row(U'Ж'));
}

TEST(inspect_tape, every_code_and_every_lie) {
  for (const TapeCode code : {TapeCode::iso, TapeCode::eia})
    for (const TapeOrientation orientation : orientations) {
      const auto look = inspect_tape(turned(*encode_tape(program, 50, code), orientation));
      ASSERT_TRUE(look);
      EXPECT_EQ(look->code, code);
      EXPECT_EQ(look->orientation, orientation);
    }
}

TEST(inspect_tape, text_is_no_tape) {
  EXPECT_FALSE(inspect_tape(program));
  EXPECT_FALSE(inspect_tape("(СВЕРЛО 5 ММ, ФРЕЗА 12, ОТВЕРСТИЯ)"));
  EXPECT_FALSE(inspect_tape(""));
  EXPECT_FALSE(inspect_tape(std::string(100, '\0')));
}

RC_GTEST_PROP(turned, twice_is_nothing, (const std::string& rows)) {
  for (const TapeOrientation orientation : orientations) RC_ASSERT(turned(turned(rows, orientation), orientation) == rows);
}

RC_GTEST_PROP(decode_tape, eia_reads_what_it_wrote, ()) {
  const auto text = *rc::gen::container<std::string>(rc::gen::elementOf(std::string("%NGXYZ0123456789+-./( )\n"))) + "M2\n";
  RC_ASSERT(decode_tape(*encode_tape(text, 3, TapeCode::eia), TapeCode::eia).text == text || text.find(" \n") != std::string::npos);
}

}  // namespace
}  // namespace kadr::tape_orientation_test
