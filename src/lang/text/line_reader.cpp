// Splits the bytes of a program into lines. A program of any length is read through a window in memory, from any offset. Used by
// lang/block/block_reader, lang/text/utf16; tested by tests/lang/line_reader_test.cpp.

#include "lang/text/line_reader.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <map>
#include <mutex>
#include <utility>

#include "lang/block/grammar.h"
#include "lang/text/text_spool.h"

namespace kadr {
namespace {

constexpr std::size_t window_bytes = 256 * 1024;
/// The number of bytes in which the end of a line is searched. CRs before the end do not count, so a line may have more bytes than its
/// permitted length.
constexpr std::size_t searched_bytes = 2 * limits::line_bytes;
// Number of bytes that are read first after a jump. The number is small, because a subprogram is short; it doubles with each further read.
constexpr std::size_t first_read = 16 * 1024;
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
static_assert(searched_bytes < window_bytes);

class OpenFile {
 public:
  explicit OpenFile(int descriptor) : descriptor_(descriptor) {}
  ~OpenFile() {
    if (descriptor_ >= 0) close(descriptor_);
  }
  OpenFile(OpenFile&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
  OpenFile& operator=(OpenFile&&) = delete;
  int descriptor() const { return descriptor_; }

 private:
  int descriptor_;
};

class FileSource final : public ByteSource {
 public:
  FileSource(OpenFile file, std::uint64_t size) : file_(std::move(file)), size_(size) {}

  std::size_t read(std::uint64_t offset, char* to, std::size_t size) override {
    std::size_t got = 0;
    while (got < size) {
      const ssize_t n = pread(file_.descriptor(), to + got, size - got, static_cast<off_t>(offset + got));
      if (n < 0 && errno == EINTR) continue;
      if (n <= 0) break;
      got += static_cast<std::size_t>(n);
    }
    return got;
  }
  std::uint64_t size() const override { return size_; }

 private:
  OpenFile file_;
  std::uint64_t size_;
};

using SharedText = std::shared_ptr<const std::string>;

class TextSource final : public ByteSource {
 public:
  explicit TextSource(SharedText text) : text_(std::move(text)) {}

  std::size_t read(std::uint64_t offset, char* to, std::size_t size) override {
    if (offset >= text_->size()) return 0;
    return text_->copy(to, size, static_cast<std::size_t>(offset));
  }
  std::uint64_t size() const override { return text_->size(); }

