// The law of drive/grbl/grbl_writer: the controller's path of the written lines is the path of the program, whatever its control is. The
// lines are read back by Kadr's interpreter for Grbl, which was compared with Grbl's own (tests/grbl_oracle.py).

#include "drive/grbl/grbl_writer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "session/a_session.h"

namespace kadr::drive {
namespace {

using kadr::test::ASession;

using Path = std::vector<GrblPoint>;

double distance(const GrblPoint& a, const GrblPoint& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

/// Returns how far `point` is from the polyline.
double off(const Path& path, const GrblPoint& point) {
  double least = distance(path.front(), point);
  for (std::size_t i = 1; i < path.size(); ++i) {
    const GrblPoint &a = path[i - 1], &b = path[i];
    double dot = 0, square = 0;
    for (std::size_t k = 0; k < 3; ++k) dot += (point[k] - a[k]) * (b[k] - a[k]), square += (b[k] - a[k]) * (b[k] - a[k]);
    const double part = square > 0 ? std::clamp(dot / square, 0.0, 1.0) : 0;
    least = std::min(least, distance(point, {a[0] + (b[0] - a[0]) * part, a[1] + (b[1] - a[1]) * part, a[2] + (b[2] - a[2]) * part}));
  }
  return least;
}

struct Written {
  std::string text;
  Path path;     // of the actions
  Path written;  // of the lines, as the writer states it
  std::string refused;
};

/// Appends the points of the motion of a step.
void add_path(const Step& step, Path& path) {
  constexpr double chord = 2e-4;  // mm
  const Motion& motion = *step.motion();
  const Curve& curve = step.curve();
  const int pieces = curve.straight() ? 1 : curve.pieces(chord);
  for (int i = 0; i <= pieces; ++i) {
    const double part = double(i) / pieces;
    const Axes at = machine_along(step.roles, step.from, motion, curve.at(part), part);
    path.push_back({at[0], at[1], at[2]});
  }
}

Written write(const std::string& control, const std::string& program, const Setup& setup = {}, const GrblSettings& settings = {}) {
  Written made;
  const ASession session(control, program, setup);
  EXPECT_TRUE(session.opened());
  GrblWriter writer(settings);
  session->outlets().wants_times = true;
  session->outlets().step = [&](const Step& step) {
    if (step.motion() != nullptr) add_path(step, made.path);
    const auto lines = writer.write(step, 1);
    if (!lines) made.refused = lines.error();
    for (const JobLine& line : lines.value_or(std::vector<JobLine>{})) {
      made.text += line.text + "\n";
      EXPECT_LT(line.text.size(), 79U) << line.text;
      made.written.insert(made.written.end(), line.path.begin(), line.path.end());
    }
  };
  EXPECT_EQ(session->run(), Session::State::ended) << testing::PrintToString(session.reported());
  return made;
}

/// Returns the path of lines for Grbl.
Path read_back(const std::string& text, const GrblSettings& settings) {
  Setup setup;
  constexpr const char* axes[] = {"X", "Y", "Z"};
  for (const auto& [name, point] : settings.offsets)
    for (std::size_t a = 0; a < 3; ++a) setup.work_offsets[name][axes[a]] = point[a];
  const ASession session("grbl", text, setup);
  Path path;
  session->outlets().step = [&](const Step& step) {
    if (step.motion() != nullptr) add_path(step, path);
  };
  EXPECT_EQ(session->run(), Session::State::ended) << testing::PrintToString(session.reported()) << text;
  return path;
}

void expect_same_path(const std::string& control, const std::string& program, const Setup& setup = {}) {
  SCOPED_TRACE(program);
  GrblSettings settings;
  settings.offsets["G54"] = {-12.5, 7.25, -3};
  const Written made = write(control, program, setup, settings);
  ASSERT_EQ(made.refused, "");
  const Path read = read_back(made.text, settings);
  ASSERT_FALSE(read.empty());
  constexpr double most = GrblWriter::chord + 5e-4;  // and the fourth decimal, and the chords of this test
  for (const GrblPoint& point : made.path) EXPECT_LT(off(read, point), most) << made.text;
  for (const GrblPoint& point : read) EXPECT_LT(off(made.path, point), most) << made.text;
  for (const GrblPoint& point : read) EXPECT_LT(off(made.written, point), 2 * most) << made.text;
  EXPECT_LT(distance(read.back(), made.path.back()), 1e-4);
}

TEST(GrblWriter, WritesTheResolvedPath) {
  expect_same_path("linuxcnc", "G21 G90 G17\nG0 X1 Y2 Z3\nG1 X10 F600\nG2 X20 Y12 I0 J10\nG91 G1 Y5\nG90 G3 X20 Y17 I-4 J0\nM2\n");
  expect_same_path("linuxcnc", "G21 G90 G18 F500\nG0 X0 Y0 Z0\nG2 X10 Z10 I10 K0\nG3 X20 Z0 Y3 I0 K-10\nG19 G2 Y13 Z10 J10 K0\nM2\n");
  expect_same_path("linuxcnc", "G21 G90 G17 F900\nG0 X10 Y0 Z0\nG2 X10 Y0 Z-6 I-10 J0 P3\nM2\n");
  expect_same_path(
      "fanuc",
      "G21 G90 G17 G54 G80\nG0 X5 Y5 Z20\nG83 X5 Y5 Z-10 R2 Q3 F300\nX15\nG80\nG68 X0 Y0 R30\nG1 X10 Y10 F500\nG2 X20 Y20 R10\n"
      "G69\nM30\n");
  expect_same_path("mach3", "G20 G90 F20\nG0 X1 Y1\nG1 X2.5 Z-0.1\nG3 X3.5 Y2 I0 J1\nM30\n");
  kadr::Setup offsets;
  offsets.work_offsets["G55"] = {{"X", 100}, {"Y", -50}};
  expect_same_path("linuxcnc", "G21 G90 G55\nG1 X1 Y1 F500\nG92 X0\nG1 X4\nG2 X6 Y3 R2\nM2\n", offsets);
}

TEST(GrblWriter, ShortArcsAreNoFullCircles) {
  const Written made = write("linuxcnc", "G21 G90 G17 F600\nG0 X10 Y0\nG3 X9.99999 Y0.01 I-10 J0\nG3 X10 Y0 I-10.00001 J-0.01\nM2\n");
  EXPECT_EQ(made.text.find("G2X"), std::string::npos) << made.text;
  double length = 0;
  for (std::size_t i = 1; i < made.written.size(); ++i) length += distance(made.written[i], made.written[i - 1]);
  EXPECT_NEAR(length, 10 + 0.01 + 20 * M_PI - 0.01, 0.05) << made.text;
}

TEST(GrblWriter, SpindleCoolantAndDwell) {
  const Written made = write("linuxcnc", "G21 G90\nM3 S800\nM8\nG4 P0.5\nG1 X1 F100\nS900\nM9 M5\nM2\n");
  const std::string& text = made.text;
  for (const char* const line : {"M3S800\n", "M8\n", "G4P0.5\n", "S900\n", "M9\n", "M5\n"})
    EXPECT_NE(text.find(line), std::string::npos) << line << text;
  EXPECT_LT(text.find("M3S800"), text.find("G1X")) << text;
}

/// The spindle stands while a tool is changed by hand, and turns again before the program moves.
TEST(GrblWriter, SpindleStopsForATool) {
  const std::string text = write("mach3", "G21 G90\nM3 S800\nG1 X1 F100\nT2 M6\nG1 X2\nM30\n").text;
  const std::size_t stop = text.find("M5\n"), start = text.rfind("M3S800\n");
  ASSERT_NE(stop, std::string::npos) << text;
  EXPECT_LT(text.find("X1"), stop) << text;
  EXPECT_LT(stop, start) << text;
  EXPECT_LT(start, text.find("X2")) << text;
}

TEST(GrblWriter, RefusesWhatTheMachineDoesNotHave) {
  EXPECT_NE(write("linuxcnc", "G21 G90\nG1 A10 F100\nM2\n").refused, "");
  EXPECT_NE(write("linuxcnc", "G21 G90\nM3 S100\nG33 Z-5 K1\nM2\n").refused, "");
  EXPECT_NE(write("linuxcnc", "G21 G90\nM19 R30\nM2\n").refused, "");
}

}  // namespace
}  // namespace kadr::drive
