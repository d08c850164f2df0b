#pragma once
// Reads format descriptors, such as `%: / DS N04 3G2 X+053 Y+053 Z+042 F031 S04 T05 M2*` (spec/gost 3, spec/s2c42 2).

#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "lang/block/grammar.h"

namespace kadr {

/// Sets in `grammar` what a descriptor defines: known addresses, digits, signs, counts, '%', ':', '/', the end of block. All other members
/// keep their values. A space separates a count of words from the digits before it: `N04 3G2` allows three G words.
///   returns  an error sentence that names the part of the descriptor that is not understood
tl::expected<void, std::string> apply_descriptor(std::string_view descriptor, Grammar& grammar);

/// Parses the format of one address: "+053", "04", "2", "031", "*2". `point`: the descriptor contains DS, so a decimal point is allowed.
tl::expected<WordFormat, std::string> parse_word_format(std::string_view digits, bool point);

}  // namespace kadr
