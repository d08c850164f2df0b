#pragma once
// Whether a file was cut off before its end.

namespace kadr {

class ProgramFile;

/// It begins with a line of %, and no other such line closes it: ISO 6983 and RS274/NGC have both or none. For controls to which that sign
/// means nothing (Mach3, NCT) and M2 is not obligatory (nct 14.4); a program sent by a CAM ends so when its transfer has broken off.
bool lacks_closing_sign(const ProgramFile& file);

}  // namespace kadr
