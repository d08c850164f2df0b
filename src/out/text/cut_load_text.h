#pragma once
// Describes how much material each block removes: sentences of the summary, keys of the JSON, and a CSV table with one row per block.
// Used by out/text/cut_text and cli/cut.

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "config/alarm_texts.h"
#include "stock/cut_result.h"

namespace kadr {

/// Returns "line 12 of sub.nc N110"; `program` as in BlockLoad.
std::string line_words(const Origin& origin, const std::string& program, Lang lang);

/// Adds the key `line`; also `program` if the block is not in the main program, and `block` if the block has a number.
void add_place(nlohmann::ordered_json& json, const Origin& origin, const std::string& program);

/// Returns the calls that lead to the block, outermost first: [{"line":4,"block":"N10","program":"O100"}].
nlohmann::ordered_json calls_json(const std::vector<AlarmReport::Call>& calls);

/// The sentence for one of the blocks that remove most per second, and for one of those that remove least.
std::string load_words(const BlockLoad& load, Lang lang);
std::string air_words(const AirCut& air, Lang lang);

/// Adds the keys `heaviest` and `emptiest`. An unknown value is null.
void add_loads(nlohmann::ordered_json& json, const CutResult& result);

/// Return CSV text: the heading with the column names, and the row of one block. The cell of an unknown value is empty.
std::string blocks_heading();
std::string blocks_row(const BlockLoad& load);

}  // namespace kadr
