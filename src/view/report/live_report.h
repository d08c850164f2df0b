#pragma once
// Creates a live report: the page without a server as one file (docs/web.md), with the files of a program inside. The page runs the
// program, and whatever is changed in its files (web/src/engine/given.ts).

#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

namespace kadr {

/// A file inside the page.
struct LiveFile {
  std::string place;  // path in the folder of the page
  std::string bytes;
};

/// What the page opens. The values are those of the question `open` (docs/panel-protocol.md); all but `file` may be empty.
struct LiveOpening {
  std::string file, control, machine, setup;
};

/// Returns whether the HTML is the page without a server as one file.
bool is_page_alone(std::string_view html);

/// Returns the page with the files inside, as HTML.
///   law      the bytes of files are inserted only as base64, never as markup
///   returns  an error sentence if zlib is missing
tl::expected<std::string, std::string> live_report_html(std::string_view page, const LiveOpening& opening,
                                                        const std::vector<LiveFile>& files);

}  // namespace kadr
