#pragma once
// Guard: decides which requests the server answers. A page of another site must not reach this server through the user's browser, not
// even by a host name that the site points at this computer (DNS rebinding).

#include <cstdint>
#include <string>
#include <string_view>

namespace kadr {

struct ServedAddress {
  std::string host = "127.0.0.1";  // address that the server listens on; "0.0.0.0" means all addresses of the computer
  std::uint16_t port = 0;
  /// Returns true if other computers can reach this address.
  bool is_open() const { return host != "127.0.0.1" && host != "::1" && host != "localhost"; }
};

/// Returns true if the host and port that a request names belong to this server. If the server listens on all addresses, every numeric
/// address is accepted; the only accepted host name is localhost.
bool is_own_host(const ServedAddress& address, std::string_view host);

/// Returns true if the origin of a request (the address of the page that sends the request) is this server. An empty origin is accepted,
/// because a program that is not a browser sends no origin.
bool is_own_origin(std::string_view origin, std::string_view host);

/// Returns 128 random bits from the system's generator, in hexadecimal.
std::string new_token();

}  // namespace kadr
