#pragma once
// MessageReader and MessageWriter: the base protocol of the Language Server Protocol 3.17. A message is a header, which states the length
// of the content in bytes, an empty line, and the content, which is JSON in UTF-8:
//
//   Content-Length: 52␍␊␍␊{"jsonrpc":"2.0","id":1,"method":"shutdown","params":null}

#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "base/stop_token.h"

namespace kadr {

class MessageReader {
 public:
  static constexpr std::size_t longest_header = 4096;                     // bytes
  static constexpr std::size_t longest_content = std::size_t{256} << 20;  // bytes

  /// `file`: an open file descriptor, from which nothing else reads. A stop counts as the end of the input.
  explicit MessageReader(int file, const StopToken& stop = {}) : file_(file), stop_(stop) {}

  /// Waits for the next message.
  ///   returns  its content; nullopt at the end of the input; an error sentence if a header is wrong or too long, or if the input ends
  ///            within a message. After an error nothing can be read, because the beginning of the next message is unknown.
  tl::expected<std::optional<std::string>, std::string> next();

 private:
  bool fill();
  tl::expected<std::size_t, std::string> content_length(std::string_view header) const;

  const int file_;
  const StopToken stop_;
  std::string read_;  // bytes that have been read and belong to no message yet
};

class MessageWriter {
 public:
  explicit MessageWriter(int file) : file_(file) {}

  /// Writes one message. Messages of several threads do not mix.
  ///   returns  false if the other side has closed the file
  bool put(std::string_view content);

 private:
  const int file_;
  std::mutex lock_;
};

}  // namespace kadr
