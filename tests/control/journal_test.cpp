// control/state/journal: undo restores what a block has written, and nothing else.

#include "control/state/journal.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <map>

namespace kadr::journal_test {
namespace {

TEST(journal, brings_back_the_first_value_of_a_cell_written_twice) {
  Journal journal;
  double cell = 1;
  journal.begin();
  journal.keep(cell), cell = 2;
  journal.keep(cell), cell = 3;
  journal.undo();
  EXPECT_EQ(cell, 1);
}

TEST(journal, a_new_block_forgets_the_one_before) {
  Journal journal;
  double cell = 1;
  journal.keep(cell), cell = 2;
  journal.begin();
  journal.undo();
  EXPECT_EQ(cell, 2);
}

TEST(journal, undoes_the_last_change_first) {
  Journal journal;
  std::vector<int> order;
  int cell = 0;
  journal.begin();
  journal.on_undo([&] { order.push_back(1); });
  journal.keep(cell), cell = 5;
  journal.on_undo([&] { order.push_back(cell); });
  journal.undo();
  EXPECT_EQ(order, (std::vector<int>{5, 1}));
  EXPECT_EQ(cell, 0);
  journal.undo();  // nothing remains to undo
  EXPECT_EQ(order.size(), 2U);
}

TEST(journal_link, belongs_to_the_place_and_not_to_the_value) {
  Journal journal;
  int undone = 0;
  JournalLink here(journal), copy(here), other;
  EXPECT_FALSE(copy);
  here = other;
  EXPECT_TRUE(here);
  journal.begin();
  here.on_undo([&] { ++undone; });
  copy.on_undo([&] { ++undone; });
  journal.undo();
  EXPECT_EQ(undone, 1);
}

TEST(journal_link, tells_the_first_time_of_a_block) {
  Journal journal;
  JournalLink link(journal);
  journal.begin();
  EXPECT_TRUE(link.is_first());
  EXPECT_FALSE(link.is_first());
  journal.begin();
  EXPECT_TRUE(link.is_first());
}

/// Compares with a slow reference that copies everything at the start of a block.
RC_GTEST_PROP(journal, is_like_a_copy_of_all, ()) {
  Journal journal;
  std::array<double, 6> numbers{};
  std::array<std::uint8_t, 6> flags{};
  std::map<int, int> rows;
  auto copies = std::make_tuple(numbers, flags, rows);
  for (int step = 0; step < 60; ++step) {
    const auto i = *rc::gen::inRange<std::size_t>(0, 6);
    switch (*rc::gen::inRange(0, 7)) {
      case 0:
        journal.begin();
        copies = {numbers, flags, rows};
        break;
      case 1:
        journal.undo();
        RC_ASSERT(std::make_tuple(numbers, flags, rows) == copies);
        break;
      case 2:
      case 3: journal.keep(numbers[i]), numbers[i] += step; break;
      case 4: journal.keep(flags[i]), flags[i] ^= 1; break;
      case 5: journal.keep(numbers), numbers.fill(step); break;
      default: {
        const int key = static_cast<int>(i);
        journal.on_undo([&rows, old = rows] { rows = old; });
        if (rows.erase(key) == 0) rows[key] = step;
      }
    }
  }
}

}  // namespace
}  // namespace kadr::journal_test
