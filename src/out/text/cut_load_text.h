#pragma once
// Describes how much material each block removes: sentences for the summary, keys for the JSON, and a CSV table with one row per block.
// This file is used by out/text/cut_text and cli/cut.

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "config/alarm_texts.h"
#include "stock/cut_result.h"

namespace kadr {

/// Returns the location of a block in words, e.g. "line 12 of sub.nc N110". `program`: as in BlockLoad.
std::string line_words(const Origin& origin, const std::string& program, Lang lang);

/// Adds the key `line`. Also adds `program` if the block is not in the main program, and `block` if the block has a number.
void add_place(nlohmann::ordered_json& json, const Origin& origin, const std::string& program);

/// Returns the calls that lead to the block, e.g. [{"line":4,"block":"N10","program":"O100"}]. The outermost call comes first.
nlohmann::ordered_json calls_json(const std::vector<AlarmReport::Call>& calls);

/// Returns the sentence about one of the blocks with the highest removal rate. The second function returns the sentence about a line that
/// spends time in the air.
std::string load_words(const BlockLoad& load, Lang lang);
std::string air_words(const AirCut& air, Lang lang);

/// Adds the keys `heaviest` and `emptiest`. The value null stands for an unknown value.
void add_loads(nlohmann::ordered_json& json, const CutResult& result);

/// Returns the first line of the CSV table, with the names of the columns. The second function returns the line of one block, in which the
/// cell of an unknown value is empty.
std::string blocks_heading();
std::string blocks_row(const BlockLoad& load);

}  // namespace kadr
