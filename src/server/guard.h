#pragma once
// Guard: which requests are served at all. A page of another site must not reach this server through the user's browser, not even by a name
// that it makes point here (DNS rebinding).

#include <cstdint>
#include <string>
#include <string_view>

namespace kadr {

struct ServedAddress {
  std::string host = "127.0.0.1";  // that it listens on; "0.0.0.0": on all
  std::uint16_t port = 0;
  /// Others than this machine may reach it.
  bool is_open() const { return host != "127.0.0.1" && host != "::1" && host != "localhost"; }
};

/// `host`: of the request, with its port. On all addresses any address in figures is right, a name never.
bool is_own_host(const ServedAddress& address, std::string_view host);

/// `origin`: of the request; empty: it has none, so it comes from no page.
bool is_own_origin(std::string_view origin, std::string_view host);

/// 128 bits by the system's generator, in hexadecimal.
std::string new_token();

}  // namespace kadr
