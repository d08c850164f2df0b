#pragma once
// Proving: a text for another control beside the program that it is made of, each run by its own control. From the set-up that is given,
// then from states that it leaves open (convert/open_states), and with what a probe touches at another place: a conversion must hold in all
// of them.

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
  ///   opened  a session of the program; it is not run
  Proving(const ConversionSpec& spec, const Session& opened, const ProgramShape& shape, CompareRules rules);

  /// Of the other control, from which the text begins.
  const Setup& setup_of(ConvertedAs as) const { return as == ConvertedAs::plain ? plain_setup_ : setup_; }

  ///   returns  an error sentence: a session could not be opened
  tl::expected<Comparison, std::string> from_given(const std::shared_ptr<ByteSource>& text, ConvertedAs as, bool messages = true) const;

  struct Other {
    Comparison proof;
    bool differs = false;       // there, and the program itself goes on there
    bool is_elsewhere = false;  // it is what a probe touches that differs, no table
    bool by_operator = false;   // equal where the operator sets the zero of the part on either machine, with codes on one of them or none
    std::size_t told = 0;       // states in which the program came to its end as it does from the given one
  };
  /// From each other state, until it differs in one. A state in which the program itself stops tells nothing.
  ///   counts_from  of a text with all offsets calculated in: the work system that its words count from
  tl::expected<Other, std::string> from_others(const std::shared_ptr<ByteSource>& text, ConvertedAs as,
                                               std::optional<std::uint16_t> counts_from) const;

  /// Set-ups of the program that stand for the others when lines are written out: what must not depend on figures of the given one.
  const std::vector<Setup>& witnesses() const { return witnesses_; }
  bool probes() const { return elsewhere_.has_value(); }

 private:
  /// Where both count from: a control without work zeros, or with none in force, counts from where the operator has set the zero.
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
