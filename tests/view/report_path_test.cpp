// The path in a report: whole if there is room, otherwise thinned, with no more deviation than it states.

#include "view/report/report_path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "view/opening.h"
#include "view/program_run.h"

namespace kadr::report_path_test {
namespace {

std::unique_ptr<ProgramRun> run_of(const std::string& program) {
  OpeningRequest request;
  request.path = "report_path_test.ngc";
  request.control = "linuxcnc";
  request.text = program;
  auto opened = open_for_page(request);
  EXPECT_TRUE(opened) << opened.error();
  auto run = ProgramRun::make(*opened, {});
  EXPECT_TRUE(run);
  (*run)->execute();
  return std::move(*run);
}

/// Returns a program of arcs and of lines that hardly change direction.
std::string wavy(int blocks) {
  std::string text = "G21 G90 G17 F500\nG0 X0 Y0\n";
  for (int i = 0; i < blocks; ++i)
    text += i % 3 == 0 ? "G3 X" + std::to_string(i + 2) + " Y0 I1 J0\n"
                       : "G1 X" + std::to_string(i + 2) + " Y" + std::to_string(0.001 * (i % 7)) + "\n";
  return text + "M2\n";
}

Vec3 place(const PathVertex& v) { return {double(v.at[0]), double(v.at[1]), double(v.at[2])}; }

double distance(Vec3 p, Vec3 a, Vec3 b) {
  const Vec3 delta = b - a, from = p - a;
  const double square = delta.x * delta.x + delta.y * delta.y + delta.z * delta.z;
  const double along = square > 0 ? std::clamp((from.x * delta.x + from.y * delta.y + from.z * delta.z) / square, 0.0, 1.0) : 0;
  return length(from - along * delta);
}

TEST(ReportPath, IsWholeWhereThereIsRoom) {
  const auto run = run_of(wavy(300));
  const auto path = report_path(drawn_pieces(run->path(), {}), quanta_of(drawn_pieces(run->path(), {})), 1e6);
  ASSERT_TRUE(path) << path.error();
  EXPECT_EQ(path->thinning.off(), 0);
}

TEST(ReportPath, IsThinnedToItsRoom) {
  const auto run = run_of(wavy(3000));
  const auto whole = report_path(drawn_pieces(run->path(), {}), quanta_of(drawn_pieces(run->path(), {})), 1e9);
  const auto half = report_path(drawn_pieces(run->path(), {}), quanta_of(drawn_pieces(run->path(), {})), double(whole->bytes.size()) / 20);
  ASSERT_TRUE(half);
  EXPECT_GT(half->thinning.off(), 0);
  EXPECT_LT(half->bytes.size(), whole->bytes.size() * 3 / 4);
}

TEST(ReportPath, IsNoFartherOffThanItSays) {
  const auto run = run_of(wavy(600));
  for (const Thinning& thinning : {Thinning{3, 0}, Thinning{6, 4}, Thinning{10, 10}})
    for (const ViewPiece& piece : run->path().pieces()) {
      std::size_t last = 0;
      ASSERT_FALSE(is_left_out(piece, 0, thinning));
      for (std::size_t i = 1; i < piece.vertices.size(); ++i) {
        if (is_left_out(piece, i, thinning)) continue;
        for (std::size_t j = last + 1; j < i; ++j)
          ASSERT_LE(distance(place(piece.vertices[j]), place(piece.vertices[last]), place(piece.vertices[i])), thinning.off() + 1e-5);
        last = i;
      }
      EXPECT_EQ(last, piece.vertices.size() - 1);
    }
}

TEST(ReportPath, PointsWithinBlocksGoFirst) {
  const auto run = run_of(wavy(100));
  const Thinning thinning{15, 0};
  for (const ViewPiece& piece : run->path().pieces())
    for (std::size_t i = 0; i + 1 < piece.vertices.size(); ++i)
      EXPECT_FALSE(piece.vertices[i].number != piece.vertices[i + 1].number && is_left_out(piece, i, thinning));
}

TEST(ReportPath, FarPlacesFitInCoarserSteps) {
  const auto run = run_of("G21 G90 F500\nG0 X0\nG1 X5000000\nM2\n");
  const ReportQuanta q = quanta_of(drawn_pieces(run->path(), {}));
  EXPECT_GT(q.length, 0.001);
  EXPECT_LT(q.length, 0.01);
}

}  // namespace
}  // namespace kadr::report_path_test
