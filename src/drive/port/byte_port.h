#pragma once
// BytePort: the wire to a machine, as bytes in and bytes out: a serial line or a TCP connection. No thread of its own.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

namespace kadr::drive {

class BytePort {
 public:
  virtual ~BytePort() = default;
  /// Returns the bytes that have come. Waits at most `seconds` for the first of them.
  ///   returns  an empty text if none came in time; nullopt if the port is gone: an unplugged cable, a closed connection
  virtual std::optional<std::string> read(double seconds) = 0;
  /// Sends the bytes. Returns false if the port is gone, or did not accept them within a second.
  virtual bool write(std::string_view bytes) = 0;
};

enum class Parity : std::uint8_t { none, even, odd };

/// The settings of a serial line; a TCP connection ignores them.
struct LineSettings {
  int baud = 115200;
  int data_bits = 8;
  Parity parity = Parity::none;
  int stop_bits = 1;
  bool rts_cts = false;  // handshake by the wires RTS and CTS
};

/// Removes the commands of the Telnet protocol (RFC 854) from what a controller in a network sends, also if they come in pieces.
class TelnetFilter {
 public:
  std::string data_in(std::string_view bytes);

 private:
  enum class Expects : std::uint8_t { data, command, option, parameters, end_of_parameters };
  Expects expects_ = Expects::data;
};

/// Opens a port and locks it, so that no other program can send to the same machine.
///   name     a device such as /dev/serial/by-id/…, or tcp:HOST:PORT
///   returns  an error sentence in the language of the thread
tl::expected<std::unique_ptr<BytePort>, std::string> open_port(const std::string& name, const LineSettings& line);

/// Returns the number of characters per second that a serial line carries.
double characters_per_second(const LineSettings& line);
/// Returns the number of characters per second that the port `name` carries; 0 if it has no rate of its own, as a TCP connection.
double characters_per_second(const std::string& name, const LineSettings& line);

/// True if a serial line can have this rate, bit/s.
bool is_baud_rate(int baud);

}  // namespace kadr::drive
