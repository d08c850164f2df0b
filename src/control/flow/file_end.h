#pragma once
// Detects a file whose end is missing.

namespace kadr {

class ProgramFile;

/// Returns true if the file starts with a line that has only the sign %, and has no second such line. By ISO 6983 and RS274/NGC a file has
/// both lines or none. A file from a CAM system has only the first one if its transfer was interrupted. For controls that ignore % (Mach3,
/// NCT) and do not require M2 (nct 14.4).
bool lacks_closing_sign(const ProgramFile& file);

}  // namespace kadr
