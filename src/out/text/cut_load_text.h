#pragma once
// What blocks take away, for people and programs: rows of the summary, keys of the JSON, a table with a row a block. For out/text/cut_text
// and cli/cut.

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "config/alarm_texts.h"
#include "stock/cut_result.h"

namespace kadr {

/// "line 12 of sub.nc N110": `program` as of BlockLoad.
std::string line_words(const Origin& origin, const std::string& program, Lang lang);

/// Adds `line`, `program` where it is not the program itself, `block` where it has a number.
void add_place(nlohmann::ordered_json& json, const Origin& origin, const std::string& program);

/// By which calls, outermost first: [{"line":4,"block":"N10","program":"O100"}].
nlohmann::ordered_json calls_json(const std::vector<AlarmReport::Call>& calls);

/// Of the heaviest and the emptiest lines: a text for each.
std::string load_words(const BlockLoad& load, Lang lang);
std::string air_words(const AirCut& air, Lang lang);

/// `heaviest` and `emptiest`. What is not told is null.
void add_loads(nlohmann::ordered_json& json, const CutResult& result);

/// CSV: the names of the columns, and a row of them. What is not told is empty.
std::string blocks_heading();
std::string blocks_row(const BlockLoad& load);

}  // namespace kadr
