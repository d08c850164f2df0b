#pragma once
// Guard: decides which requests are served at all. A page of another site must not reach this server through the user's browser, even by
// a host name that it makes point here (DNS rebinding).

#include <cstdint>
#include <string>
#include <string_view>

namespace kadr {

struct ServedAddress {
  std::string host = "127.0.0.1";  // address it listens on; "0.0.0.0": all
  std::uint16_t port = 0;
  /// True if other computers can reach it.
  bool is_open() const { return host != "127.0.0.1" && host != "::1" && host != "localhost"; }
};

/// `host`: of the request, with its port. If the server listens on all addresses, any numeric address is accepted and no name but
/// localhost.
bool is_own_host(const ServedAddress& address, std::string_view host);

/// `origin`: of the request; empty: the request has none, so it does not come from a page.
bool is_own_origin(std::string_view origin, std::string_view host);

/// 128 random bits from the system's generator, in hexadecimal.
std::string new_token();

}  // namespace kadr
