#pragma once
// Proving: compares a text for another control with the program that it was made from, each run by its own control: from the given set-up,
// from states that the set-up leaves open (convert/open_states), and with a probe that touches at another point. A conversion must do the
// same in all of them.

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
  ///   opened  a session of the program that is not run
  Proving(const ConversionSpec& spec, const Session& opened, const ProgramShape& shape, CompareRules rules);

  /// Returns the set-up of the other control from which the text begins.
  const Setup& setup_of(ConvertedAs as) const { return as == ConvertedAs::plain ? plain_setup_ : setup_; }

  ///   returns  an error sentence: a session could not be opened
  tl::expected<Comparison, std::string> from_given(const std::shared_ptr<ByteSource>& text, ConvertedAs as, bool messages = true) const;

  struct Other {
    Comparison proof;
    bool differs = false;       // the two differ there, and the program itself continues there
    bool is_elsewhere = false;  // the difference comes from what a probe touches, not from a table
    bool by_operator = false;   // equal if the operator sets the part's origin on both machines, with a code on one of them or none
    std::size_t told = 0;       // states in which the program reaches its end as it does from the given one
  };
  /// Compares from each other state until one differs. A state in which the program itself stops proves nothing.
  ///   counts_from  for a text with all offsets applied: the work system that its words refer to
  tl::expected<Other, std::string> from_others(const std::shared_ptr<ByteSource>& text, ConvertedAs as,
                                               std::optional<std::uint16_t> counts_from) const;

  /// Set-ups of the program that represent the other states when lines are written out: written-out figures must not depend on the given
  /// set-up.
  const std::vector<Setup>& witnesses() const { return witnesses_; }
  bool probes() const { return elsewhere_.has_value(); }

 private:
  /// Where the origin comes from: a control without work offsets, or with none in force, uses the origin that the operator has set.
  enum class Zero : std::uint8_t { by_tables, at_power_on, of_system };
  using Axes = std::map<std::string, double>;
  struct Side {
    Setup source, target;
    Axes zero{};  // CompareRules::zero_of_b
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
