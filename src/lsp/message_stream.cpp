// Reads and writes messages of the base protocol (LSP 3.17, "Base Protocol"). Used by lsp/language_server; tested by
// tests/lsp/message_stream_test.cpp.

#include "lsp/message_stream.h"

#include <fmt/core.h>
#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>

#include "base/ascii.h"
#include "config/texts.h"
#include "texts/lsp.h"

namespace kadr {
namespace {

constexpr std::string_view end_of_header = "\r\n\r\n";
constexpr std::string_view length_field = "content-length:";

bool write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

}  // namespace

/// Waits for further bytes and appends them. Returns false at the end of the file, and after a stop.
bool MessageReader::fill() {
  constexpr int poll_milliseconds = 100;  // within this time a stop is noticed
  pollfd ready{file_, POLLIN, 0};
  while (::poll(&ready, 1, poll_milliseconds) <= 0)
    if (stop_.requested()) return false;
  constexpr std::size_t step = std::size_t{64} << 10;
  const std::size_t had = read_.size();
  read_.resize(had + step);
  ssize_t got = 0;
  do got = ::read(file_, read_.data() + had, step);
  while (got < 0 && errno == EINTR);
  read_.resize(had + static_cast<std::size_t>(got > 0 ? got : 0));
  return got > 0;
}

tl::expected<std::size_t, std::string> MessageReader::content_length(std::string_view header) const {
  while (!header.empty()) {
    const std::size_t end = std::min(header.find("\r\n"), header.size());
    std::string_view field = header.substr(0, end);
    header.remove_prefix(std::min(header.size(), end + 2));
    std::string name(field.substr(0, std::min(field.size(), length_field.size())));
    for (char& c : name) c = to_lower(c);
    if (name != length_field) continue;  // Content-Type, the only other field, has one possible meaning
    field.remove_prefix(length_field.size());
    while (field.starts_with(' ')) field.remove_prefix(1);
    std::size_t length = 0;
    const auto [rest, error] = std::from_chars(field.data(), field.data() + field.size(), length);
    if (error != std::errc() || rest != field.data() + field.size()) break;
    if (length > longest_content) return tl::unexpected(translated(texts::lsp::message_too_long, length, longest_content));
    return length;
  }
  return tl::unexpected(translated(texts::lsp::no_content_length));
}

tl::expected<std::optional<std::string>, std::string> MessageReader::next() {
  std::size_t header = 0;
  while ((header = read_.find(end_of_header)) == std::string::npos) {
    if (read_.size() > longest_header) return tl::unexpected(translated(texts::lsp::no_content_length));
    if (fill()) continue;
    if (read_.empty()) return std::nullopt;
    return tl::unexpected(translated(texts::lsp::input_ends));
  }
  const auto length = content_length(std::string_view(read_).substr(0, header));
  if (!length) return tl::unexpected(length.error());
  const std::size_t begin = header + end_of_header.size();
  while (read_.size() - begin < *length)
    if (!fill()) return tl::unexpected(translated(texts::lsp::input_ends));
  std::string content = read_.substr(begin, *length);
  read_.erase(0, begin + *length);
  return content;
}

bool MessageWriter::put(std::string_view content) {
  const std::lock_guard hold(lock_);
  return write_all(file_, fmt::format("Content-Length: {}{}", content.size(), end_of_header)) && write_all(file_, content);
}

}  // namespace kadr
