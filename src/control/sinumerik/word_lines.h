#pragma once
// WordLines: lines of a loop that only have words (G1 X=R1*2 F100). After the first execution their words are kept; later only the values
// of their expressions are computed. Only src/control/sinumerik includes this file.

#include <array>
#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

#include "control/sinumerik/calculation.h"

namespace kadr::sinumerik {

class WordLines {
 public:
  WordLines(Sinumerik& own, Calculation& calculation) : own_(own), calculation_(calculation) {}

  /// Returns the block with the words that the line has now; nullptr if it is not kept, or if a value causes an alarm or is no number. The
  /// forms of the words are then in Sinumerik::words.
  Block* words_of(const BlockContext& m);
  /// Keeps the block that has been executed as the words `made`, if it has nothing else.
  void keep(const BlockContext& m, const NamedBlock& read, const Block& made);
  void forget_all() { lines_.clear(); }

 private:
  struct Computed {
    std::uint32_t word = 0;
    Calculation::Code value;
  };
  struct Line {
    Block block;
    std::uint64_t letters = 0;
    std::vector<Word> words;  // as they were made
    std::array<WordForm, 26> forms{};
    std::vector<Computed> values;
    std::vector<std::uint32_t> names;  // slots of the addresses; if one is a variable's name, the line assigns to it
  };
  static std::uint64_t key_of(const BlockContext& m);
  bool compile(const BlockContext& m, const NamedBlock& read, Line& line);

  static constexpr std::size_t most_lines = 4096;
  Sinumerik& own_;
  Calculation& calculation_;
  std::unordered_map<std::uint64_t, std::unique_ptr<Line>> lines_;  // by file and offset; nullptr: not only words
};

}  // namespace kadr::sinumerik
