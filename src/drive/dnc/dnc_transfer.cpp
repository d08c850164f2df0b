// One program over a serial line. Used by kadr dnc, tested by tests/drive/dnc_test.cpp with a control whose buffer is small.

#include "drive/dnc/dnc_transfer.h"

#include <algorithm>
#include <utility>

namespace kadr::drive {
namespace {

constexpr char nak = '\x15', can = '\x18';
constexpr unsigned char seven_bits = 0x7f;
constexpr unsigned char percent = '%', eia_percent = 0x0b;  // ER of EIA RS-244

char without_parity(char byte) { return static_cast<char>(static_cast<unsigned char>(byte) & seven_bits); }

}  // namespace

DncSender::DncSender(const DncProfile& profile, std::string bytes, double now)
    : handshake_(profile.handshake),
      bytes_(std::move(bytes)),
      rate_(characters_per_second(profile.line)),
      at_time_(now),
      state_(profile.handshake == DncHandshake::dc_codes ? State::waits : State::sends) {}

void DncSender::carry(double now) {
  in_driver_ = std::max(0.0, in_driver_ - (now - at_time_) * rate_);
  at_time_ = now;
}

void DncSender::receive(std::string_view bytes, double now) {
  carry(now);
  for (const char byte : bytes) {
    const char code = without_parity(byte);
    if (code == nak || code == can) state_ = State::refused;
    if (handshake_ == DncHandshake::none) continue;
    if (code == dc1 && (state_ == State::waits || state_ == State::held)) state_ = State::sends;
    if (code == dc3 && state_ == State::sends) {
      state_ = State::held;
      ++holds_;
    }
  }
}

std::string DncSender::take(double now) {
  carry(now);
  if (state_ != State::sends) return {};
  if (at_ == bytes_.size()) {
    if (in_driver_ <= 0) state_ = State::sent;
    return {};
  }
  const double space = most_ahead - in_driver_;
  const std::size_t count = std::min(bytes_.size() - at_, static_cast<std::size_t>(std::max(0.0, space)));
  std::string piece = bytes_.substr(at_, count);
  at_ += count;
  in_driver_ += static_cast<double>(count);
  return piece;
}

DncReceiver::DncReceiver(const DncProfile& profile, double now, double silence) : profile_(profile), silence_(silence), heard_at_(now) {
  if (profile.handshake != DncHandshake::none) output_ += dc1;
}

void DncReceiver::receive(std::string_view bytes, double now) {
  const bool is_eia = profile_.code == DncCode::eia;
  for (const char byte : bytes) {
    if (state_ == State::received || state_ == State::too_long) return;
    const char code = without_parity(byte);
    const bool is_dc = !is_eia && code >= dc1 && code <= dc4;
    if (is_dc || (is_eia && byte >= dc1 && byte <= dc4 && bytes_.empty())) {
      if (code == dc4 && !bytes_.empty()) end(State::received);
      continue;
    }
    heard_at_ = now;
    // the leader, and what is left of the line of the program before: its end
    if (state_ == State::waits && (code == '\0' || (!is_eia && (code == '\n' || code == '\r' || code == ' ')))) continue;
    state_ = State::receives;
    bytes_ += byte;
    const unsigned char row = static_cast<unsigned char>(byte);
    if (is_eia ? row == eia_percent : static_cast<unsigned char>(code) == percent) ++percents_;
    if (profile_.percent && percents_ == 2) end(State::received);
    else if (bytes_.size() >= most_bytes) end(State::too_long);
  }
}

void DncReceiver::tick(double now) {
  if (state_ == State::receives && now - heard_at_ > silence_) end(State::received);
}

void DncReceiver::end(State state) {
  state_ = state;
  if (profile_.handshake != DncHandshake::none) output_ += dc3;
}

std::string DncReceiver::take_output() { return std::exchange(output_, {}); }

}  // namespace kadr::drive
