// The nct's own block search (13.1): the last code of each of the builder's
// groups, the tool by N1338, what is forgotten, and #_BSEARCH during the search.

#include "session/block_search.h"

#include "session/a_session.h"

namespace kadr::block_search_test {
namespace {

using test::ASession;

const char* const program =
    "T5 M6\n"           // 1
    "S800 M3\n"         // 2
    "M8\n"              // 3
    "M400\n"            // 4
    "M77\n"             // 5
    "#100=#_BSEARCH\n"  // 6
    "#101=#_CNTBS\n"    // 7
    "G0 X10 Y20 Z5\n"   // 8
    "M9\n"              // 9
    "T7\n"              // 10
    "M8\n"              // 11
    "M401\n"            // 12
    "M77\n"             // 13
    "G1 X30 F100\n"     // 14
    "#102=#_BSEARCH\n"  // 15
    "M30\n";

std::string texts(const std::vector<BlockSearch::Code>& codes) {
  std::string all;
  for (const auto& code : codes) all += code.text + ":" + std::to_string(code.origin.line) + " ";
  return all;
}

std::optional<BlockSearch> searched(ASession& session, Stepping& stepping, std::uint32_t line) {
  return search_block(*session, stepping, {.line = line});
}

Setup with(const char* parameters) {
  return parse_setup(std::string(R"({"start": {"Z": 100}, "parameters": )") + parameters + "}").value();
}

TEST(block_search, of_each_group_the_last_code) {
  ASession session("nct", program, with(R"({"N1341": 8, "N1357": 9, "N1342": 400, "N1358": 401, "N1338#0": 1})"));
  Stepping stepping(*session);
  const auto search = searched(session, stepping, 14);
  ASSERT_TRUE(search);
  EXPECT_EQ(texts(search->carried_out), "M8:11 M401:12 T5 M6:1 ");
  EXPECT_EQ(texts(search->of_no_group), "M3:2 M77:13 ");
  ASSERT_EQ(search->forgotten.size(), 1U);  // M3 belongs to no group
  EXPECT_EQ(search->forgotten[0].code, "M3");
  EXPECT_EQ(search->restart.at.line, 14U);
  EXPECT_EQ(search->restart.stand.work[0], 10);
  EXPECT_TRUE(session.trace().empty());  // no action is passed on
  // #_BSEARCH is 1 during the search and 0 afterwards; the program continues as it would have.
  EXPECT_EQ(stepping.value("#100").value(), 1);
  EXPECT_EQ(stepping.value("#101").value(), 1);
  EXPECT_EQ(stepping.go(Stepping::How::free), Session::State::ended);
  EXPECT_EQ(session->control().evaluate("#102").value(), 0);
  EXPECT_NE(session.trace().find("\"X\":30"), std::string::npos);
}

TEST(block_search, the_tool_is_changed_on_t_by_default) {
  ASession session("nct", program, with(R"({"N1341": 3, "N1357": 5, "N1342": 7, "N1358": 9})"));
  Stepping stepping(*session);
  const auto search = searched(session, stepping, 14);
  ASSERT_TRUE(search);
  EXPECT_EQ(texts(search->carried_out), "M3:2 M8:11 T7:10 ");
  EXPECT_EQ(texts(search->of_no_group), "M400:4 M401:12 M77:13 ");
  EXPECT_TRUE(search->forgotten.empty());
}

TEST(block_search, without_groups_it_brings_no_code) {
  ASession session("nct", program, with("{}"));
  Stepping stepping(*session);
  const auto search = searched(session, stepping, 9);
  ASSERT_TRUE(search);
  EXPECT_EQ(texts(search->carried_out), "T5:1 ");
  EXPECT_EQ(search->forgotten.size(), 2U);  // M3, M8
}

TEST(block_search, not_reached_or_not_known) {
  ASession session("nct", program, with("{}"));
  Stepping stepping(*session);
  EXPECT_FALSE(searched(session, stepping, 99));
  ASession other("mach3", "G0 X1\nX2\nM30\n");
  Stepping there(*other);
  EXPECT_FALSE(other->control().search_rules());
  EXPECT_FALSE(searched(other, there, 2));
}

}  // namespace
}  // namespace kadr::block_search_test
