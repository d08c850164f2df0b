// Guesses the blank for which a program was written.

#include "view/stock_guess.h"

#include <gtest/gtest.h>

namespace kadr::stock_guess_test {
namespace {

struct Path {
  ViewPiece piece;
  std::uint16_t tool = 0;
  Path& with(std::uint16_t number) {
    tool = number;
    return *this;
  }
  Path& to(PathKind kind, float x, float y, float z) {
    PathVertex v;
    v.kind = kind, v.tool = tool;
    v.at = {x, y, z};
    piece.vertices.push_back(v);
    return *this;
  }
  Path& rapid(float x, float y, float z) { return to(PathKind::rapid, x, y, z); }
  Path& feed(float x, float y, float z) { return to(PathKind::feed, x, y, z); }
  std::string text(Vec3 zero = {}, bool turned = false, const StockGuess::RadiusOf& radius_of = {}) const {
    StockGuess guess;
    guess.take(piece);
    return guess.text(zero, turned, radius_of);
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

double radius_of(std::uint32_t tool) { return tool == 1 ? 10 : tool == 2 ? 1.5 : 0; }

TEST(StockGuess, APocketHasWallsHoweverWideTheTool) {
  // The centre of a tool of 20 mm follows a rectangle of 40 by 20 mm: the pocket is 60 by 40 mm.
  const Path pocket =
      Path().with(1).rapid(0, 0, 2).feed(0, 0, -5).feed(40, 0, -5).feed(40, 20, -5).feed(0, 20, -5).feed(0, 0, -5).rapid(0, 0, 50);
  EXPECT_EQ(pocket.text(), "box:-2,-2,-7,42,22,0") << "where nobody knows the tool, its middle counts";
  EXPECT_EQ(pocket.text({}, false, radius_of), "box:-11,-11,-7,51,31,0");
  Path further = pocket;  // a thin tool that travels further does not extend the travel of the wide one
  further.with(2).rapid(48, 0, 2).feed(48, 0, -5).feed(48, 20, -5).rapid(48, 20, 50);
  EXPECT_EQ(further.text({}, false, radius_of), "box:-11,-11,-8,51,31,0");
}

TEST(StockGuess, AToolThatComesDownBesideTheBlankDoesSo) {
  const auto contour = [](float start) {
    return Path()
        .with(1)
        .rapid(0, start, 50)
        .rapid(0, start, -2)
        .feed(0, 0, -2)
        .feed(0, 40, -2)
        .feed(60, 40, -2)
        .feed(60, 0, -2)
        .feed(0, 0, -2)
        .feed(0, start, -2)
        .rapid(0, start, 50);
  };
  EXPECT_EQ(contour(-40).text({}, false, radius_of), "box:-11,-11,-5,71,51,0");
  EXPECT_EQ(contour(-18).text({}, false, radius_of), "box:-11,-8,-5,71,51,0") << "the tool reaches to Y-8 where it comes down";
  EXPECT_EQ(contour(-11).text({}, false, radius_of), "box:-11,-3,-5,71,51,0") << "no less than around its middle";
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
    EXPECT_EQ(guess.text({}, false, {}), whole.text()) << cut;
  }
}

TEST(StockGuess, OfNothing) {
  EXPECT_EQ(Path().text(), "");
  EXPECT_EQ(Path().rapid(0, 0, 0).rapid(5, 5, 5).text(), "");
}

}  // namespace
}  // namespace kadr::stock_guess_test
