// control/macro_b/variables/parameters: parameters from the set-up, PRM (nct 24.2), G10 L52 (24.1), undo, and the state at the end.

#include "control/macro_b/variables/parameters.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>

#include "config/setup/parameter_table.h"

namespace kadr::macro_b::parameters_test {
namespace {

const std::vector<ParameterRow>& rows() {
  static const std::vector<ParameterRow> table = load_parameters("nct-parameters").value();
  return table;
}

ParameterStore store(const Parameters& given = {}, int channel = 1) { return {rows(), given, {{"X", "Y", "Z", "A"}, channel}}; }

using Write = ParameterStore::Write;
using Word = ParameterStore::Word;

/// The words `N P Q R` of a block; NaN leaves the word out.
constexpr double no = std::numeric_limits<double>::quiet_NaN();
Write block(double n, double p, double q, double r) {
  const auto word = [](double value, std::uint32_t at) { return value == value ? std::optional(Word{value, {at, at + 1}}) : std::nullopt; };
  return {word(n, 0), word(p, 10), word(q, 20), word(r, 30), false, {0, 40}};
}

/// Returns the alarm with its arguments, for example "2002 P".
std::string described(const Alarm& alarm) {
  std::string text(name_of(alarm.id));
  for (std::size_t i = 0; i < alarm.arg_count; ++i)
    text +=
        " " + (alarm.args[i].is_number() ? std::to_string(static_cast<int>(alarm.args[i].number())) : std::string(alarm.args[i].text()));
  return text;
}

std::string refused(const ParameterStore& of, const Write& w) {
  ParameterStore copy = of;
  const auto status = copy.write(w);
  EXPECT_EQ(copy.version(), of.version() + (status ? 1 : 0));
  EXPECT_TRUE(status || copy.written() == of.written());
  return status ? "done" : described(status.error());
}

std::string read(const ParameterStore& of, double number, std::optional<double> bit = {}, std::optional<double> index = {}) {
  const auto value = of.read(number, bit, index, {});
  return value ? std::to_string(*value) : described(value.error());
}

TEST(parameters, without_a_set_up_are_those_of_power_on) {
  const ParameterStore p = store();
  EXPECT_EQ(p.error(), "");
  EXPECT_EQ(p.value(p.find(1339)), 0.01);
  EXPECT_EQ(p.value(p.find(108), 32), 360);
  EXPECT_EQ(p.value(p.find(1400), 8), 999);
  EXPECT_FALSE(p.bit(p.find(106), 0, 1));
  EXPECT_EQ(p.text(p.find(1333)), "");
  EXPECT_TRUE(p.written().empty());
}

TEST(parameters, are_found_by_number_and_by_name) {
  const ParameterStore p = store();
  EXPECT_EQ(p.named("0107"), p.find(107));
  EXPECT_EQ(p.named("107"), p.find(107));
  EXPECT_NE(p.named("CLRG"), ParameterId::none);
  for (const int unknown : {-1, 0, 109, 3225, 9999}) EXPECT_EQ(p.find(unknown), ParameterId::none) << unknown;
  EXPECT_EQ(p.named("NAP"), ParameterId::none);
  EXPECT_EQ(p.named(""), ParameterId::none);
  for (const ParameterRow& row : rows()) {
    ASSERT_NE(p.named(row.name), ParameterId::none);
    EXPECT_EQ(p.named(row.name), row.number < 0 ? p.named(row.name) : p.find(row.number));
  }
}

TEST(parameters, bits_have_names) {
  const ParameterStore p = store();
  EXPECT_EQ(p.bit_named(p.find(107), "ABS"), 2);
  EXPECT_EQ(p.bit_named(p.find(421), "ROL"), 8);
  EXPECT_EQ(p.bit_named(p.named("CLRG"), "C03"), 3);
  EXPECT_EQ(p.bit_named(p.find(107), "NAP"), -1);
  EXPECT_EQ(p.bit_named(p.find(107), ""), -1);
}

TEST(parameters, that_the_table_has_not_read_as_zero) {
  const ParameterStore p = store();
  EXPECT_EQ(p.value(ParameterId::none, 3), 0);
  EXPECT_FALSE(p.bit(ParameterId::none, 0));
  EXPECT_FALSE(p.bit(p.find(107), -1, 1));
  EXPECT_EQ(p.text(ParameterId::none), "");
  EXPECT_EQ(p.bit_named(ParameterId::none, "ROL"), -1);
}

TEST(set_up, gives_values_by_axis_name_number_channel_spindle) {
  const ParameterStore p = store({{{"0107", "A", "0"}, 1.},
                                  {{"0402", "2", ""}, 250.},
                                  {{"0605", "2", ""}, std::string("B")},
                                  {{"1339", "3", ""}, 0.5},
                                  {{"2201", "", ""}, 500.},
                                  {{"CLRG", "", "C03"}, 1.},
                                  {{"0421", "", "ROL"}, 1.}});
  EXPECT_EQ(p.error(), "");
  EXPECT_TRUE(p.bit(p.find(107), 0, 4));
  EXPECT_FALSE(p.bit(p.find(107), 0, 3));
  EXPECT_EQ(p.value(p.find(402), 2), 250);
  EXPECT_EQ(p.value(p.find(402), 1), 0);
  EXPECT_EQ(p.text(p.find(605), 2), "B");
  EXPECT_EQ(p.value(p.find(605), 2), 'B');
  EXPECT_EQ(p.value(p.find(1339), 3), 0.5);
  EXPECT_EQ(p.value(p.find(2201)), 500);
  EXPECT_TRUE(p.bit(p.named("CLRG"), p.bit_named(p.named("CLRG"), "C03")));
  EXPECT_TRUE(p.bit(p.find(421), p.bit_named(p.find(421), "ROL")));
}

TEST(set_up, without_an_index_is_for_all_and_one_with_an_index_goes_before_it) {
  const ParameterStore p = store({{{"107", "", ""}, 6.}, {{"0107", "X", ""}, 0.}, {{"0107", "Y", "0"}, 1.}, {{"1339", "", ""}, 50.}}, 2);
  EXPECT_EQ(p.value(p.find(107), 1), 0);
  EXPECT_EQ(p.value(p.find(107), 2), 7);
  EXPECT_EQ(p.value(p.find(107), 32), 6);
  for (int channel = 0; channel <= 8; ++channel) EXPECT_EQ(p.value(p.find(1339), channel), 50);
}

TEST(set_up, texts_are_characters_codes_or_names) {
  const ParameterStore p = store({{{"1747", "", ""}, 81.}, {{"0606", "1", ""}, 0.}, {{"1801", "", ""}, std::string("S2")}});
  EXPECT_EQ(p.error(), "");
  EXPECT_EQ(p.text(p.find(1747)), "Q");
  EXPECT_EQ(p.text(p.find(606), 1), "");
  EXPECT_EQ(p.text(p.find(1801)), "S2");
  EXPECT_EQ(p.value(p.find(1801)), 'S');
}

TEST(set_up, what_is_wrong_is_told_and_left_out) {
  const struct {
    ParameterKey key;
    ParameterValue value;
    const char* sentence;
  } cases[] = {
      {{"9998", "", ""}, 1., "setup key 'parameters.N9998': no such parameter"},
      {{"NAP", "", ""}, 1., "setup key 'parameters.NAP': no such parameter"},
      {{"0107", "Q", "0"}, 1., "setup key 'parameters.N0107.Q#0': no such channel, axis or spindle 'Q'"},
      {{"0107", "33", "0"}, 1., "setup key 'parameters.N0107.33#0': no such channel, axis or spindle '33'"},
      {{"2201", "1", ""}, 1., "setup key 'parameters.N2201.1': no such channel, axis or spindle '1'"},
      {{"0107", "X", "8"}, 1., "setup key 'parameters.N0107.X#8': no such bit '8'"},
      {{"0107", "X", "NAP"}, 1., "setup key 'parameters.N0107.X#NAP': no such bit 'NAP'"},
      {{"1339", "", "0"}, 1., "setup key 'parameters.N1339#0': no such bit '0'"},
      {{"0107", "X", "0"}, 2., "setup key 'parameters.N0107.X#0': the value is out of its limits"},
      {{"1404", "", ""}, 9., "setup key 'parameters.N1404': the value is out of its limits"},
      {{"1404", "", ""}, 0.5, "setup key 'parameters.N1404': the value is out of its limits"},
      {{"1339", "", ""}, std::string("X"), "setup key 'parameters.N1339': must be a number"},
      {{"1333", "", ""}, std::string("b"), "setup key 'parameters.N1333': must be letters A to Z and digits"},
      {{"1333", "", ""}, 32., "setup key 'parameters.N1333': the value is out of its limits"},
  };
  for (const auto& c : cases) {
    const ParameterStore p = store({{c.key, c.value}});
    EXPECT_EQ(p.error(), c.sentence);
    EXPECT_TRUE(p.written().empty());
  }
  EXPECT_EQ(store({{{"9998", "", ""}, 1.}, {{"9999", "", ""}, 1.}}).error(),
            "setup key 'parameters.N9998': no such parameter; setup key 'parameters.N9999': no such parameter");
}

TEST(prm, reads_as_in_the_manuals_example) {  // 24.2
  const ParameterStore p = store(
      {{{"0107", "4", "0"}, 1.}, {{"1339", "1", ""}, 0.5}, {{"1746", "1", "1"}, 1.}, {{"2201", "", ""}, 100.}, {{"0100", "1", ""}, "X"}});
  EXPECT_EQ(read(p, 107, 0, 4), "1.000000");
  EXPECT_EQ(read(p, 107, 1, 4), "0.000000");
  EXPECT_EQ(read(p, 1339), "0.500000");
  EXPECT_EQ(read(p, 1339, {}, 1), "0.500000");
  EXPECT_EQ(read(p, 1339, {}, 2), "0.010000");
  EXPECT_EQ(read(p, 1746, 1), "1.000000");
  EXPECT_EQ(read(p, 2201), "100.000000");
  EXPECT_EQ(read(p, 100, {}, 1), "88.000000");  // a parameter that requires a restart can be read
}

TEST(prm, misses_its_arguments) {
  const ParameterStore p = store();
  EXPECT_EQ(read(p, 107, {}, 4), "parameter_argument 2");
  EXPECT_EQ(read(p, 107, 0), "parameter_argument 3");
  EXPECT_EQ(read(p, 107), "parameter_argument 2");
  EXPECT_EQ(read(p, 607, 1), "parameter_argument 3");
}

TEST(prm, refuses_what_is_not_there) {
  const ParameterStore p = store();
  for (const double number : {-1., 109., 1339.5, 10000., 1e300, no})
    EXPECT_EQ(read(p, number).substr(0, 17), "parameter_unknown") << number;
  EXPECT_EQ(read(p, 107, 8, 4), "value_out_of_range Q 8");
  EXPECT_EQ(read(p, 107, -1, 4), "value_out_of_range Q -1");
  EXPECT_EQ(read(p, 1339, 0), "value_out_of_range Q 0");
  EXPECT_EQ(read(p, 107, 0, 33), "value_out_of_range P 33");
  EXPECT_EQ(read(p, 1339, {}, 9), "value_out_of_range P 9");
  EXPECT_EQ(read(p, 607, 1, 17), "value_out_of_range P 17");
  EXPECT_EQ(read(p, 107, 0, 0), "value_out_of_range P 0");
  EXPECT_EQ(read(p, 2201, {}, 1), "value_out_of_range P 1");
}

TEST(g10_l52, writes_as_in_the_manuals_example) {  // 24.1
  ParameterStore p = store({{{"0107", "4", "0"}, 0.}, {{"1339", "1", ""}, 0.25}, {{"1746", "1", "1"}, 0.}});
  ASSERT_TRUE(p.write(block(107, 4, 0, 1)));
  ASSERT_TRUE(p.write(block(1339, no, no, 0.5)));
  ASSERT_TRUE(p.write(block(1746, no, 1, 1)));
  EXPECT_EQ(p.version(), 3u);
  EXPECT_TRUE(p.bit(p.find(107), 0, 4));
  EXPECT_EQ(p.value(p.find(1339)), 0.5);
  EXPECT_TRUE(p.bit(p.find(1746), 1));
  EXPECT_EQ(p.written(), (Parameters{{{"0107", "4", "0"}, 1.}, {{"1339", "1", ""}, 0.5}, {{"1746", "1", "1"}, 1.}}));
}

TEST(g10_l52, adds) {  // RI
  ParameterStore p = store({{{"1339", "1", ""}, 0.25}});
  Write w = block(1339, no, no, 0.25);
  w.increment = true;
  ASSERT_TRUE(p.write(w));
  EXPECT_EQ(p.value(p.find(1339)), 0.5);
  Write bit = block(1746, no, 1, 1);
  bit.increment = true;
  ASSERT_TRUE(p.write(bit));
  EXPECT_EQ(refused(p, bit), "value_out_of_range R 1");  // 1 + 1
}

TEST(g10_l52, clears_one_bit_and_leaves_the_others) {
  ParameterStore p = store({{{"0421", "", "ROL"}, 1.}, {{"0421", "", "1"}, 1.}});
  ASSERT_TRUE(p.write(block(421, no, 1, 0)));
  EXPECT_FALSE(p.bit(p.find(421), 1));
  EXPECT_TRUE(p.bit(p.find(421), 8));
}

TEST(g10_l52, alarms) {
  const ParameterStore p = store();
  EXPECT_EQ(refused(p, block(107, 4, 0, 1)), "done");
  EXPECT_EQ(refused(p, block(107, 32, 7, 0)), "value_out_of_range P 32");  // there is no such axis
  EXPECT_EQ(refused(p, block(109, no, no, 1)), "parameter_unknown 109");
  EXPECT_EQ(refused(p, block(-107, 4, 0, 1)), "parameter_unknown -107");
  EXPECT_EQ(refused(p, block(107, 33, 0, 1)), "value_out_of_range P 33");
  EXPECT_EQ(refused(p, block(107, 0, 0, 1)), "value_out_of_range P 0");
  EXPECT_EQ(refused(p, block(107, 1.5, 0, 1)), "value_out_of_range P 1");
  EXPECT_EQ(refused(p, block(1339, 9, no, 1)), "value_out_of_range P 9");
  EXPECT_EQ(refused(p, block(607, 17, 1, 1)), "value_out_of_range P 17");
  EXPECT_EQ(refused(p, block(2201, 1, no, 1)), "value_out_of_range P 1");
  EXPECT_EQ(refused(p, block(107, 4, 8, 1)), "value_out_of_range Q 8");
  EXPECT_EQ(refused(p, block(107, 4, -1, 1)), "value_out_of_range Q -1");
  EXPECT_EQ(refused(p, block(1339, 1, 0, 1)), "value_out_of_range Q 0");
  EXPECT_EQ(refused(p, block(107, 4, 0, 2)), "value_out_of_range R 2");
  EXPECT_EQ(refused(p, block(1404, no, no, 9)), "value_out_of_range R 9");
  EXPECT_EQ(refused(p, block(1404, no, no, 0.5)), "value_out_of_range R 0");
  EXPECT_EQ(refused(p, block(no, 4, 0, 1)), "word_missing N G10 L52");
  EXPECT_EQ(refused(p, block(107, no, 0, 1)), "word_missing P G10 L52");
  EXPECT_EQ(refused(p, block(107, 4, no, 1)), "word_missing Q G10 L52");
  EXPECT_EQ(refused(p, block(107, 4, 0, no)), "word_missing R G10 L52");
  EXPECT_EQ(refused(p, block(100, 1, no, 1)), "parameter_not_writable 0100");
  EXPECT_EQ(refused(p, block(604, no, no, 1)), "parameter_not_writable 0604");
}

TEST(g10_l52, alarms_stand_at_their_word) {
  ParameterStore p = store();
  EXPECT_EQ(p.write(block(107, 33, 0, 1)).error().where, (Span{10, 11}));
  EXPECT_EQ(p.write(block(107, 4, 0, 2)).error().where, (Span{30, 31}));
  EXPECT_EQ(p.write(block(107, 4, no, 2)).error().where, (Span{0, 40}));
}

TEST(g10_l52, without_a_channel_writes_the_own_one) {
  ParameterStore p = store({}, 3);
  ASSERT_TRUE(p.write(block(1339, no, no, 0.5)));
  ASSERT_TRUE(p.write(block(1339, 2, no, 0.25)));
  EXPECT_EQ(p.value(p.find(1339)), 0.5);
  EXPECT_EQ(p.value(p.find(1339), 2), 0.25);
  EXPECT_EQ(p.value(p.find(1339), 1), 0.01);
  EXPECT_EQ(p.written(), (Parameters{{{"1339", "2", ""}, 0.25}, {{"1339", "3", ""}, 0.5}}));
}

TEST(undo, takes_back_the_block_only) {
  ParameterStore p = store({{{"1801", "1", ""}, std::string("S2")}});
  Journal journal;
  p.keep_in(journal);
  journal.begin();
  ASSERT_TRUE(p.write(block(1339, no, no, 0.5)));
  const Parameters before = p.written();
  journal.begin();
  ASSERT_TRUE(p.write(block(1339, no, no, 0.25)));
  ASSERT_TRUE(p.write(block(107, 4, 0, 1)));
  ASSERT_TRUE(p.write(block(1801, 1, no, 'C')));
  EXPECT_EQ(p.text(p.find(1801)), "C");
  const auto version = p.version();
  journal.undo();
  EXPECT_GT(p.version(), version);
  EXPECT_EQ(p.value(p.find(1339)), 0.5);
  EXPECT_EQ(p.text(p.find(1801)), "S2");
  EXPECT_EQ(p.written(), before);
  const auto after = p.version();
  journal.undo();
  EXPECT_EQ(p.version(), after);  // nothing remains to undo
}

TEST(written, keeps_the_keys_of_the_set_up) {
  ParameterStore p = store({{{"0107", "A", "ABS"}, 1.},
                            {{"0516", "", ""}, 0.01},
                            {{"1747", "1", ""}, 81.},
                            {{"1748", "1", ""}, std::string("E")},
                            {{"1301", "1", ""}, 1.}});
  ASSERT_TRUE(p.write(block(107, 4, 2, 0)));
  ASSERT_TRUE(p.write(block(516, 2, no, 0.02)));
  ASSERT_TRUE(p.write(block(1748, no, no, 'F')));
  ASSERT_TRUE(p.write(block(1301, no, 6, 1)));
  EXPECT_EQ(p.written(), (Parameters{{{"0107", "A", "ABS"}, 0.},
                                     {{"0516", "", ""}, 0.01},
                                     {{"0516", "2", ""}, 0.02},
                                     {{"1747", "1", ""}, 81.},
                                     {{"1748", "1", ""}, std::string("F")},
                                     {{"1301", "1", ""}, 65.}}));
}

TEST(written, of_a_value_for_all_channels_shows_the_own_one_when_it_was_written) {
  ParameterStore p = store({{{"1339", "", ""}, 50.}}, 2);
  EXPECT_EQ(p.written(), (Parameters{{{"1339", "", ""}, 50.}}));
  ASSERT_TRUE(p.write(block(1339, no, no, 1)));
  const Parameters all = p.written();
  EXPECT_EQ(all.at({"1339", "", ""}), ParameterValue(1.));
  const ParameterStore next = store(all, 2);
  EXPECT_EQ(next.value(next.find(1339), 2), 1);
  EXPECT_EQ(next.value(next.find(1339), 1), 50);
}

/// Returns parameters as a random set-up gives them.
Parameters any_set_up() {
  Parameters given;
  for (int n = *rc::gen::inRange(0, 12); n > 0; --n) {
    const ParameterRow& row = *rc::gen::elementOf(rows());
    const bool bit = row.type == ParameterType::bits && *rc::gen::arbitrary<bool>();
    const std::string index = *rc::gen::element<std::string>("", "1", "2", "4", "X", "A");
    given[{row.name, index, bit ? std::to_string(*rc::gen::inRange(0, 8)) : ""}] = *rc::gen::inRange(0, 2) * (bit ? 1. : 65.);
  }
  return given;
}

Write any_block() {
  const ParameterRow& row = *rc::gen::elementOf(rows());
  const bool bits = row.type == ParameterType::bits;
  const double p = row.scope == ParameterScope::global ? no : *rc::gen::element(no, 1., 2., 4., 9.);
  return block(row.number, p, bits ? *rc::gen::inRange(0, 9) : no, *rc::gen::inRange(0, 3) * (bits ? 1 : 33));
}

bool reads_the_same(const ParameterStore& a, const ParameterStore& b) {
  for (const ParameterRow& row : rows())
    for (int index = 1; index <= (row.scope == ParameterScope::global ? 1 : 8); ++index)
      if (a.value(a.named(row.name), index) != b.value(b.named(row.name), index)) return false;
  return true;
}

RC_GTEST_PROP(parameter_properties, what_was_written_is_a_set_up_that_reads_the_same, ()) {
  const int channel = *rc::gen::inRange(1, 3);
  ParameterStore p = store(any_set_up(), channel);
  for (int n = *rc::gen::inRange(0, 12); n > 0; --n) (void)p.write(any_block());
  const ParameterStore next = store(p.written(), channel);
  RC_ASSERT(next.error().empty());
  RC_ASSERT(reads_the_same(p, next));
}

RC_GTEST_PROP(parameter_properties, a_block_taken_back_leaves_no_trace, ()) {
  ParameterStore p = store(any_set_up());
  for (int n = *rc::gen::inRange(0, 6); n > 0; --n) (void)p.write(any_block());
  const ParameterStore before = p;
  Journal journal;
  p.keep_in(journal);
  journal.begin();
  for (int n = *rc::gen::inRange(0, 12); n > 0; --n) (void)p.write(any_block());
  journal.undo();
  RC_ASSERT(reads_the_same(p, before));
  RC_ASSERT(p.written() == before.written());
}

}  // namespace
}  // namespace kadr::macro_b::parameters_test
