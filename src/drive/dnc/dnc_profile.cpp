// The profiles of controls on a serial line, and the code of programs on it. Used by dnc_sender, dnc_receiver and kadr dnc; tested by
// tests/drive/dnc_test.cpp.

#include "drive/dnc/dnc_profile.h"

#include <algorithm>

#include "lang/text/tape_reading.h"

namespace kadr::drive {
namespace {

constexpr std::size_t tape_leader = 100;  // rows

// Rates are the usual ones of the controls; the machine's own settings decide, so each can be given on the command line.
constexpr DncProfile profiles[] = {
    // Fanuc 0i operator's manual, reader/punch interface: ISO code with even parity, 8 bits with it, two stop bits, codes DC1 to DC4.
    {"fanuc-rs232",
     {4800, 8, Parity::none, 2, false},
     DncCode::iso_even,
     DncHandshake::dc_codes,
     "\n",
     0,
     true,
     "Fanuc 0i: reader/punch interface"},
    // Haas settings 11 to 14: 7 bits, even parity, one stop bit, XON/XOFF.
    {"haas-rs232", {9600, 7, Parity::even, 1, false}, DncCode::ascii, DncHandshake::xon_xoff, "\r\n", 0, true, "Haas: settings 11 to 14"},
    {"s2c42-tape",
     {2400, 8, Parity::none, 2, false},
     DncCode::iso_even,
     DncHandshake::xon_xoff,
     "\n",
     tape_leader,
     true,
     "spec/s2c42.md 6.1"},
    {"iso7", {2400, 8, Parity::none, 2, false}, DncCode::iso_even, DncHandshake::xon_xoff, "\n", tape_leader, true, "GOST 20999-83"},
    {"eia", {2400, 8, Parity::none, 2, false}, DncCode::eia, DncHandshake::dc_codes, "\n", tape_leader, true, "EIA RS-244"},
    // INFERRED: the NCT manual leaves the line to the machine builder.
    {"nct-rs232", {9600, 8, Parity::none, 1, true}, DncCode::ascii, DncHandshake::none, "\r\n", 0, true, "INFERRED"},
    {"generic", {9600, 8, Parity::none, 1, false}, DncCode::ascii, DncHandshake::xon_xoff, "\n", 0, false, "-"},
};

/// Returns the text with a line `%` at its beginning and its end.
std::string between_percents(std::string_view text) {
  std::string whole(text);
  if (!whole.empty() && whole.back() != '\n') whole += '\n';
  if (!whole.starts_with('%')) whole.insert(0, "%\n");
  const std::size_t last = whole.find_last_not_of(" \r\n");
  const bool ends = last != std::string::npos && last > 0 && whole[last] == '%' && whole[last - 1] == '\n';
  if (!ends) whole += "%\n";
  return whole;
}

/// Returns the bytes of a text on the line.
Result<std::string> coded(const DncProfile& profile, std::string_view whole) {
  if (profile.code != DncCode::ascii)
    return encode_tape(whole, profile.leader, profile.code == DncCode::eia ? TapeCode::eia : TapeCode::iso);
  std::string bytes(profile.leader, '\0');
  for (std::size_t i = 0; i < whole.size(); ++i) {
    const char c = whole[i];
    const Span where{static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(i + 1)};
    if (static_cast<unsigned char>(c) > 0x7e) return fail(alarm(AlarmId::bad_encoding, where, std::string_view(&whole[i], 1)));
    if (c == '\r') continue;
    if (c == '\n') bytes += profile.end_of_block;
    else bytes += c;
  }
  bytes.append(profile.leader, '\0');
  return bytes;
}

DncText text_on_line(const DncProfile& profile, std::string_view bytes) {
  DncText result;
  if (profile.code != DncCode::ascii) {
    const TapeReading read = read_tape(bytes, profile.code == DncCode::eia ? TapeCode::eia : TapeCode::iso);
    result.text = read.text;
    result.faults = read.faults.size();
    if (!read.faults.empty()) result.first_fault = read.faults.front().row;
    return result;
  }
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const char c = bytes[i];
    if (c == '\0' || c == '\r' || c == '\x7f') continue;
    if (static_cast<unsigned char>(c) > 0x7f && ++result.faults == 1) result.first_fault = i + 1;
    result.text += static_cast<unsigned char>(c) > 0x7f ? '?' : c;
  }
  return result;
}

}  // namespace

std::span<const DncProfile> dnc_profiles() { return profiles; }

const DncProfile* dnc_profile_named(std::string_view id) {
  const auto* const found = std::find_if(std::begin(profiles), std::end(profiles), [&](const DncProfile& p) { return id == p.id; });
  return found == std::end(profiles) ? nullptr : found;
}

Result<std::string> dnc_bytes(const DncProfile& profile, std::string_view text) {
  const std::string whole = profile.percent ? between_percents(text) : std::string(text);
  auto bytes = coded(profile, whole);
  if (!bytes) {
    const std::uint32_t added = profile.percent && !text.starts_with('%') ? 2 : 0;  // the line `%` at the beginning
    bytes.error().where.begin -= added, bytes.error().where.end -= added;
  }
  return bytes;
}

DncText dnc_text(const DncProfile& profile, std::string_view bytes) {
  DncText result = text_on_line(profile, bytes);
  if (result.text.ends_with('%')) result.text += '\n';  // the receiver ends at this mark, before the end of its line
  return result;
}

}  // namespace kadr::drive
