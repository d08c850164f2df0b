// A run allocates no memory for each block: the program is read, interpreted and passed on in memory that earlier blocks have left. The
// programs are those of bench/compare_rs274 in small. A long program and a short one of the same kind need the same number of allocations;
// the table names the programs that still need more for each block, and these numbers may only fall.

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <memory>
#include <new>
#include <string>

#include "config/control/control_file.h"
#include "session/session.h"

namespace {

std::atomic<std::uint64_t> allocated{0};

void* counted_block(std::size_t size) {
  allocated.fetch_add(1, std::memory_order_relaxed);
  if (void* const block = std::malloc(size == 0 ? 1 : size)) return block;  // NOLINT(cppcoreguidelines-no-malloc)
  throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t size) { return counted_block(size); }
void* operator new[](std::size_t size) { return counted_block(size); }
void operator delete(void* block) noexcept { std::free(block); }                 // NOLINT(cppcoreguidelines-no-malloc)
void operator delete[](void* block) noexcept { std::free(block); }               // NOLINT(cppcoreguidelines-no-malloc)
void operator delete(void* block, std::size_t) noexcept { std::free(block); }    // NOLINT(cppcoreguidelines-no-malloc)
void operator delete[](void* block, std::size_t) noexcept { std::free(block); }  // NOLINT(cppcoreguidelines-no-malloc)

namespace kadr::allocations_test {
namespace {

std::string coordinate(char letter, double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%c%.3f", letter, value);
  return text.data();
}

/// Returns `count` lines, each from `line(i)`, between the first and the last lines of a program.
template <class Line>
std::string program_of(int count, const std::string& first, Line&& line, const std::string& last = "M30\n") {
  std::string text = first;
  for (int i = 0; i < count; ++i) text += line(i) + "\n";
  return text + last;
}

std::string lines_after(int count, const std::string& first) {
  return program_of(count, first + "G01 X0 Y0 Z0 F3000\n",
                    [](int i) { return coordinate('X', i % 1000 * 0.1) + coordinate('Z', i % 7 * 0.3); });
}
std::string surface(int count) { return lines_after(count, "G21 G90 G17\n"); }
std::string whole_numbers(int count) {
  return program_of(count, "%\nG90 G17\nG01 X0 Y0 Z0 F3000\n",
                    [](int i) { return "X" + std::to_string(i % 100) + "Z" + std::to_string(i % 7); });
}
std::string long_lines(int count) {
  return program_of(count, "G21 G90 G17\nG1 X0 Y0 Z0 F3000\n", [](int i) {
    return "N" + std::to_string(i + 1) + " G1 " + coordinate('X', i % 1000 * 0.1) + coordinate('Y', i * 0.001) + " F" +
           std::to_string(1000 + i % 3);
  });
}
std::string five_axes(int count) {
  return program_of(count, "G21 G90 G17\nG1 F3000\n", [](int i) {
    return coordinate('X', i * 0.1) + coordinate('Y', 1) + coordinate('Z', -1) + coordinate('A', i % 20) + coordinate('B', i % 15);
  });
}
std::string arcs(int count) {
  return program_of(count, "G21 G90 G17\nG0 X0 Y0 Z0\nG1 Z-1 F1500\n", [](int i) {
    const int x = i + 1;
    switch (i / 50 % 4) {
      case 0: return "G17 G" + std::to_string(2 + i % 2) + coordinate('X', x) + " Y0 I0.5 J0";
      case 1: return "G17 G" + std::to_string(2 + i % 2) + coordinate('X', x) + " Y0 R0.75";
      case 2: return "G17 G" + std::to_string(2 + i % 2) + coordinate('X', x) + " Y0" + coordinate('Z', -i % 10) + " I0.5 J0";
      default: return "G1" + coordinate('X', x) + " Y0";
    }
  });
}
std::string holes(int count) {
  return program_of(count, "G21 G90 G17\nM3 S500\nG0 X0 Y0 Z10\n", [](int i) {
    static const char* const cycles[] = {"G81 Z-5 R2 F300 ", "G82 Z-5 R2 P1 F300 ", "G83 Z-9 R2 Q3 F300 ", "G73 Z-9 R2 Q3 F300 "};
    return (i % 100 == 0 ? cycles[i / 100 % 4] : "") + coordinate('X', i % 100 * 3);
  });
}
std::string contour(int count, const std::string& on) {
  return program_of(count, "G21 G90 G17\nG0 X0 Y-30 Z5\nG1 Z-1 F800\n" + on + " G1 X10 Y-10 F2000\nG1 X20 Y0\n", [](int i) {
    const double at = i / 4 * 26;
    switch (i % 4) {
      case 0: return "G1" + coordinate('X', at + 30);
      case 1: return "G3" + coordinate('X', at + 38) + coordinate('Y', at + 8) + " I0 J8";
      case 2: return "G1" + coordinate('Y', at + 18);
      default: return "G2" + coordinate('X', at + 46) + coordinate('Y', at + 26) + " I8 J0";
    }
  });
}
std::string fanuc_loop(int count, const std::string& body) {
  return "%\nO0001\nG21 G90\nG1 F1000\n#1=0\n#2=0\nWHILE [#1 LT " + std::to_string(count) + "] DO1\n" + body + "#1=#1+1\nEND1\nM30\n%\n";
}
std::string fanuc_calls(int count) {
  return "%\nO0003\nG21 G90\n#100=0\nWHILE [#100 LT " + std::to_string(count) +
         "] DO1\nG65 P9010 A[#100 MOD 100] B[#100 MOD 37] C-1\n#100=#100+1\nEND1\nM30\n"
         "O9010\nG1 X#1 Y#2 Z[#3-#1*0.001] F1000\nM99\n%\n";
}
std::string o_word_loop(int count, const std::string& body) {
  return "G21 G90\nF1000\n#1=0\n#2=0\no100 while [#1 lt " + std::to_string(count) + "]\n" + body + "#1=[#1+1]\no100 endwhile\nM2\n";
}
std::string o_word_calls(int count) {
  return "G21 G90\nF1000\no10 sub\nG1 X#1 Y#2 Z[#3-#1*0.001]\no10 endsub\n#50=0\no100 while [#50 lt " + std::to_string(count) +
         "]\n"
         "o10 call [#50 mod 100] [#50 mod 37] [-1]\n#50=[#50+1]\no100 endwhile\nM2\n";
}
std::string named_loop(int count, const std::string& body) {
  return "G90 F1000\nR1=0 R2=0\nWHILE R1<" + std::to_string(count) + "\n" + body + "R1=R1+1\nENDWHILE\nM30\n";
}
std::string named_calls(int count) {
  return "%_N_SUBS_MPF\nG90 F1000\nR50=0\nWHILE R50<" + std::to_string(count) +
         "\nPOINT(R50 MOD 100,R50 MOD 37,-1)\nR50=R50+1\nENDWHILE\nM30\n"
         "%_N_POINT_SPF\nPROC POINT(REAL XP,REAL YP,REAL ZP)\nG1 X=XP Y=YP Z=ZP-XP*0.001\nM17\n";
}
std::string klartext(int count, const std::string& body, const std::string& end = "") {
  return "BEGIN PGM P MM\nL F1000\nLBL 2\nLBL 1\n" + body + "Q1 = Q1 + 1\nCALL LBL 1 REP 999\nCALL LBL 2 REP " +
         std::to_string(count / 1000 - 1) + "\n" + end + "END PGM P MM\n";
}
std::string klartext_lines(int count) {
  return program_of(
      count, "BEGIN PGM P MM\nL X+0 Y+0 R0 F1000\n", [](int i) { return "L X+" + std::to_string(i) + ".5 Y-2"; }, "END PGM P MM\n");
}

struct Case {
  const char* control;
  const char* name;
  std::function<std::string(int)> program;  // a program of so many lines, or with a loop of so many passes
  double most = 0;                          // allocations for each 1,000 blocks
};

// clang-format off
const Case cases[] = {
    {"linuxcnc", "lines", surface, 0},
    {"linuxcnc", "long_lines", long_lines, 0},
    {"linuxcnc", "five_axes", five_axes, 0},
    {"linuxcnc", "arcs", arcs, 0},
    {"linuxcnc", "holes", holes, 0},
    {"linuxcnc", "contour", [](int n) { return contour(n, "G41.1 D10"); }, 0},
    {"linuxcnc", "loop", [](int n) { return o_word_loop(n, "#2=[#2+sin[#1*0.36]*cos[#1]-[#1 mod 7]/3]\n"); }, 0},
    {"linuxcnc", "moving_loop", [](int n) { return o_word_loop(n, "G1 X[50*cos[#1*0.36]] Y[50*sin[#1*0.36]] Z[-#1*0.00001]\n"); }, 0},
    {"linuxcnc", "calls", o_word_calls, 0},
    {"mach3", "lines", surface, 0},
    {"mach3", "long_lines", long_lines, 0},
    {"mach3", "five_axes", five_axes, 0},
    {"mach3", "arcs", arcs, 0},
    {"mach3", "holes", holes, 0},
    {"mach3", "contour", [](int n) { return contour(n, "G41 P5"); }, 0},
    {"nct", "lines", surface, 0},
    {"nct", "long_lines", long_lines, 0},
    {"nct", "arcs", arcs, 0},
    {"nct", "holes", holes, 0},
    {"nct", "contour", [](int n) { return contour(n, "G41 D1"); }, 0},
    {"nct", "loop", [](int n) { return fanuc_loop(n, "#2=#2+SIN[#1*0.36]*COS[#1]-[#1 MOD 7]/3\n"); }, 0},
    {"nct", "moving_loop", [](int n) { return fanuc_loop(n, "G1 X[50*COS[#1*0.36]] Y[50*SIN[#1*0.36]] Z[-#1*0.00001]\n"); }, 0},
    {"nct", "calls", fanuc_calls, 0},
    {"fanuc", "lines", surface, 0},
    {"fanuc", "arcs", arcs, 0},
    {"fanuc", "holes", holes, 0},
    {"fanuc", "contour", [](int n) { return contour(n, "G41 D1"); }, 0},
    {"fanuc", "loop", [](int n) { return fanuc_loop(n, "#2=#2+SIN[#1*0.36]*COS[#1]-[#1 MOD 7]/3\n"); }, 0},
    {"fanuc", "calls", fanuc_calls, 0},
    {"haas", "lines", surface, 0},
    {"haas", "holes", holes, 0},
    {"grbl", "lines", surface, 0},
    {"gost", "lines", whole_numbers, 0},
    {"sinumerik", "lines", [](int n) { return lines_after(n, "G71 G90 G17\n"); }, 0},
    {"sinumerik", "loop", [](int n) { return named_loop(n, "R2=R2+SIN(R1*0.36)*COS(R1)-(R1 MOD 7)/3\n"); }, 0},
    {"sinumerik", "moving_loop", [](int n) { return named_loop(n, "G1 X=50*COS(R1*0.36) Y=50*SIN(R1*0.36) Z=-R1*0.00001\n"); }, 0},
    {"sinumerik", "calls", named_calls, 0},
    {"heidenhain", "lines", klartext_lines, 0},
    {"heidenhain", "loop", [](int n) { return klartext(n, "Q2 = Q2 + SIN (Q1 * 0.36) * COS Q1 - (Q1 % 7) / 3\n"); }, 0},
    {"heidenhain", "moving_loop", [](int n) { return klartext(n, "Q3 = 50 * COS (Q1 * 0.36)\nL X+Q3 Y+Q1\n"); }, 0},
    {"heidenhain", "calls", [](int n) { return klartext(n, "CALL LBL 3\n", "M30\nLBL 3\nL X+Q1 Y+1\nLBL 0\n"); }, 0},
};
// clang-format on

struct Count {
  std::uint64_t allocations = 0, blocks = 0;
};

Count run_of(const Case& given, int size) {
  static const MachineProfile machine = load_machine("generic").value();
  const auto def = std::make_shared<const ControlDef>(load_control(given.control).value());
  kadr::Setup setup;
  setup.offsets[1].radius = 5;
  auto session = Session::open({def, machine, setup, {"main.nc", text_source(given.program(size)), {}}, {}});
  if (!session) return {};
  (*session)->outlets().alarm = [&](const AlarmReport& report) {
    ADD_FAILURE() << name_of(report.alarm.id) << " in line " << report.origin.line;
    return false;
  };
  const std::uint64_t before = allocated;
  EXPECT_EQ((*session)->run(), Session::State::ended);
  return {allocated - before, (*session)->control().blocks()};
}

class Allocations : public testing::TestWithParam<Case> {};

TEST_P(Allocations, are_no_more) {
  constexpr int some = 2000, many = 6000;
  const Case& given = GetParam();
  const Count of_short = run_of(given, some), of_long = run_of(given, many);
  ASSERT_GE(of_long.blocks, of_short.blocks + (many - some));
  const double more = static_cast<double>(of_long.allocations) - static_cast<double>(of_short.allocations);
  const double each = 1000 * more / static_cast<double>(of_long.blocks - of_short.blocks);
  // The thread that runs the control ahead takes a few blocks of memory more or fewer, as it happens.
  constexpr double by_chance = 3;
  EXPECT_LE(each, given.most + by_chance);
  EXPECT_GE(each, given.most * 0.9 - by_chance) << "better than the table says: lower its number";
}

INSTANTIATE_TEST_SUITE_P(allocations, Allocations, testing::ValuesIn(cases),
                         [](const auto& of) { return std::string(of.param.control) + "_" + of.param.name; });

}  // namespace
}  // namespace kadr::allocations_test
