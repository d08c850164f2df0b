#pragma once
// Detects a file that was cut off before its end.

namespace kadr {

class ProgramFile;

/// Returns true if the file starts with a line of % and has no second such line: by ISO 6983 and RS274/NGC a file has both or none. A file
/// from a CAM system ends like this if its transfer was interrupted. For controls that ignore % (Mach3, NCT) and do not require M2 (nct
/// 14.4).
bool lacks_closing_sign(const ProgramFile& file);

}  // namespace kadr
