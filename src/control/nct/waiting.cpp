// Waiting codes: the channels of a machine wait for each other at `M501 P12` (spec/nct/14 14.5). Used by the rest of control.

#include "control/nct/waiting.h"

#include <string>

#include "control/emitter.h"
#include "control/nct/nct.h"

namespace kadr::nct {
namespace {

constexpr int max_waiting_codes = 100;
constexpr const char* no_waiting_signal = "CP_NOWT";

bool is_waiting_code(const Settings& s, int code) {
  return s.waiting_high > 0 && code >= s.waiting_low && code <= s.waiting_high && code < s.waiting_low + max_waiting_codes;
}

/// Returns true if the block has only a block number, P and the waiting code.
bool has_nothing_else(const BlockContext& m) {
  std::size_t others = 0;
  for (std::uint32_t i = 0; i < m.block->word_count; ++i)
    if (const char letter = m.block->words[i].address; letter != 0 && letter != 'P') ++others;
  return others == 1;
}

/// Returns the channels whose numbers are the digits of P, as a mask: P12 gives bits 1 and 2. INFERRED: a repeated digit counts once.
Result<std::uint32_t> channels_in(const BlockContext& m, std::uint32_t digits) {
  const std::string text = std::to_string(digits);
  std::uint32_t channels = 0;
  for (const char c : text) {
    const int channel = c - '0';
    const bool known = channel >= 1 && channel <= max_channels && (m.waiting.known == 0 || (m.waiting.known >> channel & 1u) != 0);
    if (!known) return fail(alarm(AlarmId::channel_list, m.where('P'), std::string_view(text)));
    channels |= 1u << channel;
  }
  return channels;
}

}  // namespace

std::uint32_t channels_of(const Setup& setup) {
  if (setup.channels.empty()) return 0;
  std::uint32_t channels = 1u << setup.channel;
  for (const auto& [number, channel] : setup.channels) channels |= 1u << number;
  return channels;
}

bool waiting_suspended(const Nct& nct) {
  const auto found = nct.signals.find(no_waiting_signal);
  return found != nct.signals.end() && found->second != 0;
}

Result<bool> waiting_code(BlockContext& m, const Call& call) {
  const int code = call.word->code / 10;
  if (!is_waiting_code(nct_of(m).settings, code)) return false;
  const std::string name = "M" + std::to_string(code);
  if (!has_nothing_else(m)) return fail(alarm(AlarmId::own_block, call.where, std::string_view(name)));
  if (!m.has('P')) return fail(alarm(AlarmId::word_missing, call.where, 'P', std::string_view(name)));
  const auto digits = m.whole('P', 0, 99'999'999);
  if (!digits) return fail(digits.error());
  const auto channels = channels_in(m, *digits);
  if (!channels) return fail(channels.error());
  // the next pass of the program may differ from this pass, because the other channels may act differently
  m.pass_varies = m.pass_varies || m.waiting.known != 0;
  const bool alone = *channels == 1u << m.def.channel;
  if (m.waiting.mode == Control::Waiting::pass || waiting_suspended(nct_of(m))) return true;
  if (m.waiting.mode == Control::Waiting::alarm && !alone)
    return fail(alarm(AlarmId::channels_wait, call.where, double(m.def.channel), std::string_view(name)));
  if (m.waiting.mode == Control::Waiting::meet) m.waiting.meeting = Control::Meeting{static_cast<std::uint32_t>(code), *channels, m.origin};
  return true;
}

}  // namespace kadr::nct
