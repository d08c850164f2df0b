#pragma once
// TextBuffer: text on its way to a file in large pieces; and numbers as JSON wants them, fast.

#include <cstddef>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string>
#include <string_view>

namespace kadr {

/// Writes `value`, rounded to 1e-9, without trailing zeros or -0; null if it is not a number.
///   at       room for 32 characters
///   returns  after the last character
char* put_number(char* at, double value);

inline char* put_text(char* at, std::string_view text) {
  std::memcpy(at, text.data(), text.size());
  return at + text.size();
}

/// Appends `text` as a JSON string, quotes included.
void append_json(std::string& to, std::string_view text);

class TextBuffer {
 public:
  explicit TextBuffer(std::FILE* file) : file_(file), text_(std::make_unique<char[]>(size)), at_(text_.get()) {}
  TextBuffer(const TextBuffer&) = delete;
  TextBuffer& operator=(const TextBuffer&) = delete;
  ~TextBuffer() { flush(); }

  /// Where to write at most `most` ( ≤ size / 2) characters; hand the new end to done().
  char* room(std::size_t most) {
    if (static_cast<std::size_t>(text_.get() + size - at_) < most) [[unlikely]]
      flush();
    return at_;
  }
  void done(char* end) { at_ = end; }

  void append(std::string_view text);
  bool flush();
  bool ok() const { return error_ == 0; }
  /// Of the system, the first there was; 0: none.
  int error() const { return error_; }

  static constexpr std::size_t size = 1U << 17;

 private:
  std::FILE* file_;
  std::unique_ptr<char[]> text_;
  char* at_;
  int error_ = 0;
};

}  // namespace kadr
