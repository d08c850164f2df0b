// control on the 2С42: a subprogram equals its body, a repetition equals its passes written out, and mirroring twice changes nothing.
// The medium does not matter: tape, code pages, ends of lines and blocks. Spec s2c42 1, 3, 6, 9.

#include <iconv.h>

#include "choices.h"
#include "control/run_program.h"
#include "lang/text/tape.h"

namespace kadr::forms_2c42_test {
namespace {

using namespace test;
using Blocks = std::vector<std::string>;

/// Lines and quarter arcs in increments, in micrometres; as drawn, or mirrored in X.
struct Contour {
  Blocks plain, mirrored;
};

Contour random_contour(Choices& choose) {
  static constexpr int quarters[][2] = {{1, 1}, {1, -1}, {-1, 1}, {-1, -1}};
  Contour c;
  const auto add = [&](const char* code, const char* opposed, int x, int y, const std::string& center, const std::string& mirrored_center) {
    const std::string y_word = " Y" + std::to_string(y);
    c.plain.push_back(std::string(code) + " X" + std::to_string(x) + y_word + center);
    c.mirrored.push_back(std::string(opposed) + " X" + std::to_string(-x) + y_word + mirrored_center);
  };
  for (std::size_t count = 1 + choose.below(8); count > 0; --count) {
    if (choose.below(2) == 0) {
      const char* const code = choose.below(2) == 0 ? "G91 G1" : "G91 G0";
      add(code, code, choose.between(-9000, 9000), choose.between(-9000, 9000), "", "");
      continue;
    }
    const auto& q = quarters[choose.below(4)];
    const int r = choose.between(100, 9000);
    const bool cw = (q[0] == q[1]) == (choose.below(2) == 0);
    const bool along_x = (q[0] == q[1]) != cw;  // the quarter leaves along X: its centre is offset in Y
    const auto center = [&](int sign) {
      return along_x ? " I0 J" + std::to_string(q[1] * r) : " I" + std::to_string(sign * q[0] * r) + " J0";
    };
    add(cw ? "G91 G2" : "G91 G3", cw ? "G91 G3" : "G91 G2", q[0] * r, q[1] * r, center(1), center(-1));
  }
  return c;
}

/// Returns the program with blocks numbered from N1, between '%' and M2.
std::string main_program(const Blocks& blocks, const std::string& mark = "", const std::string& end = "\n") {
  std::string text = "%" + mark + end;
  std::size_t number = 0;
  for (const std::string& block : blocks) text += "N" + std::to_string(++number) + " " + block + mark + end;
  return text + "N" + std::to_string(++number) + " M2" + mark + end;
}

Blocks joined(std::initializer_list<Blocks> parts) {
  Blocks all;
  for (const Blocks& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

std::vector<std::string> actions_of(const std::string& program, const kadr::Setup& setup = {}, std::optional<Encoding> encoding = {}) {
  const auto r = run("s2c42", program, setup, OnAlarm::stop, encoding);
  if (!r.alarms.empty()) RC_FAIL(program + r.first_alarm() + " in line " + std::to_string(r.alarms[0].origin.line));
  return exactly(r.actions);
}

const Blocks start = {"G90 G0 X1000 Y2000 F300"};

RC_GTEST_PROP(subprogram, is_its_body_written_out, ()) {
  Choices choose = choices(100);
  const Blocks body = random_contour(choose).plain;
  const int times = choose.between(1, 3);
  std::string section = "L\n";
  for (std::size_t i = 0; i < body.size(); ++i)
    section += "N0700" + std::to_string(i + 1) + " " + body[i] + (i + 1 == body.size() ? " M17\n" : "\n");
  Blocks written = start;
  for (int i = 0; i < times; ++i) written = joined({written, body});
  const std::string call = times == 1 ? "L07" : "L070" + std::to_string(times);
  const Blocks tail = {"G90 G1 X0"};
  RC_ASSERT(actions_of(section + "N07999 M2\n" + main_program(joined({start, {call}, tail}))) ==
            actions_of(main_program(joined({written, tail}))));
}

RC_GTEST_PROP(repetition, is_its_passes_written_out, ()) {
  Choices choose = choices(100);
  const Blocks body = random_contour(choose).plain;
  const int times = choose.between(1, 4);
  Blocks repeated = {start[0] + " H" + std::to_string(times)};
  repeated = joined({repeated, body});
  repeated.back() += " M20";
  Blocks written = start;
  for (int i = 0; i < times; ++i) written = joined({written, body});
  RC_ASSERT(actions_of(main_program(repeated)) == actions_of(main_program(written)));
}

RC_GTEST_PROP(mirror, of_the_mirrored_contour_is_the_contour, ()) {
  Choices choose = choices(100);
  const Contour contour = random_contour(choose);
  kadr::Setup mirrored;
  mirrored.mirror = {"X"};
  const auto plain = run("s2c42", main_program(contour.plain)).motions();
  const auto twice = run("s2c42", main_program(contour.mirrored), mirrored).motions();
  RC_ASSERT(plain.size() == contour.plain.size());
  RC_ASSERT(plain.size() == twice.size());
  for (std::size_t i = 0; i < plain.size(); ++i) {
    RC_ASSERT(plain[i].kind == twice[i].kind);
    RC_ASSERT(std::fabs(plain[i].turns - twice[i].turns) <= 1e-12);
    RC_ASSERT(plain[i].turns == 0 || std::fabs(plain[i].turns - 0.25) <= 1e-12);  // the path is the intended one
    RC_ASSERT(length(Vec3{plain[i].to[0] - twice[i].to[0], plain[i].to[1] - twice[i].to[1], 0}) <= 1e-9);
    RC_ASSERT(length(plain[i].center - twice[i].center) <= 1e-9);
  }
}

RC_GTEST_PROP(mirror, in_both_axes_keeps_the_direction_of_arcs, ()) {
  Choices choose = choices(100);
  const Contour contour = random_contour(choose);
  kadr::Setup both;
  both.mirror = {"X", "Y"};
  const auto plain = run("s2c42", main_program(contour.plain)).motions();
  const auto turned = run("s2c42", main_program(contour.plain), both).motions();
  RC_ASSERT(plain.size() == turned.size());
  for (std::size_t i = 0; i < plain.size(); ++i) {
    RC_ASSERT(plain[i].kind == turned[i].kind);
    RC_ASSERT(std::hypot(plain[i].to[0] + turned[i].to[0], plain[i].to[1] + turned[i].to[1]) <= 1e-9);
  }
}

// ---- media

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

RC_GTEST_PROP(carrier, does_not_matter, ()) {
  static constexpr const char* remarks[] = {"", " (ФРЕЗА)", " (СВЕРЛО 8)"};
  Choices choose = choices(100);
  Blocks blocks = joined({start, random_contour(choose).plain});
  for (std::string& block : blocks) block += choose.of(remarks);
  const auto expected = actions_of(main_program(blocks));
  for (const char* end : {"\n", "\r\n", "\r"}) {
    RC_ASSERT(actions_of(main_program(blocks, "", end)) == expected);
    RC_ASSERT(actions_of(main_program(blocks, " ПС", end)) == expected);
    RC_ASSERT(actions_of(main_program(blocks, " LF", end)) == expected);
  }
  RC_ASSERT(actions_of(main_program(blocks, " ПС ", "")) == expected);  // all blocks on one line
  RC_ASSERT(actions_of(main_program(blocks, " LF ", "")) == expected);
  const std::string marked = main_program(blocks, " ПС");
  RC_ASSERT(actions_of("\xEF\xBB\xBF" + marked) == expected);
  RC_ASSERT(actions_of(written(marked, "CP1251")) == expected);  // the encoding is guessed
  RC_ASSERT(actions_of(written(marked, "KOI8-R")) == expected);
  RC_ASSERT(actions_of(written(marked, "CP866")) == expected);
  RC_ASSERT(actions_of(encode_tape(main_program(blocks), 20).value()) == expected);
  RC_ASSERT(actions_of(encode_tape(main_program(blocks), 0).value(), {}, Encoding::iso7) == expected);
}

}  // namespace
}  // namespace kadr::forms_2c42_test
