// Compares a converted text with its source program. Used by convert/conversion and convert/word_by_word; tested by tests/convert.py and
// tests/convert_open.py.

#include "convert/proving.h"

#include <utility>

#include "convert/source_setup.h"

namespace kadr {
namespace {

constexpr int other_states = 3;

void add_origin(std::map<std::string, double>& to, const Control& control, int sign) {
  const std::vector<std::string>& axes = control.axes();
  for (std::size_t a = 0; a < axes.size() && a < max_axes; ++a) to[axes[a]] += sign * control.placement().origin[a];
}

}  // namespace

Proving::Proving(const ConversionSpec& spec, const Session& opened, const ProgramShape& shape, CompareRules rules)
    : spec_(spec),
      from_(opened.def()),
      names_(shape.names()),
      rules_(std::move(rules)),
      given_(opened.setup()),
      setup_(corresponding_setup(given_, from_, *spec.to, names_, false)),
      plain_setup_(corresponding_setup(given_, from_, *spec.to, names_, true)),
      states_(open_states(given_, from_, *spec.to, opened.control().axes(), names_, other_states)) {
  if (Setup elsewhere = given_; probe_elsewhere(elsewhere)) elsewhere_ = std::move(elsewhere);
  witnesses_.push_back(states_.front().setup);
  if (elsewhere_) witnesses_.push_back(*elsewhere_);
}

tl::expected<Proving::Side, std::string> Proving::side_of(const OpenState& state, const std::shared_ptr<ByteSource>& text, ConvertedAs as,
                                                          Zero zero, std::optional<std::uint16_t> counts_from) const {
  Side side;
  side.source = state.setup;
  side.target = corresponding_setup(state.setup, from_, *spec_.to, names_, as == ConvertedAs::plain);
  if (zero == Zero::by_tables) return side;
  if (zero == Zero::of_system) {
    if (const auto found = state.zeros.find(*counts_from); found != state.zeros.end()) side.zero = found->second;
  } else {
    const auto a = spec_.source(side.source);
    if (!a) return tl::unexpected(a.error());
    const auto b = spec_.target(text, side.target);
    if (!b) return tl::unexpected(b.error());
    add_origin(side.zero, (*a)->control(), 1);
    add_origin(side.zero, (*b)->control(), -1);
  }
  if (!side.target.start_in_work)
    for (const auto& [axis, value] : side.zero)
      if (value != 0) side.target.start[axis] -= value;
  return side;
}

tl::expected<Comparison, std::string> Proving::compare(const Side& side, const std::shared_ptr<ByteSource>& text, bool messages) const {
  auto a = spec_.source(side.source);
  if (!a) return tl::unexpected(a.error());
  auto b = spec_.target(text, side.target);
  if (!b) return tl::unexpected(b.error());
  CompareRules rules = rules_;
  rules.messages = rules.messages && messages;
  rules.zero_of_b = side.zero;
  return compare_sessions(std::move(*a), std::move(*b), rules);
}

tl::expected<Comparison, std::string> Proving::from_given(const std::shared_ptr<ByteSource>& text, ConvertedAs as, bool messages) const {
  return compare({given_, setup_of(as), {}, false}, text, messages);
}

tl::expected<Proving::Other, std::string> Proving::in_all(const std::vector<Side>& sides, const std::shared_ptr<ByteSource>& text) const {
  Other other;
  for (const Side& side : sides) {
    if (spec_.stop.requested()) break;
    auto proof = compare(side, text, true);
    if (!proof) return tl::unexpected(proof.error());
    if (proof->stopped_a) continue;
    ++other.proven;
    if (proof->equal() && !proof->stopped_b) continue;
    other.proof = std::move(*proof), other.differs = true, other.is_elsewhere = side.is_elsewhere;
    break;
  }
  return other;
}

tl::expected<Proving::Other, std::string> Proving::from_others(const std::shared_ptr<ByteSource>& text, ConvertedAs as,
                                                               std::optional<std::uint16_t> counts_from) const {
  // The result to return if the programs differ with every source of the origin (enum Zero): that of Zero::of_system if it was tried, else
  // the first one.
  std::optional<Other> first;
  for (const Zero zero : {Zero::by_tables, Zero::at_power_on, Zero::of_system}) {
    if (zero == Zero::of_system && (as != ConvertedAs::plain || !counts_from)) continue;
    std::vector<Side> sides;
    if (elsewhere_) {
      Side side{*elsewhere_, setup_of(as), {}, true};
      probe_elsewhere(side.target);
      sides.push_back(std::move(side));
    }
    bool is_shifted = false;
    for (const OpenState& state : states_) {
      auto side = side_of(state, text, as, zero, counts_from);
      if (!side) return tl::unexpected(side.error());
      for (const auto& [axis, value] : side->zero) is_shifted = is_shifted || value != 0;
      sides.push_back(std::move(*side));
    }
    if (zero != Zero::by_tables && !is_shifted) continue;
    auto other = in_all(sides, text);
    if (!other) return other;
    other->by_operator = zero != Zero::by_tables;
    if (!other->differs || other->is_elsewhere) return other;
    if (!first || zero == Zero::of_system) first = std::move(*other);
  }
  return std::move(*first);
}

}  // namespace kadr
