// The blank that a program seems to be written for.

#include "view/stock_guess.h"

#include <gtest/gtest.h>

namespace kadr::stock_guess_test {
namespace {

struct Path {
  ViewPiece piece;
  Path& to(PathKind kind, float x, float y, float z) {
    PathVertex v;
    v.kind = kind;
    v.at = {x, y, z};
    piece.vertices.push_back(v);
    return *this;
  }
  Path& rapid(float x, float y, float z) { return to(PathKind::rapid, x, y, z); }
  Path& feed(float x, float y, float z) { return to(PathKind::feed, x, y, z); }
  std::string text(Vec3 zero = {}, bool turned = false) const {
    StockGuess guess;
    guess.take(piece);
    return guess.text(zero, turned);
  }
};

TEST(StockGuess, ZeroIsTheTopWhereAllIsCutBelowIt) {
  EXPECT_EQ(Path().rapid(0, 0, 50).rapid(0, 0, 2).feed(0, 0, -3).feed(60, 0, -3).feed(60, 40, -3).rapid(60, 40, 50).text(),
            "box:-3,-3,-6,63,43,0");
}

TEST(StockGuess, ZeroAtTheTable) {
  EXPECT_EQ(Path().rapid(0, 0, 50).feed(0, 0, 20).feed(60, 0, 20).feed(60, 0, 12).feed(0, 0, 12).text(), "box:-3,-3,9,63,3,20");
}

TEST(StockGuess, OnADrillsWayTheZeroCounts) { EXPECT_EQ(Path().rapid(10, 10, 2).feed(10, 10, -22).text(), "box:8,8,-24,12,12,0"); }

TEST(StockGuess, FromTheZeroOfThePicture) {
  EXPECT_EQ(Path().rapid(100, 200, -50).feed(100, 200, -103).feed(160, 200, -103).text({100, 200, -100}), "box:-3,-3,-6,63,3,0");
}

TEST(StockGuess, OfAPartThatTurns) {
  const Path path = Path().rapid(30, 0, 2).feed(25, 0, 0).feed(-0.8F, 0, 0).rapid(24, 0, 2).feed(24, 0, -60);
  EXPECT_EQ(path.text({}, true), "cylinder:0,0,-64,1,60");
  StockGuess guess;
  guess.take(path.piece);
  EXPECT_TRUE(guess.is_flat({}));
}

TEST(StockGuess, WaysInFromBesideDoNotCount) {
  const auto contour = [](float start) {
    return Path()
        .rapid(0, -20, 50)
        .rapid(0, -20, start)
        .feed(0, 0, start)
        .feed(0, 0, -2)
        .feed(0, 40, -2)
        .feed(60, 40, -2)
        .feed(60, 0, -2)
        .feed(0, 0, -2)
        .feed(0, -20, -2)
        .rapid(0, -20, 50);
  };
  EXPECT_EQ(contour(-2).text(), "box:-3,-3,-5,63,43,0");
  EXPECT_EQ(contour(2).text(), "box:-3,-23,-5,63,43,0") << "from above the top the way may be cut";
  EXPECT_EQ(Path().rapid(0, 0, 2).feed(0, 0, -2).feed(60, 0, -2).rapid(60, 0, 50).text(), "box:-3,-3,-5,63,3,0")
      << "a groove that ends in the part";
  EXPECT_EQ(Path().rapid(0, 0, -2).feed(60, 0, -2).rapid(60, 0, 50).text().substr(0, 4), "box:") << "nothing else is known";
}

TEST(StockGuess, OfPiecesAsOfTheWhole) {
  const Path whole = Path()
                         .rapid(0, -20, 50)
                         .rapid(0, -20, -2)
                         .feed(0, 0, -2)
                         .feed(0, 40, -2)
                         .feed(60, 40, -2)
                         .rapid(60, 40, 50)
                         .feed(60, 40, 9)
                         .rapid(0, 0, 0);
  for (std::size_t cut = 1; cut + 1 < whole.piece.vertices.size(); ++cut) {
    StockGuess guess;
    ViewPiece first, second;
    const auto at = whole.piece.vertices.begin() + std::ptrdiff_t(cut);
    first.vertices.assign(whole.piece.vertices.begin(), at + 1), second.vertices.assign(at, whole.piece.vertices.end());
    guess.take(first), guess.take(second);
    EXPECT_EQ(guess.text({}, false), whole.text()) << cut;
  }
}

TEST(StockGuess, OfNothing) {
  EXPECT_EQ(Path().text(), "");
  EXPECT_EQ(Path().rapid(0, 0, 0).rapid(5, 5, 5).text(), "");
}

}  // namespace
}  // namespace kadr::stock_guess_test
