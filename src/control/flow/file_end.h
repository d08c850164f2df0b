#pragma once
// Detects a file that was cut off before its end.

namespace kadr {

class ProgramFile;

/// Returns true if the file starts with a line of % and no other such line closes it: ISO 6983 and
/// RS274/NGC have both or none. For controls that ignore this sign (Mach3, NCT) and do not require
/// M2 (nct 14.4); a program from a CAM system ends like this if its transfer was interrupted.
bool lacks_closing_sign(const ProgramFile& file);

}  // namespace kadr
