// Removal rates as colours.

#include "out/picture/load_colour.h"

#include <gtest/gtest.h>

namespace kadr::load_colour_test {
namespace {

TEST(load_colour, from_blue_to_red) {
  const SweepRates rates = {0, 5, 10, 20};
  EXPECT_EQ(greatest_rate({0, 1, 2, -1}, rates), 10);  // the sweep with the highest rate has left no surface
  EXPECT_EQ(greatest_rate({-1, 9}, rates), 0);         // the blank, and a sweep without a known rate
  const std::uint32_t none = load_colour(0, rates, 10), light = load_colour(1, rates, 1000), heavy = load_colour(2, rates, 10);
  EXPECT_EQ(load_colour(9, rates, 10), none);
  EXPECT_EQ(load_colour(-1, rates, 10), none);
  EXPECT_GT(light & 0xFF, light >> 16);  // more blue than red
  EXPECT_GT(heavy >> 16, heavy & 0xFF);
  EXPECT_EQ(load_colour(3, rates, 10), heavy);
}

/// A canvas that records the numbers of the drawn marks.
class Counted : public Canvas {
 public:
  void fill(const Area&, Colour) override {}
  void ring(Vec2, double, Colour, double) override {}
  void pixels(const Area&, const Pixels&) override {}
  void clip(const Area&) override {}
  void unclip() override {}
  void pen(Colour, double) override {}
  void dashes(double, double) override {}
  void move_to(Vec2) override {}
  void line_to(Vec2) override {}
  void fill_path() override {}
  void stroke() override {}
  std::string texts;

 private:
  void put_text(Vec2, const std::string& text, const TextStyle&) override { texts += text + ' '; }
};

TEST(load_colour, a_mark_that_would_cover_a_heavier_one_is_left_out) {
  Counted canvas;
  draw_load_marks(canvas, {{{100, 100}, "1"}, {{105, 100}, "2"}, {{300, 100}, "3"}, {{300, 110}, "4"}, {{300, 140}, "5"}});
  EXPECT_EQ(canvas.texts, "1 3 5 ");
}

}  // namespace
}  // namespace kadr::load_colour_test