 private:
  SharedText text_;
};

using OpenedSource = std::shared_ptr<ByteSource>;

/// Reads all bytes of a pipe, terminal or device, because such input cannot be read twice.
OpenedSource read_whole(const OpenFile& file, std::uint64_t most) {
  TextSpool text;
  std::string piece(window_bytes, '\0');
  while (true) {
    const ssize_t n = read(file.descriptor(), piece.data(), piece.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return nullptr;
    if (n == 0) return text.source();
    text.append(std::string_view(piece).substr(0, static_cast<std::size_t>(n)));
    if (text.size() > most) {
      errno = EMSGSIZE;
      return nullptr;
    }
  }
}

/// Stores the text of each pipe. A pipe gives its text only once, but there are two readers: the first guesses the control from the text,
/// the second reads the program.
class Pipes {
 public:
  static OpenedSource known(const std::string& path) {
    const std::lock_guard lock(mutex());
    const auto found = texts().find(path);
    return found == texts().end() ? nullptr : found->second;
  }
  static OpenedSource keep(const std::string& path, OpenedSource text) {
    const std::lock_guard lock(mutex());
    if (text) texts()[path] = text;
    return text;
  }

 private:
  static std::mutex& mutex() {
    static std::mutex one;
    return one;
  }
  static std::map<std::string, OpenedSource>& texts() {
    static std::map<std::string, OpenedSource> all;
    return all;
  }
};

/// Removes the CRs at the end of a line. There may be several CRs before an LF.
std::string_view without_crs(std::string_view bytes) {
  while (bytes.ends_with('\r')) bytes.remove_suffix(1);
  return bytes;
}

/// Returns true if CR alone ends the lines, that is, if the sample has a CR and no LF. A CR as the last byte of a full sample may be the
/// first half of a CR LF.
bool has_bare_cr(std::string_view sample) {
  if (sample.find('\n') != std::string_view::npos) return false;
  if (sample.size() == window_bytes) sample.remove_suffix(1);
  return sample.find('\r') != std::string_view::npos;
}

}  // namespace

std::unique_ptr<ByteSource> open_file(const std::string& path, const FileAccess* door) {
  if (OpenedSource text = door == nullptr ? Pipes::known(path) : nullptr) return shared_source(std::move(text));
  OpenFile file(door != nullptr ? door->open_for_reading(path)
                : path == "-"   ? fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, 0)
                                : open(path.c_str(), O_RDONLY | O_CLOEXEC));
  struct stat status {};
  if (file.descriptor() < 0 || fstat(file.descriptor(), &status) != 0) return nullptr;
  if (S_ISDIR(status.st_mode)) {
    errno = EISDIR;
    return nullptr;
  }
  if (!S_ISREG(status.st_mode)) {
    const bool is_device = S_ISCHR(status.st_mode) || S_ISBLK(status.st_mode);
    OpenedSource text = Pipes::keep(path, read_whole(file, is_device ? limits::device_bytes : limits::piped_bytes));
    return text ? shared_source(std::move(text)) : nullptr;
  }
  // The result of posix_fadvise is ignored, because the call only advises the system about the access to the file.
  posix_fadvise(file.descriptor(), 0, 0, POSIX_FADV_SEQUENTIAL);
  return std::make_unique<FileSource>(std::move(file), static_cast<std::uint64_t>(status.st_size));
}

std::unique_ptr<ByteSource> shared_text_source(std::shared_ptr<const std::string> text) {
  return std::make_unique<TextSource>(std::move(text));
}

std::unique_ptr<ByteSource> text_source(std::string text) {
  return std::make_unique<TextSource>(std::make_shared<const std::string>(std::move(text)));
}

LineReader::LineReader(std::shared_ptr<ByteSource> source)
    : source_(std::move(source)), window_(window_bytes, '\0'), next_read_(window_bytes) {
  fill();
  if (has_bare_cr({window_.data(), filled_})) end_of_line_ = '\r';
}

std::uint64_t LineReader::size() const { return source_->size(); }

std::string_view LineReader::sample() {
  if (sample_.empty()) {
    sample_.resize(window_bytes);
    sample_.resize(source_->read(0, sample_.data(), sample_.size()));
  }
  return sample_;
}

void LineReader::seek(std::uint64_t offset, std::uint32_t number) {
  line_ = number;
  if (offset >= window_offset_ && offset <= window_offset_ + filled_) {
    position_ = static_cast<std::size_t>(offset - window_offset_);
    return;
  }
  window_offset_ = offset;
  position_ = filled_ = 0;
  at_end_ = false;
  next_read_ = first_read;
}

/// Reads more bytes into the window. Lines already read are removed only if the window is full. So the lines of a loop of less than 256 KiB
/// remain in the window. Returns false at the end of the source.
bool LineReader::fill() {
  if (at_end_) return false;
  if (filled_ == window_.size()) {
    std::memmove(window_.data(), window_.data() + position_, filled_ - position_);
    window_offset_ += position_;
    filled_ -= position_;
    position_ = 0;
  }
  const std::size_t wanted = std::min(next_read_, window_.size() - filled_);
  const std::size_t got = source_->read(window_offset_ + filled_, window_.data() + filled_, wanted);
  filled_ += got;
  at_end_ = got == 0;
  next_read_ = std::min(2 * next_read_, window_.size());
  return got > 0;
}

/// Returns the number of bytes from the window's position to the end of the line; `none` if there is no end within the longest permitted
/// line. The window is filled as far as needed.
std::size_t LineReader::find_end() {
  std::size_t searched = 0;
  while (true) {
    const std::size_t there = std::min(filled_ - position_, searched_bytes);
    const char* begin = window_.data() + position_;
    if (const void* found = std::memchr(begin + searched, end_of_line_, there - searched))
      return static_cast<std::size_t>(static_cast<const char*>(found) - begin);
    searched = there;
    if (there == searched_bytes || !fill()) return none;
  }
}

/// Skips the rest of a line that does not end within searched_bytes. Returns false if the file ends with this line.
bool LineReader::skip_rest() {
  while (true) {
    const std::size_t end = find_end();
    if (end != none) {
      position_ += end + 1;
      return true;
    }
    position_ += std::min(filled_ - position_, searched_bytes);
    if (position_ == filled_ && at_end_) return false;
  }
}

bool LineReader::next(Line& line) {
  if (position_ == filled_ && !fill()) return false;
  if (window_offset_ + position_ == 0 && std::string_view(window_.data(), filled_).starts_with(byte_order_mark)) {
    position_ = byte_order_mark.size();
    if (position_ == filled_ && !fill()) return false;
  }
  const std::size_t end = find_end();
  const std::size_t raw = end != none ? end : std::min(filled_ - position_, searched_bytes);
  const std::string_view bytes(window_.data() + position_, raw);
  line = {without_crs(bytes), offset(), line_++, true, false};
  if (raw == searched_bytes) {  // the line is longer than permitted, because its end is not within the searched bytes
    long_line_.assign(bytes, 0, limits::line_bytes);
    line.bytes = long_line_;
    line.too_long = true;
    line.ended = skip_rest();
    return true;
  }
  position_ += end != none ? end + 1 : raw;
  line.ended = end != none;
  line.too_long = line.bytes.size() > limits::line_bytes;
  line.bytes = line.bytes.substr(0, limits::line_bytes);
  return true;
}

}  // namespace kadr
