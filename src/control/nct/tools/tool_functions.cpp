// Executes T and M6, and reads the data lines of tools between G10 and G11 (spec/nct/12).

#include "control/fanuc/lathe/lathe.h"
#include "control/functions/functions.h"
#include "control/nct/nct.h"

namespace kadr {
namespace {

ToolPlace place_of(const nct::ToolCall& call) {
  return {static_cast<std::uint32_t>(call.data), static_cast<std::uint32_t>(call.magazine), static_cast<std::uint32_t>(call.pocket)};
}

/// Changes the tool: the prepared tool goes into the spindle.
void change(Emitter& m, nct::CountUse count) {
  macro_b_of(m).endless.note_change();
  // the next pass of the program may differ from this pass, because the life of a tool may end
  m.pass_varies = m.pass_varies || nct_of(m).tools.enabled();
  const nct::ToolCall now = nct_of(m).tools.change(nct_of(m).spindle_magazine(), count);
  m.modal.tool = now.tool;
  m.use.change_to(now.tool);
  m.emit(ToolChange{now.tool, place_of(now)});
}

}  // namespace

namespace functions {

/// T: finds the tool and prepares it. On a machine that changes tools on T, the tool is changed too (12.1, 12.2).
Status tool_call(Emitter& m, const Call& call) {
  if (m.def.behaviour.lathe != Lathe::none) return fanuc::turret(m, call);
  nct::Nct& nct = nct_of(m);
  const auto number = m.whole('T', 0, 99'999'999);
  if (!number) return fail(number.error());
  bool by_place = false;
  for (std::uint32_t i = 0; i < m.block->word_count; ++i) {
    const Word& w = m.block->words[i];
    by_place = by_place || (w.address == 'M' && nct.settings.place_code != 0 && w.code == nct.settings.place_code * 10);
  }
  auto called = nct.tools.call(*number, by_place ? nct::CallBy::place : nct::CallBy::type, nct.spindle_magazine());
  if (!called) {
    Alarm placed = called.error();
    placed.where = call.where;
    return fail(placed);
  }
  m.modal.tool_selected = *number;
  if (*number != 0) m.use.note(UseKind::tool, *number, m.origin);
  m.emit(ToolSelect{*number, 0, place_of(*called)});
  // 12.2, case A: on a machine with a turret, or with manual tool change, T itself changes the tool
  if (nct.settings.life_counts_on_t) change(m, nct::CountUse::yes);
  return {};
}

/// M6: changes the tool: the prepared tool goes into the spindle (12.2).
Status exchange_tool(Emitter& m, const Call&) {
  change(m, nct_of(m).settings.life_counts_on_t ? nct::CountUse::no : nct::CountUse::yes);
  return {};
}

}  // namespace functions

namespace nct {

/// Returns the offset number that a word H or D means. A word with the value of N2923 means the offset number of the tool in the spindle
/// (12.5.1).
Result<std::uint32_t> Nct::offset_meant(char letter, std::uint32_t number) const {
  const int by_tool = settings.offset_by_tool;
  if (by_tool == 0 || number != static_cast<std::uint32_t>(by_tool)) return number;
  const OffsetNumbers numbers = tools.offset_numbers(spindle_magazine());
  return static_cast<std::uint32_t>(letter == 'H' ? numbers.h : numbers.d);
}

Status Nct::open_tool_data(BlockContext& m, std::uint32_t l, double p, Span where) {
  if (!m.has('P')) return fail(alarm(AlarmId::word_missing, where, 'P', "G10"));
  const auto kind = data_kind(l, p);
  if (!kind) return fail(alarm(AlarmId::value_out_of_range, m.has('P') ? m.where('P') : where, 'P', p));
  data_input.begin(*kind);
  MacroB::state.data_mode = DataMode::tools;
  return {};
}

/// Reads a data line of G10 L75 to L77, in which N is data, not a block number.
Status Nct::tool_line(Emitter& m) {
  std::vector<DataWord> words;
  if (m.block->has_number) words.push_back({'N', double(m.block->number), {}, m.block->number_where});
  for (std::uint32_t i = 0; i < m.block->word_count; ++i) {
    const Word& w = m.block->words[i];
    if (w.address == 0) continue;
    std::string_view digits = m.block->text_of(w.where);
    digits.remove_prefix(std::min<std::size_t>(1, digits.size()));
    words.push_back({w.written, w.value, w.expression ? std::string_view() : digits, w.where});
  }
  KADR_TRY(data_input.block({words, m.block->where}, tools));
  watch_tool_time(m);
  return {};
}

}  // namespace nct
}  // namespace kadr
