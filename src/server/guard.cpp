// Guard: decides which requests the server answers. This file checks the host name and the origin of requests, and creates random tokens.
// Used by server/http_server; tested by tests/server/guard_test.cpp.

#include "server/guard.h"

#include <sys/random.h>

#include <array>
#include <stdexcept>

namespace kadr {
namespace {

bool is_in_figures(std::string_view host) {
  return !host.empty() &&
         host.find_first_not_of(host.front() == '[' ? "[]0123456789abcdefABCDEF:" : "0123456789.") == std::string_view::npos;
}

}  // namespace

bool is_own_host(const ServedAddress& address, std::string_view host) {
  const std::string port = ":" + std::to_string(address.port);
  if (!host.ends_with(port)) return false;
  host.remove_suffix(port.size());
  if (address.host == "0.0.0.0" || address.host == "::") return is_in_figures(host) || host == "localhost";
  if (!address.is_open()) return host == "127.0.0.1" || host == "localhost" || host == "[::1]";
  return host == address.host || host == "[" + address.host + "]";
}

bool is_own_origin(std::string_view origin, std::string_view host) {
  return origin.empty() || (origin.starts_with("http://") && origin.substr(7) == host);
}

std::string new_token() {
  std::array<unsigned char, 16> bytes{};
  if (::getrandom(bytes.data(), bytes.size(), 0) != ssize_t(bytes.size())) throw std::runtime_error("no random numbers from the system");
  constexpr std::string_view digits = "0123456789abcdef";
  std::string token;
  for (const unsigned char byte : bytes) token += digits[byte >> 4], token += digits[byte & 15];
  return token;
}

}  // namespace kadr
