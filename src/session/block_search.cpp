// BlockSearch: the control's own block search (spec/nct 13.1, 12.1, 23.1.11). It is used by the debugger, the panel and embedding programs,
// and tested by tests/session/block_search_test.cpp.

#include "session/block_search.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "action/by_kind.h"

namespace kadr {
namespace {

/// Returns the number of the M code that commanded an action; 0 if no M code commanded it, or if the control executes the M code itself.
std::uint32_t m_code_of(const Action& action) {
  constexpr std::uint32_t none = 0, of_coolant[] = {9, 7, 8};
  return by_kind(
      action, [&](const MachineFunction& function) { return function.by_control ? none : function.code; },
      [&](const CoolantSwitch& coolant) { return of_coolant[static_cast<std::size_t>(coolant.what)]; },
      [](const Spindle& spindle) -> std::uint32_t {
        switch (spindle.dir) {
          case SpindleDir::cw: return 3;
          case SpindleDir::ccw: return 4;
          case SpindleDir::stop: return 5;
          case SpindleDir::orient: return 19;
          default: return 0;
        }
      },
      same<Motion, Dwell, Speed, ToolSelect, ToolChange, AuxiliaryFunction, Stop, Message, FrameChange, SurfaceSpeed, Sync, ZoneChange,
           Couple, Uncouple, CompensationBreak, CompensationCorner, CompensationCheck>(none));
}

/// Collects the M codes and the tool change of all actions that are executed during the search.
class Collector {
 public:
  explicit Collector(const SearchRules& rules) : rules_(rules) {}

  void see(const Action& action) {
    if (const auto* const select = std::get_if<ToolSelect>(&action.what); select != nullptr && !rules_.tool_on_m6)
      tool_ = BlockSearch::Code{fmt::format("T{}", select->tool), action.origin, action};
    if (const auto* const change = std::get_if<ToolChange>(&action.what); change != nullptr && rules_.tool_on_m6)
      tool_ = BlockSearch::Code{fmt::format("T{} M6", change->tool), action.origin, action};
    const std::uint32_t code = m_code_of(action);
    if (code == 0) return;
    const auto group = std::find_if(rules_.groups.begin(), rules_.groups.end(), [&](const auto& g) {
      return static_cast<std::int64_t>(code) >= g.first && static_cast<std::int64_t>(code) <= g.second;
    });
    const bool in_group = group != rules_.groups.end();
    // A later code replaces an earlier code of the same group. Outside the groups, a later use replaces an earlier use of the same code.
    auto& list = in_group ? grouped_ : others_;
    const std::int64_t key = in_group ? group - rules_.groups.begin() : static_cast<std::int64_t>(code);
    std::erase_if(list, [&](const auto& noted) { return noted.first == key; });
    list.emplace_back(key, BlockSearch::Code{fmt::format("M{}", code), action.origin, action});
  }

  void write(BlockSearch& search) {
    for (auto& [key, code] : grouped_) search.carried_out.push_back(std::move(code));
    if (tool_) search.carried_out.push_back(std::move(*tool_));
    for (auto& [key, code] : others_) search.of_no_group.push_back(std::move(code));
  }

 private:
  using Noted = std::vector<std::pair<std::int64_t, BlockSearch::Code>>;
  const SearchRules& rules_;
  Noted grouped_, others_;
  std::optional<BlockSearch::Code> tool_;
};

/// Detaches the outlets during the search, so that only the collector receives the actions. The destructor attaches the outlets again.
class Unseen {
 public:
  Unseen(Session& session, Collector& collector) : session_(session), before_(session.outlets()) {
    Outlets& outlets = session.outlets();
    outlets.step = nullptr;
    outlets.timed = nullptr;
    outlets.warning = [](const AlarmReport&) {};
    outlets.programmed = [&collector](const Action& action) { collector.see(action); };
    session.control().set_signal("BSEARCH", 1);
  }
  ~Unseen() {
    session_.control().set_signal("BSEARCH", 0);
    session_.outlets() = std::move(before_);
  }
  Unseen(const Unseen&) = delete;
  Unseen& operator=(const Unseen&) = delete;

 private:
  Session& session_;
  Outlets before_;
};

std::vector<InForce> forgotten_of(const BlockSearch& search) {
  std::vector<InForce> forgotten;
  for (const InForce& one : search.restart.in_force) {
    if (one.kind != InForce::Kind::spindle && one.kind != InForce::Kind::coolant) continue;
    const bool brought =
        std::any_of(search.carried_out.begin(), search.carried_out.end(), [&](const auto& c) { return c.text == one.code; });
    if (!brought) forgotten.push_back(one);
  }
  return forgotten;
}

}  // namespace

std::optional<BlockSearch> search_block(Session& session, Stepping& stepping, const StopPoint& target) {
  const auto rules = session.control().search_rules();
  if (!rules) return std::nullopt;
  Collector collector(*rules);
  {
    const Unseen unseen(session, collector);
    if (stepping.go_to(target) != Session::State::held) return std::nullopt;
  }
  auto restart = restart_here(session, stepping);
  if (!restart) return std::nullopt;
  BlockSearch search{std::move(*restart), {}, {}, {}};
  collector.write(search);
  search.forgotten = forgotten_of(search);
  return search;
}

}  // namespace kadr
