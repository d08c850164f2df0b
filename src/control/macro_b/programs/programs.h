#pragma once
// Finds programs by number and by name in the program memory, which consists of folders on the disk (spec/nct/14 14.4.1, 14.4.2; 23 23.3).

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"
#include "lang/block/block.h"

namespace kadr {
class Interpreter;
}

namespace kadr::macro_b {

/// The location at which a called program starts: the number of the open file, and the position of the program in that file.
struct ProgramLocation {
  std::uint16_t reader = 0;
  Position start;
};

/// The folder in which a called program is searched: the folder of the calling program, or the folder of the main program.
enum class NextTo : std::uint8_t { caller, main_program };

/// Finds called programs and records their locations, so that each program is searched only once.
class Programs {
 public:
  /// Finds the program that M98 P, G65 P … call by number. First it tries a file `Onnnn` or `Onnnnnnnn` with the caller's extension in the
  /// caller's folder (14.4.2). INFERRED: the program that starts with `Onnnn` in the main file itself comes second (a tape with several
  /// programs). Our choice, for files of other workshops, is to try next: a file whose name is the number in another form (not .nct, .prg),
  /// in the caller's folder or in the folder of --files; the control's built-in program; a file that starts with `O` or `:` and the number.
  ///   alarms  program_missing (2147), label_twice, file_outside, file_missing
  Result<ProgramLocation> by_number(Interpreter& m, std::uint32_t number, Span where, NextTo next_to = NextTo::caller);
  /// Finds the program that M98 <path\\name.ext> calls. The path is relative to the caller's folder. The file must be inside the main
  /// program's folder or the folder of --files.
  ///   alarms  file_missing (2132), file_name, file_outside
  Result<ProgramLocation> by_name(Interpreter& m, std::string_view name, Span where, NextTo next_to = NextTo::caller);
  /// Finds a system macro or subprogram: SystemMacros/Channel1/Onnnn.nct (23.3). alarms program_missing
  Result<ProgramLocation> system(Interpreter& m, std::uint32_t number, Span where);

 private:
  /// Searches for the program in the order that spec/fanuc 9.2 describes (program_search.cpp). alarms program_missing, programs_alike,
  /// file_outside, file_missing
  Result<ProgramLocation> by_steps(Interpreter& m, std::uint32_t number, Span where);
  static Result<std::optional<ProgramLocation>> in_own_file(Interpreter& m, std::uint32_t number, Span where);
  /// Finds a file in which the program starts with the word <name>.
  static Result<std::optional<ProgramLocation>> by_heading(Interpreter& m, std::string_view name, Span where);
  /// Opens a file of the program memory. alarms file_outside, file_missing
  static Result<ProgramLocation> opened(Interpreter& m, const std::string& path, Span where);

  // the programs that were found, by {calling file, program number}
  std::map<std::pair<std::uint32_t, std::uint32_t>, ProgramLocation> numbers_;
  std::map<std::uint32_t, ProgramLocation> systems_;
};

/// Returns the name of a program: "O0012" for 12; a number above 9999 has eight digits.
std::string program_name(std::uint32_t number);
/// Returns the program number in a file name that consists of O and at most eight digits; 0 for any other name (23.1.13).
std::uint32_t number_of_file(const std::string& path);

}  // namespace kadr::macro_b
