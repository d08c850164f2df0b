// control/nct/tools/tools: tables, search, change, life, data input. The search is compared with a slow reference. NCT 12.

#include "control/nct/tools/tools.h"

#include "choices.h"

namespace kadr::nct::tools_test {
namespace {

using test::Choices;
using test::choices;
using Tables = kadr::Setup;  // in a test, Setup would mean GoogleTest's Setup

constexpr std::uint32_t uencv = 1, uentv = 3, sencv = 17, sentv = 19, sdlcv = 29;  // 12.3.1
constexpr std::uint32_t drill = 81501070, mill = 10002001;

ToolRow tool(std::uint32_t type, std::uint32_t info, std::uint32_t status, double counter, double life) {
  ToolRow row;
  row.type = type;
  row.info = info;
  row.status = status;
  row.counter = counter;
  row.life = life;
  return row;
}

/// The sample table of 12.3.1.
Tables sample() {
  Tables setup;
  setup.tool_table = {{1, tool(mill, uencv, 3, 150, 150)}, {2, tool(mill, sencv, 2, 131, 200)},   {3, tool(mill, sencv, 1, 0, 170)},
                      {4, tool(150, sdlcv, 0, 0, 0)},      {5, tool(3210, uentv, 4, 6146, 9000)}, {6, tool(3210, sentv, 2, 5654, 6630)}};
  setup.tool_table[2].h = 2, setup.tool_table[2].d = 3, setup.tool_table[2].s = 11400, setup.tool_table[2].f = 2800;
  setup.tool_table[2].warn = 12, setup.tool_table[4].form = 2;
  return setup;
}

/// The two drills of 12.5 and an empty spindle.
Tables drills(double counter = 131) {
  Tables setup;
  setup.tool_table = {{2, tool(drill, sencv, 2, counter, 200)}, {9, tool(drill, sencv, 1, 0, 180)}};
  setup.tool_table[2].h = 12, setup.tool_table[2].d = 23;
  setup.tool_table[9].h = 13, setup.tool_table[9].d = 14;
  setup.place_table = {{{1, 4}, 9}, {{1, 8}, 2}, {{10, 1}, 0}};
  return setup;
}

AlarmId alarm_of(const Status& status) { return status ? no_alarm : status.error().id; }
template <class T>
AlarmId alarm_of(const Result<T>& result) {
  return result ? no_alarm : result.error().id;
}

TEST(search, takes_the_largest_unexpired_counter) {  // 12.3.1, sample table
  const ToolManagement tools(sample());
  EXPECT_EQ(tools.search(mill), 2);
  EXPECT_EQ(tools.search(3210), 6);
  EXPECT_EQ(tools.search(150), 4);  // takes no part in life management, but S makes it searchable
  EXPECT_EQ(tools.search(7), 0);
}

TEST(search, not_performed_needs_S_and_every_row_needs_V) {
  Tables setup;
  setup.tool_table = {{1, tool(5, uencv, 0, 0, 0)}, {2, tool(5, sencv & ~1U, 1, 9, 20)}};
  EXPECT_EQ(ToolManagement(setup).search(5), 0);
  setup.tool_table[3] = tool(5, sencv, 0, 0, 0);
  EXPECT_EQ(ToolManagement(setup).search(5), 3);
}

TEST(search, equal_counters_the_smaller_number_and_no_broken_ones) {
  Tables setup;
  setup.tool_table = {{5, tool(555, sencv, 1, 0, 100)}, {2, tool(555, sencv, 1, 0, 100)}};
  EXPECT_EQ(ToolManagement(setup).search(555), 2);
  setup.tool_table[2].status = 4;
  EXPECT_EQ(ToolManagement(setup).search(555), 5);
}

/// The reference compares each candidate with each other candidate.
int slow_search(const std::map<int, ToolRow>& rows, std::uint32_t type) {
  const auto candidate = [&](const ToolRow& row) {
    const bool s = row.info / 16 % 2 == 1;
    return row.info % 2 == 1 && row.type == type && (row.status == 1 || row.status == 2 || (row.status == 0 && s));
  };
  for (const auto& [data, row] : rows) {
    bool best = candidate(row);
    for (const auto& [other, rival] : rows)
      if (candidate(rival) && (rival.counter > row.counter || (rival.counter == row.counter && other < data))) best = false;
    if (best) return data;
  }
  return 0;
}

RC_GTEST_PROP(search, agrees_with_a_slow_twin, ()) {
  Choices choose = choices(120);
  Tables setup;
  for (int i = choose.between(0, 12); i > 0; --i) {
    setup.tool_table[choose.between(1, 30)] =
        tool(static_cast<std::uint32_t>(choose.between(1, 3)), static_cast<std::uint32_t>(choose.between(0, 31)),
             static_cast<std::uint32_t>(choose.between(0, 4)), choose.between(0, 4), choose.between(0, 4));
  }
  const ToolManagement tools(setup);
  for (std::uint32_t type = 0; type < 5; ++type) RC_ASSERT(tools.search(type) == slow_search(setup.tool_table, type));
}

TEST(call, without_tables_only_the_number) {
  ToolManagement tools;
  EXPECT_FALSE(tools.enabled());
  EXPECT_EQ(*tools.call(12, CallBy::type), (ToolCall{12, 0, 0, 0}));
  EXPECT_EQ(tools.change(10, CountUse::yes), (ToolCall{12, 0, 0, 0}));
  EXPECT_EQ(tools.change(10, CountUse::yes).tool, 12U);  // no tool is prepared: the current tool stays
  EXPECT_TRUE(tools.places().empty());
}

TEST(call, by_place) {  // 12.5.2
  ToolManagement bare;
  EXPECT_EQ(*bare.call(100001, CallBy::place), (ToolCall{100001, 0, 10, 1}));
  EXPECT_EQ(*bare.call(10014, CallBy::place), (ToolCall{10014, 0, 1, 14}));
  Tables setup;
  setup.place_table = {{{1, 12}, 2}, {{1, 21}, 9}, {{10, 1}, 0}};
  ToolManagement tools(setup);
  EXPECT_EQ(*tools.call(10012, CallBy::place), (ToolCall{10012, 2, 1, 12}));
  EXPECT_EQ(alarm_of(tools.call(10013, CallBy::place)), AlarmId::tool_not_found);
}

TEST(call, by_place_takes_an_expired_tool) {  // 12.5.2: to remove it from the magazine
  Tables setup = drills();
  setup.tool_table[2].status = 3;
  ToolManagement tools(setup);
  ASSERT_TRUE(tools.call(10008, CallBy::place));
  EXPECT_EQ(tools.change(10, CountUse::yes), (ToolCall{drill, 2, 1, 8}));
  EXPECT_EQ(tools.row(2)->counter, 131);
  EXPECT_EQ(tools.row(2)->status, 3U);
}

TEST(call, no_candidate) {
  ToolManagement tools(drills());
  const auto none = tools.call(77, CallBy::type);
  ASSERT_EQ(alarm_of(none), AlarmId::tool_not_found);
  EXPECT_EQ(none.error().args[0].number(), 77);
}

TEST(change, takes_the_tool_out_of_its_pocket) {  // golden 12-6
  ToolManagement tools(drills());
  EXPECT_EQ(*tools.call(drill, CallBy::type), (ToolCall{drill, 2, 1, 8}));
  EXPECT_EQ(tools.change(10, CountUse::yes), (ToolCall{drill, 2, 1, 8}));
  EXPECT_EQ(tools.places(), (PocketTable{{{1, 4}, 9}, {{1, 8}, 0}, {{10, 1}, 2}}));
  EXPECT_EQ(tools.row(2)->counter, 132);
  EXPECT_EQ(tools.spindle_row(), 2);
}

TEST(change, expiry_makes_the_next_search_take_the_other) {  // golden 12-7
  ToolManagement tools(drills(199));
  ASSERT_TRUE(tools.call(drill, CallBy::type));
  tools.change(10, CountUse::yes);
  EXPECT_EQ(tools.row(2)->counter, 200);
  EXPECT_EQ(tools.row(2)->status, 3U);
  EXPECT_EQ(tools.call(drill, CallBy::type)->data, 9);
  EXPECT_EQ(tools.change(10, CountUse::yes), (ToolCall{drill, 9, 1, 4}));
  EXPECT_EQ(tools.row(9)->status, 2U);  // not used → used
  EXPECT_EQ(tools.row(9)->counter, 1);
  EXPECT_EQ(tools.places(), (PocketTable{{{1, 4}, 2}, {{1, 8}, 0}, {{10, 1}, 9}}));  // random handling: they swap pockets
}

TEST(change, not_counted_when_the_other_code_counts) {
  ToolManagement tools(drills());
  ASSERT_TRUE(tools.call(drill, CallBy::type));
  tools.change(10, CountUse::no);
  EXPECT_EQ(tools.row(2)->counter, 131);
}

TEST(change, the_tool_in_the_spindle_stays_and_is_counted_again) {
  ToolManagement tools(drills());
  ASSERT_TRUE(tools.call(drill, CallBy::type));
  tools.change(10, CountUse::yes);
  ASSERT_TRUE(tools.call(drill, CallBy::type));
  EXPECT_EQ(tools.change(10, CountUse::yes), (ToolCall{drill, 2, 10, 1}));
  EXPECT_EQ(tools.row(2)->counter, 133);
  EXPECT_EQ(tools.change(10, CountUse::yes), (ToolCall{drill, 2, 10, 1}));  // no tool is prepared
  EXPECT_EQ(tools.row(2)->counter, 133);
}

TEST(change, t0_puts_the_tool_back_where_it_came_from) {
  ToolManagement tools(drills());
  ASSERT_TRUE(tools.call(drill, CallBy::type));
  tools.change(10, CountUse::yes);
  ASSERT_TRUE(tools.call(0, CallBy::type));
  EXPECT_EQ(tools.change(10, CountUse::yes), (ToolCall{0, 0, 0, 0}));
  EXPECT_EQ(tools.places(), drills().place_table);
}

TEST(change, an_empty_pocket_takes_the_tool) {
  Tables setup = drills();
  setup.place_table = {{{1, 1}, 0}, {{1, 8}, 0}, {{10, 1}, 2}};
  ToolManagement tools(setup);
  ASSERT_TRUE(tools.call(10008, CallBy::place));
  EXPECT_EQ(tools.change(10, CountUse::yes), (ToolCall{10008, 0, 1, 8}));
  EXPECT_EQ(tools.places(), (PocketTable{{{1, 1}, 0}, {{1, 8}, 2}, {{10, 1}, 0}}));
}

RC_GTEST_PROP(change, loses_and_doubles_no_tool_while_a_pocket_is_free, ()) {
  Choices choose = choices(120);
  Tables setup;
  for (int data = 1; data <= 5; ++data)
    setup.tool_table[data] = tool(static_cast<std::uint32_t>(100 + data % 3), sencv, 2, choose.between(0, 5), 10);
  for (int data = 1; data <= 4; ++data) setup.place_table[{1, data}] = data;
  setup.place_table[{1, 5}] = 0, setup.place_table[{10, 1}] = 5, setup.place_table[{11, 1}] = 0;
  Journal journal;
  ToolManagement tools(setup);
  tools.keep_in(journal);
  for (int step = 0; step < 12; ++step) {
    journal.begin();
    const PocketTable before = tools.places();
    const auto called = choose.one_in(3) ? tools.call(static_cast<std::uint32_t>(10000 + choose.between(1, 5)), CallBy::place)
                                         : tools.call(static_cast<std::uint32_t>(100 + choose.between(-1, 2)), CallBy::type);
    const ToolCall now = tools.change(10, choose.one_in(2) ? CountUse::yes : CountUse::no);
    if (called) RC_ASSERT(tools.spindle_row() == called->data && now.data == called->data);
    std::map<int, int> times;
    for (const auto& [pocket, data] : tools.places()) times[data]++;
    for (int data = 1; data <= 5; ++data) RC_ASSERT(times[data] == 1);
    if (choose.one_in(4)) {
      journal.undo();
      RC_ASSERT(tools.places() == before);
    }
  }
}

TEST(life, time_counts_for_tools_with_T_only) {
  Tables setup = sample();
  setup.tool_table[6].life = 5660, setup.tool_table[6].status = 1;
  setup.place_table = {{{10, 1}, 6}, {{20, 1}, 2}};
  ToolManagement tools(setup);
  tools.add_time(2.5);
  EXPECT_EQ(tools.row(6)->counter, 5656.5);
  EXPECT_EQ(tools.row(6)->status, 2U);
  EXPECT_EQ(tools.spindle_data(10, 8403), 5656);
  tools.add_time(3.5);
  EXPECT_EQ(tools.row(6)->status, 3U);
  tools.add_time(1);  // expired: no longer counted
  EXPECT_EQ(tools.row(6)->counter, 5660);
  tools.add_time(100, 20);
  EXPECT_EQ(tools.row(2)->counter, 131);
}

TEST(life, warning) {
  Tables setup = sample();
  ToolManagement tools(setup);
  EXPECT_FALSE(tools.warning(2));
  EXPECT_TRUE(tools.warning(1));
  EXPECT_FALSE(tools.warning(4));  // not in tool life management
  EXPECT_FALSE(tools.warning(99));
  tools.edit_row(2).counter = 188;
  EXPECT_TRUE(tools.warning(2));  // 200 - 188 = 12
}

TEST(spindle_data, columns) {  // 12.5.3, golden 12-13, 12-14
  Tables setup = sample();
  setup.tool_table[2].user[0] = 1.5, setup.tool_table[2].user[2] = 7, setup.tool_table[2].user_bits = 19;
  setup.place_table = {{{10, 1}, 2}, {{11, 1}, 0}};
  const ToolManagement tools(setup, {10, 2, 99});
  const std::pair<int, double> expected[] = {{8401, 2},  {8402, mill}, {8403, 131}, {8404, 200}, {8405, 12},    {8406, 2},
                                             {8407, 19}, {8408, 17},   {8409, 2},   {8410, 3},   {8411, 11400}, {8412, 2800},
                                             {8413, 0},  {8414, 0},    {8431, 1.5}, {8432, 0}};
  for (const auto& [variable, value] : expected) EXPECT_EQ(tools.spindle_data(10, variable), value) << variable;
  for (const int vacant : {8415, 8430, 8433, 8450}) EXPECT_EQ(tools.spindle_data(10, vacant), std::nullopt) << vacant;
  EXPECT_EQ(tools.spindle_data(11, 8401), 0);
  EXPECT_EQ(tools.spindle_data(11, 8402), std::nullopt);
  EXPECT_EQ(ToolManagement().spindle_data(10, 8401), 0);
}

TEST(spindle_data, magazine_numbers) {
  for (const double good : {10.0, 11.0, 20.0, 21.0}) EXPECT_TRUE(ToolManagement::check_magazine(good));
  for (const double bad : {0.0, 1.0, 4.0, 12.0, 10.5, -10.0, 1e12})
    EXPECT_EQ(alarm_of(ToolManagement::check_magazine(bad)), AlarmId::magazine_number);
}

TEST(offset_numbers, of_the_tool_in_the_spindle) {  // 12.5.1
  ToolManagement tools(drills());
  EXPECT_EQ(tools.offset_numbers().h, 0);
  ASSERT_TRUE(tools.call(drill, CallBy::type));
  tools.change(10, CountUse::yes);
  EXPECT_EQ(tools.offset_numbers().h, 12);
  EXPECT_EQ(tools.offset_numbers().d, 23);
}

TEST(fits_next_to, form_5_of_the_manual) {  // needs 2 pockets to the left and half a pocket to the right
  const ToolForm wide{4, 1, 0, 0, 0};
  const ToolForm normal{}, half{1, 1, 0, 0, 0};
  EXPECT_TRUE(fits_next_to(5, normal, 6, normal));
  EXPECT_FALSE(fits_next_to(5, wide, 6, normal));
  EXPECT_TRUE(fits_next_to(5, wide, 7, half));  // two half pockets share pocket 6
  EXPECT_FALSE(fits_next_to(3, normal, 5, wide));
  EXPECT_TRUE(fits_next_to(2, normal, 5, wide));
  EXPECT_FALSE(fits_next_to(5, normal, 5, normal));
}

RC_GTEST_PROP(fits_next_to, agrees_with_counting_half_pockets, ()) {
  Choices choose = choices(20);
  const auto form = [&] { return ToolForm{static_cast<double>(choose.between(0, 6)), static_cast<double>(choose.between(0, 6)), 0, 0, 0}; };
  const int a = choose.between(1, 12), b = choose.between(1, 12);
  const ToolForm fa = form(), fb = form();
  std::set<int> halves;
  bool apart = true;
  const auto lay = [&](int pocket, const ToolForm& f) {
    for (int half = 2 * pocket - static_cast<int>(f.left); half < 2 * pocket + 2 + static_cast<int>(f.right); ++half)
      apart = halves.insert(half).second && apart;
  };
  lay(a, fa);
  lay(b, fb);
  RC_ASSERT(fits_next_to(a, fa, b, fb) == apart);
  RC_ASSERT(fits_next_to(b, fb, a, fa) == apart);
}

TEST(form_of, needs_the_bit_L) {
  Tables setup = sample();
  setup.form_table[2] = {3, 2, 0, 0, 0};
  setup.tool_table[2].form = 2;
  const ToolManagement tools(setup);
  EXPECT_EQ(tools.form_of(4).left, 3);
  EXPECT_EQ(tools.form_of(2).left, 0);
}

RC_GTEST_PROP(undo, brings_every_table_back_and_names_what_differs, ()) {
  Choices choose = choices(200);
  Journal journal;
  ToolManagement tools(drills());
  tools.keep_in(journal);
  auto known = tools.rows();
  for (int i = 0; i < 10; ++i) {
    const auto rows = tools.rows();
    const auto places = tools.places();
    journal.begin();
    for (int j = choose.between(0, 5); j > 0; --j) {
      const int data = choose.between(1, 9);
      if (choose.one_in(3)) tools.clear_row(data);
      else tools.edit_row(data).counter += 1;
      tools.set_place({1, data}, choose.between(0, 9));
    }
    if (choose.one_in(2)) {
      journal.undo();
      RC_ASSERT(tools.places() == places);
      RC_ASSERT(tools.rows().size() == rows.size());
      for (const auto& [data, row] : rows) RC_ASSERT(tools.row(data) != nullptr && tools.row(data)->counter == row.counter);
    }
    if (!choose.one_in(2)) continue;
    const std::vector<int> changed = tools.take_changed_rows();
    for (int data = 1; data <= 9; ++data) {
      const auto old = known.find(data);
      const ToolRow* now = tools.row(data);
      const bool same = (old == known.end()) == (now == nullptr) && (now == nullptr || now->counter == old->second.counter);
      RC_ASSERT(same || std::find(changed.begin(), changed.end(), data) != changed.end());
    }
    known = tools.rows();
  }
}

TEST(changes, are_named_once) {
  ToolManagement tools(drills());
  EXPECT_TRUE(tools.take_changed_rows().empty());
  ASSERT_TRUE(tools.call(drill, CallBy::type));
  tools.change(10, CountUse::yes);
  EXPECT_EQ(tools.take_changed_rows(), std::vector<int>{2});
  EXPECT_EQ(tools.take_changed_places(), (std::vector<Pocket>{{1, 8}, {10, 1}}));
  EXPECT_TRUE(tools.take_changed_places().empty());
  EXPECT_TRUE(tools.take_changed_forms().empty());
}

}  // namespace
}  // namespace kadr::nct::tools_test
