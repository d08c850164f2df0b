#pragma once
// Random tables of a control, for the properties of state_json and of the state file.

#include <rapidcheck.h>

#include "config/setup/setup.h"

namespace kadr::test {

inline double any_number() { return *rc::gen::inRange(-1'000'000'000, 1'000'000'000) / 977.0; }
inline double any_count() { return *rc::gen::inRange(0, 100'000'000); }
inline int any_row() { return *rc::gen::inRange(1, 1000); }
inline std::size_t few() { return *rc::gen::inRange<std::size_t>(0, 4); }
inline std::string any_axis() { return *rc::gen::element<std::string>("X", "Y", "Z", "C", "XDE"); }

inline AxisValues any_axes() {
  AxisValues axes;
  for (std::size_t n = few(); n > 0; --n) axes[*rc::gen::element<std::string>("X", "Z", "C", "G17")] = 0.125 + any_count() / 100;
  return axes;
}

inline ToolRow any_tool() {
  ToolRow row;
  row.type = any_count();
  row.info = *rc::gen::element(0U, 1U, 17U, 29U, 31U, 32U, UINT32_MAX);
  row.form = 3;
  row.status = *rc::gen::inRange(0U, 5U);
  row.counter = any_count();
  row.life = any_number();
  row.h = any_count();
  row.w = any_count();
  row.s = any_number();
  row.f = any_number();
  row.user_bits = *rc::gen::inRange(0U, 256U);
  if (*rc::gen::arbitrary<bool>()) row.user[*rc::gen::inRange<std::size_t>(0, row.user.size())] = any_number();
  return row;
}

inline ParameterKey any_parameter() {
  return {*rc::gen::element<std::string>("0107", "1339", "CLRG"), *rc::gen::element<std::string>("", "4", "X"),
          *rc::gen::element<std::string>("", "0", "CLR")};
}

/// Returns random offsets, work offsets, parameters, tool, place and form tables, and variables.
inline Setup any_tables() {
  Setup s;
  for (std::size_t n = few(); n > 0; --n)
    s.offsets[any_row()] = {any_number(), any_number(), 0, any_number(), 0.5, 0, 0, any_number(), 0, 0, 3};
  for (std::size_t n = few(); n > 0; --n) s.work_offsets[*rc::gen::element<std::string>("common", "G54", "G54.1 P2")] = any_axes();
  for (std::size_t n = few(); n > 0; --n)
    s.parameters[any_parameter()] = *rc::gen::arbitrary<bool>() ? ParameterValue(any_number()) : ParameterValue(any_axis());
  for (std::size_t n = few(); n > 0; --n) s.tool_table[any_row()] = any_tool();
  for (std::size_t n = few(); n > 0; --n) s.place_table[{any_row(), any_row()}] = *rc::gen::inRange(0, 10);
  for (std::size_t n = few(); n > 0; --n) s.form_table[any_row()] = {any_count(), 1, 0, any_count(), 1};
  return s;
}

}  // namespace kadr::test
