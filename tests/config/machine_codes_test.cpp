// config/machine/machine_codes: converts M functions between two controls by the tables [convert] of their files.

#include "config/machine/machine_codes.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "config/control/control_file.h"
#include "own_place.h"

namespace kadr::machine_codes_test {
namespace {

/// Loads a user's control that extends another one and has a table [convert].
ControlDef own(const std::string& id, const std::string& base, const std::string& table) {
  const std::string file = own_place("machine_codes_" + id + ".toml").string();
  std::ofstream(file) << "id = \"" << id << "\"\nname = { en = \"x\", ru = \"x\" }\nextends = \"" << base << "\"\n[convert]\n" << table;
  auto def = load_control(file);
  std::filesystem::remove(file);
  return std::move(def).value();
}

TEST(MachineCodes, WithoutTablesNothingIsSaid) {
  const MachineCodes codes(load_control("haas").value(), load_control("nct").value());
  EXPECT_TRUE(codes.pairs().empty());
  EXPECT_FALSE(codes.there(8));
}

TEST(MachineCodes, BothWays) {
  const ControlDef mine = own("mine", "haas", "M88 = \"M8\"\nM89 = \"M9\"\n"), nct = load_control("nct").value();
  const MachineCodes there(mine, nct), back(nct, mine);
  EXPECT_EQ(there.there(88), 8U);
  EXPECT_EQ(there.here(9), 89U);
  EXPECT_EQ(back.there(8), 88U);
  EXPECT_EQ(back.here(88), 8U);
  EXPECT_FALSE(there.fault());
}

TEST(MachineCodes, ARowForThatControlComesBeforeThoseForAll) {
  const ControlDef mine = own("mine", "haas", "M88 = { fanuc = \"M8\", haas = \"M31\", \"*\" = \"M7\" }\n");
  EXPECT_EQ(MachineCodes(mine, load_control("haas").value()).there(88), 31U);
  EXPECT_EQ(MachineCodes(mine, load_control("fanuc").value()).there(88), 8U);
  EXPECT_EQ(MachineCodes(mine, load_control("nct").value()).there(88), 7U);
  EXPECT_EQ(MachineCodes(mine, own("other", "fanuc", "")).there(88), 8U) << "it extends fanuc";
  EXPECT_EQ(MachineCodes(mine, own("third", "haas", "")).there(88), 31U) << "nearer than fanuc, which haas extends";
}

TEST(MachineCodes, BothHaveTables) {
  const ControlDef mine = own("mine", "haas", "M88 = { other = \"M27\" }\n"),
                   other = own("other", "haas", "M27 = { mine = \"M51\" }\nM28 = { mine = \"M52\" }\n");
  const MachineCodes codes(mine, other);
  EXPECT_EQ(codes.there(88), 27U) << "that of the first";
  EXPECT_FALSE(codes.there(51));
  EXPECT_EQ(codes.there(52), 28U);
}

TEST(MachineCodes, ACodeThatIsNoneOfTheMachine) {
  const ControlDef mine = own("mine", "haas", "M88 = { fanuc = \"M30\" }\nM27 = \"M3\"\n");
  const MachineCodes codes(mine, load_control("fanuc").value());
  ASSERT_TRUE(codes.fault());
  EXPECT_EQ(codes.fault()->code, 88U);
  EXPECT_EQ(codes.fault()->there, 30U);
  EXPECT_FALSE(MachineCodes(mine, load_control("grbl").value()).fault()) << "not every control has what stands for all";
}

}  // namespace
}  // namespace kadr::machine_codes_test
