#pragma once
// TextBuffer: collects text and writes it to a file in large blocks of bytes. It also formats numbers for JSON quickly.

#include <cstddef>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string>
#include <string_view>

namespace kadr {

/// Formats `value`, rounded to 1e-9, without zeros at the end and without the sign of -0. A value that is not finite is written as null.
///   at       address of space for 32 characters
///   returns  the address after the last character
char* put_number(char* at, double value);

inline char* put_text(char* at, std::string_view text) {
  std::memcpy(at, text.data(), text.size());
  return at + text.size();
}

/// Appends `text` as a JSON string, with its quotes.
void append_json(std::string& to, std::string_view text);

class TextBuffer {
 public:
  explicit TextBuffer(std::FILE* file) : file_(file), text_(std::make_unique<char[]>(size)), at_(text_.get()) {}
  TextBuffer(const TextBuffer&) = delete;
  TextBuffer& operator=(const TextBuffer&) = delete;
  ~TextBuffer() { flush(); }

  /// Returns an address at which the caller may write up to `most` ( ≤ size / 2) characters. Afterwards the caller passes the end of the
  /// written text to done().
  char* room(std::size_t most) {
    if (static_cast<std::size_t>(text_.get() + size - at_) < most) [[unlikely]]
      flush();
    return at_;
  }
  void done(char* end) { at_ = end; }

  void append(std::string_view text);
  bool flush();
  bool ok() const { return error_ == 0; }
  /// Returns the errno of the first write error; 0 if there was no error.
  int error() const { return error_; }

  static constexpr std::size_t size = 1U << 17;

 private:
  std::FILE* file_;
  std::unique_ptr<char[]> text_;
  char* at_;
  int error_ = 0;
};

}  // namespace kadr
