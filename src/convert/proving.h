#pragma once
// Proving: compares a converted text, run by the target control, with the source program, run by its own control. It compares them from the
// given set-up, from states with values that the set-up does not state (convert/open_states), and with a probe that touches at another
// point. A conversion is proven if both programs do the same in all these runs.

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "compare/comparison.h"
#include "convert/conversion.h"
#include "convert/open_states.h"

namespace kadr {

class Proving {
 public:
  ///   opened  a session that has opened the source program and has not run it yet
  Proving(const ConversionSpec& spec, const Session& opened, const ProgramShape& shape, CompareRules rules);

  /// Returns the set-up of the target control with which it begins to run a text that this conversion method has produced.
  const Setup& setup_of(ConvertedAs as) const { return as == ConvertedAs::plain ? plain_setup_ : setup_; }

  ///   returns  an error sentence if a session could not be opened
  tl::expected<Comparison, std::string> from_given(const std::shared_ptr<ByteSource>& text, ConvertedAs as, bool messages = true) const;

  struct Other {
    Comparison proof;
    // true if the two programs differ when they begin in some other state, although the source program reaches its end from that state
    bool differs = false;
    // true if the other state differs from the given set-up in the surface that a probe touches, not in a table value
    bool is_elsewhere = false;
    // true if the programs are compared with the origin that the operator sets, because at most one control has a code for it
    bool by_operator = false;
    std::size_t proven = 0;  // number of states in which the source program ends in the same way as from the given set-up
  };
  /// Compares both programs from each of the other states until they differ. A state in which the source program itself stops proves
  /// nothing, so it is not counted.
  ///   counts_from  for a text with all offsets applied: the work system that the words of the text use
  tl::expected<Other, std::string> from_others(const std::shared_ptr<ByteSource>& text, ConvertedAs as,
                                               std::optional<std::uint16_t> counts_from) const;

  /// Set-ups of the source program for the other states. They are used when lines are expanded, because expanded coordinates must not
  /// depend on the given set-up.
  const std::vector<Setup>& witnesses() const { return witnesses_; }
  bool probes() const { return elsewhere_.has_value(); }

 private:
  /// The source of the work system's origin. A control without work offsets, or with none in force, uses the origin that the operator has
  /// set.
  enum class Zero : std::uint8_t { by_tables, at_power_on, of_system };
  using Axes = std::map<std::string, double>;
  struct Side {
    Setup source, target;
    Axes zero{};  // work origin in mm that the operator sets, by axis; the comparison receives it as CompareRules::zero_of_b
    bool is_elsewhere = false;
  };
  tl::expected<Side, std::string> side_of(const OpenState& state, const std::shared_ptr<ByteSource>& text, ConvertedAs as, Zero zero,
                                          std::optional<std::uint16_t> counts_from) const;
  tl::expected<Other, std::string> in_all(const std::vector<Side>& sides, const std::shared_ptr<ByteSource>& text) const;
  tl::expected<Comparison, std::string> compare(const Side& side, const std::shared_ptr<ByteSource>& text, bool messages) const;

  const ConversionSpec& spec_;
  const ControlDef& from_;
  const ProgramNames& names_;
  CompareRules rules_;
  Setup given_, setup_, plain_setup_;
  std::vector<OpenState> states_;
  std::optional<Setup> elsewhere_;
  std::vector<Setup> witnesses_;
};

}  // namespace kadr
