#pragma once
// BlockStyle: how a program writes its blocks, so that new blocks look the same: with numbers or without, with a blank after the number,
// with the mark ПС or LF at the end.

#include <memory>
#include <optional>
#include <string>

#include "base/stop_token.h"
#include "config/control/control_def.h"
#include "lang/block/block_reader.h"

namespace kadr {

class BlockStyle {
 public:
  /// Reads the program once.
  ///   def    must outlive this object
  ///   after  line (from 1) that the new blocks follow, 0: the beginning. Their numbers lie between those of the blocks around them as long
  ///          as there are such numbers. nullopt: all of them are above the greatest number of the program
  static BlockStyle of(const std::shared_ptr<ByteSource>& source, std::optional<Encoding> encoding, const ControlDef& def,
                       std::optional<std::uint32_t> after, const StopToken& stop);

  /// Returns the words as a block of the program, with the next number.
  std::string block(const std::string& words);
  /// Returns the next number with its letter, N120; empty if the program has no numbers, or if no number fits.
  std::string next_number();

  /// Returns the mark at the end of the block with the blanks before it, " ПС"; empty if it has none, or if a comment is before it.
  static std::string ending_of(const Block& block);

 private:
  void take(const Block& block);

  const ControlDef* def_ = nullptr;
  std::optional<std::uint32_t> after_;
  std::string ending_, gap_ = " ";
  std::size_t blocks_ = 0, numbered_ = 0;
  std::size_t digits_ = 1;                     // least number of digits of a block number
  std::optional<std::uint32_t> first_, step_;  // step_: from the first number to the next one
  std::uint32_t greatest_ = 0;
  std::uint32_t last_ = 0;               // number before the next one that is free
  std::optional<std::uint32_t> before_;  // number of the first block behind the new ones
};

}  // namespace kadr
