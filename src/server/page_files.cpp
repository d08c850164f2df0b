// This file determines the content type (MIME type) of a file of the page by its name. Used by server/http_server.

#include "server/page_files.h"

#include <array>
#include <utility>

namespace kadr {

std::string_view content_type(std::string_view name) {
  using Row = std::pair<std::string_view, std::string_view>;
  constexpr std::array rows = {Row{".html", "text/html; charset=utf-8"},
                               Row{".js", "text/javascript; charset=utf-8"},
                               Row{".css", "text/css; charset=utf-8"},
                               Row{".svg", "image/svg+xml"},
                               Row{".png", "image/png"},
                               Row{".json", "application/json"}};
  for (const auto& [ending, type] : rows)
    if (name.ends_with(ending)) return type;
  return "application/octet-stream";
}

}  // namespace kadr
