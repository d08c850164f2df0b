// config/machine/rapid_path: which controls move each axis on its own at rapid, and which parameter changes that.

#include "config/machine/rapid_path.h"

#include <gtest/gtest.h>

#include "config/control/control_file.h"

namespace kadr::rapid_path_test {
namespace {

bool apart(const char* control, const char* parameter = nullptr, const char* bit = "", double value = 1) {
  const auto def = load_control(control);
  EXPECT_TRUE(def) << def.error();
  Setup setup;
  if (parameter != nullptr) setup.parameters[{parameter, "", bit}] = value;
  return rapids_apart(*def, setup, {"X", "Y", "Z"});
}

TEST(rapid_path, by_control) {
  for (const char* control : {"fanuc", "haas"}) EXPECT_TRUE(apart(control)) << control;
  for (const char* control : {"nct", "linuxcnc", "grbl", "mach3", "s2c42", "gost", "correctors"}) EXPECT_FALSE(apart(control)) << control;
}

TEST(rapid_path, by_parameter) {
  EXPECT_FALSE(apart("fanuc", "1401", "1"));
  EXPECT_FALSE(apart("fanuc", "1401", "LRP"));
  EXPECT_FALSE(apart("fanuc", "1401", "", 2));
  EXPECT_TRUE(apart("fanuc", "1401", "", 1));  // a bit that has no effect here
  EXPECT_FALSE(apart("haas", "0335"));
  EXPECT_TRUE(apart("haas", "0335", "", 0));
  EXPECT_TRUE(apart("nct", "0421", "ROL"));
  EXPECT_FALSE(apart("nct", "0421", "JRK"));
}

}  // namespace
}  // namespace kadr::rapid_path_test
