#pragma once
// What a state file holds, read with its checksums: the good rows, and each thing that is wrong. Only state_*.cpp use it.
//
// Each row has the checksum of all that it holds: kind, key, type, value, and what the whole was when it was written: the turn (each
// write of a row is one), the number of rows, the sum of the checksums of their values on top of one of the control's name. The row of
// the last turn thus tells the whole as it must be: a row more or less is found, and a file made of two. A save of one row
// so writes one page. `whole` of the table about is such a turn without a row, where their number changes: of a new file, a new row, one
// that was removed. The checksum is FNV-1a with 64 bits: of two rows that differ in one byte it differs for certain, as each of its steps
// can be undone.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "config/state_base.h"
#include "config/state_file.h"

namespace kadr::state {

/// Of kind, key and value alone.
std::uint64_t sum_of_row(std::string_view kind, std::string_view key, const StateValue& value);

/// The whole, kept up to date row by row.
struct Whole {
  std::uint64_t turn = 0;
  std::uint64_t rows = 0;
  std::uint64_t sum = 0;
  static Whole of_control(std::string_view control);
  void add(std::uint64_t row) { ++rows, sum += row; }
  void take(std::uint64_t row) { --rows, sum -= row; }
  /// The checksum of a row with that of its value, or of `whole` itself.
  std::uint64_t sealed(std::uint64_t row) const;
  std::string text() const;  // "turn rows sum seal"
  static std::optional<Whole> parsed(const std::string& text);
};

struct Content {
  std::string control;              // empty: it cannot be read
  bool checked = true;              // written with checksums; false: by an older Kadr
  bool ours = true;                 // has our tables or our mark
  std::vector<StateRow> rows;       // in order; only good ones
  std::vector<std::uint64_t> sums;  // of them
  std::vector<std::string> faults;  // told; none: the file is sound
  Whole whole;                      // of a sound file with checksums: as it is
};

/// Reads all that can be read; the file stays as it is.
Content read_content(const Base& base);

/// Of a newer version than can be read: its sentence; empty: not.
std::string told_newer(const Base& base, const std::string& name);

/// "work_offsets G54/X", as a row is named to people.
std::string name_of_row(std::string_view kind, std::string_view key);

}  // namespace kadr::state
