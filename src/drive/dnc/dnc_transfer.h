#pragma once
// DncSender, DncReceiver: one program over a serial line, as state machines without clock and without input or output.
//
// A control stops the sender by DC3 and then accepts 2 to 10 more characters. An operating system's driver would swallow thousands, so the
// sender never has more than a few characters in the driver beyond those that the line has carried (pacing). DC codes are recognised by
// their seven bits: with even parity DC3 is 0x93, which the driver's own XON/XOFF does not see.

#include <cstdint>
#include <string>
#include <string_view>

#include "drive/dnc/dnc_profile.h"

namespace kadr::drive {

inline constexpr char dc1 = '\x11', dc2 = '\x12', dc3 = '\x13', dc4 = '\x14';

class DncSender {
 public:
  enum class State : std::uint8_t {
    waits,    // for DC1
    sends,    //
    held,     // the control has sent DC3
    sent,     // everything has been carried by the line
    refused,  // the control has sent NAK or CAN
  };

  DncSender(const DncProfile& profile, std::string bytes, double now);

  /// Characters of the control have come.
  void receive(std::string_view bytes, double now);
  /// Returns the characters to send now.
  std::string take(double now);
  State state() const { return state_; }
  /// Number of characters that were given to the line, and of all.
  std::size_t position() const { return at_; }
  std::size_t size() const { return bytes_.size(); }
  std::size_t holds() const { return holds_; }  // how often the control has stopped the sender

  static constexpr double most_ahead = 6;  // characters in the driver beyond what the line has carried

 private:
  void carry(double now);

  DncHandshake handshake_;
  std::string bytes_;
  double rate_;           // characters per second
  double in_driver_ = 0;  // characters that are given to the driver and not carried by the line yet
  double at_time_;
  std::size_t at_ = 0, holds_ = 0;
  State state_;
};

class DncReceiver {
 public:
  enum class State : std::uint8_t {
    waits,     // for the first character of the program
    receives,  //
    received,  // the end mark has come, or the line is silent
    too_long,  // more than `most_bytes`
  };

  /// `silence`: time without a character after which the program is complete, s
  DncReceiver(const DncProfile& profile, double now, double silence);

  void receive(std::string_view bytes, double now);
  void tick(double now);
  /// Returns the characters for the control: DC1 at the beginning, DC3 at the end.
  std::string take_output();
  State state() const { return state_; }
  /// The bytes of the program as they came, without DC codes.
  const std::string& bytes() const { return bytes_; }

  static constexpr std::size_t most_bytes = 64U << 20;

 private:
  void end(State state);

  const DncProfile& profile_;
  double silence_, heard_at_;
  std::string bytes_, output_;
  int percents_ = 0;
  State state_ = State::waits;
};

}  // namespace kadr::drive
