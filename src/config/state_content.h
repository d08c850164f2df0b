#pragma once
// Reads a state file with its checksums: the valid rows, and all faults. Only state_*.cpp use it.
//
// Each row has a checksum of its contents (kind, key, type, value) and of the state of the whole file when the row was written: the turn
// (each write of a row is a turn), the number of rows, and the sum of the checksums of all values plus one of the control's name. So the
// row of the latest turn describes the whole file: an added or missing row is detected, and also a file mixed from two. A save of one row
// writes a single page. Turns that change the number of rows (new file, new row, removed row) are also recorded as `whole` in the table
// about, a turn without a row. The checksum is FNV-1a with 64 bits: it certainly differs for two rows that differ in one byte, because
// each of its steps is invertible.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "config/state_base.h"
#include "config/state_file.h"

namespace kadr::state {

/// Returns the checksum of kind, key and value only.
std::uint64_t sum_of_row(std::string_view kind, std::string_view key, const StateValue& value);

/// The totals of the whole file, updated row by row.
struct Whole {
  std::uint64_t turn = 0;
  std::uint64_t rows = 0;
  std::uint64_t sum = 0;
  static Whole of_control(std::string_view control);
  void add(std::uint64_t row) { ++rows, sum += row; }
  void take(std::uint64_t row) { --rows, sum -= row; }
  /// Returns the checksum of a row, given the checksum of its value; for 0, the checksum of `whole` itself.
  std::uint64_t sealed(std::uint64_t row) const;
  std::string text() const;  // format: "turn rows sum seal"
  static std::optional<Whole> parsed(const std::string& text);
};

struct Content {
  std::string control;              // empty if it cannot be read
  bool checked = true;              // written with checksums; false: by an older Kadr
  bool ours = true;                 // has our tables or our mark
  std::vector<StateRow> rows;       // sorted; only valid rows
  std::vector<std::uint64_t> sums;  // checksums of the rows
  std::vector<std::string> faults;  // in words; empty: the file is valid
  Whole whole;                      // totals of a valid file with checksums
};

/// Reads everything readable; the file is not changed.
Content read_content(const Base& base);

/// Returns a message if the file is of a newer version than this program can read; else empty.
std::string told_newer(const Base& base, const std::string& name);

/// Returns the name of a row for people: "work_offsets G54/X".
std::string name_of_row(std::string_view kind, std::string_view key);

}  // namespace kadr::state
