// compare/comparison_text: the printed text of a comparison.

#include "compare/comparison_text.h"

#include <gtest/gtest.h>

namespace kadr::comparison_text_test {
namespace {

TEST(ComparisonText, OfDifferences) {
  CourseDifference d;
  d.distance = 0.5;
  EXPECT_EQ(sentence_of(d, Lang::en), "another way, up to 0.5 mm apart");
  d.b_value = "M8";
  EXPECT_EQ(sentence_of(d, Lang::en), "another way, up to 0.5 mm apart; nothing — M8");
  d.kind = CourseDifference::Kind::feed;
  d.a_value = "F100 mm/min", d.b_value = "F200 mm/min";
  EXPECT_EQ(sentence_of(d, Lang::ru), "подача: F100 mm/min — F200 mm/min");
}

TEST(ComparisonText, OfAll) {
  Comparison c;
  c.moves_a = 412, c.greatest = 0.0004;
  EXPECT_EQ(summary_of(c, Lang::en), "equal: 412 motions, greatest distance 0.0004 mm");
  c.differences.resize(2);
  c.more = 3;
  EXPECT_EQ(summary_of(c, Lang::en), "5 differences");
  c.lost = true;
  EXPECT_EQ(summary_of(c, Lang::ru), "различий: 5; после последнего общего места не найдено");
  c.cancelled = true;
  EXPECT_EQ(summary_of(c, Lang::en), "interrupted");
}

}  // namespace
}  // namespace kadr::comparison_text_test
