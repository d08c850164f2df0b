// AirLines: finds the lines that spend the most time moving at feed in the air. It is used by session/cutting and tested by
// tests/session/block_load_test.cpp.

#include "session/cutting/air_lines.h"

#include <algorithm>

namespace kadr {
namespace {

bool emptier(const AirCut& a, const AirCut& b) {
  if (a.seconds != b.seconds) return a.seconds > b.seconds;
  return std::pair(a.origin.file, a.origin.line) < std::pair(b.origin.file, b.origin.line);
}

}  // namespace

void AirLines::add(const Piece& piece) {
  if (piece.cuts) {
    row_.clear(), row_length_ = 0, in_air_ = false;
    return;
  }
  if (in_air_) return count(piece);
  const bool goes_on = !row_.empty() && row_.back().origin.number == piece.origin.number && row_.back().tool == piece.tool;
  if (goes_on) row_.back().seconds += piece.seconds;
  else row_.push_back(piece);
  row_length_ += piece.length;
  in_air_ = row_length_ >= reach_ || row_.size() >= most_;
  if (!in_air_) return;
  for (const Piece& p : row_) count(p);
  row_.clear(), row_length_ = 0;
}

void AirLines::count(const Piece& piece) {
  if (!(piece.seconds > 0)) return;
  const auto [line, is_new] = lines_.try_emplace({piece.origin.file, piece.origin.line}, AirCut{piece.origin, {}, piece.tool, 0});
  line->second.seconds += piece.seconds;
  if (is_new && lines_.size() > most_) drop_half();
}

void AirLines::drop_half() {
  std::vector<AirCut> all;
  for (const auto& [key, line] : lines_) all.push_back(line);
  const auto middle = all.begin() + std::ptrdiff_t(all.size() / 2);
  std::nth_element(all.begin(), middle, all.end(), emptier);
  missing_ += middle->seconds;
  for (auto line = middle; line != all.end(); ++line) lines_.erase({line->origin.file, line->origin.line});
}

std::vector<AirCut> AirLines::emptiest() const {
  std::vector<AirCut> all;
  for (const auto& [key, line] : lines_) all.push_back(line);
  std::sort(all.begin(), all.end(), emptier);
  if (all.size() > max_reported) all.resize(max_reported);
  return all;
}

}  // namespace kadr
