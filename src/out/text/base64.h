#pragma once
// Bytes as text (RFC 4648).

#include <string>
#include <string_view>

namespace kadr {

std::string base64_of(std::string_view bytes);

}  // namespace kadr
