// Stores a text so that it can be read several times. Used by convert/conversion, view/source_text; tested by
// tests/lang/text_spool_test.cpp.

#include "lang/text/text_spool.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <utility>

namespace kadr {

/// A temporary file that is deleted when its last owner releases it.
class SpoolFile {
 public:
  SpoolFile() {
    std::error_code none;
    const std::string folder = std::filesystem::temp_directory_path(none).string();
    if (none) return;
    descriptor_ = open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, S_IRUSR | S_IWUSR);
    if (descriptor_ >= 0) return;
    std::string name = folder + "/kadr-XXXXXX";  // name of the file, used on file systems that cannot create a file without a name
    descriptor_ = mkostemp(name.data(), O_CLOEXEC);
    if (descriptor_ >= 0) unlink(name.c_str());
  }
  ~SpoolFile() {
    if (descriptor_ >= 0) close(descriptor_);
  }
  SpoolFile(const SpoolFile&) = delete;
  SpoolFile& operator=(const SpoolFile&) = delete;

  /// Writes a piece at an offset.
  ///   returns  number of bytes written: fewer than requested if there is no file, or no space on the disk
  std::size_t write(std::string_view piece, std::uint64_t at) const {
    return whole([&](std::size_t done) { return pwrite(descriptor_, piece.data() + done, piece.size() - done, off_t(at + done)); },
                 piece.size());
  }
  std::size_t read(std::uint64_t at, char* to, std::size_t size) const {
    return whole([&](std::size_t done) { return pread(descriptor_, to + done, size - done, off_t(at + done)); }, size);
  }

 private:
  template <class Part>
  static std::size_t whole(const Part& part, std::size_t size) {
    std::size_t done = 0;
    while (done < size) {
      const ssize_t n = part(done);
      if (n < 0 && errno == EINTR) continue;
      if (n <= 0) break;
      done += std::size_t(n);
    }
    return done;
  }

  int descriptor_ = -1;
};

namespace {

// number of bytes that are collected in memory before they are written to the temporary file together
constexpr std::size_t spilled_at_once = 256 * 1024;
constexpr std::size_t piece_bytes = 256 * 1024;

/// Reads first the part of the text that is in the file, then the part that is in memory.
class SpoolSource final : public ByteSource {
 public:
  SpoolSource(std::shared_ptr<SpoolFile> file, std::uint64_t written, std::string in_memory)
      : file_(std::move(file)), written_(written), in_memory_(std::move(in_memory)) {}

  std::size_t read(std::uint64_t offset, char* to, std::size_t size) override {
    std::size_t got = 0;
    if (offset < written_) {
      const auto wanted = std::size_t(std::min<std::uint64_t>(size, written_ - offset));
      got = file_->read(offset, to, wanted);
      if (got < wanted || got == size) return got;
    }
    const std::uint64_t place_in_memory = offset + got - written_;
    return place_in_memory >= in_memory_.size() ? got : got + in_memory_.copy(to + got, size - got, std::size_t(place_in_memory));
  }
  std::uint64_t size() const override { return written_ + in_memory_.size(); }

 private:
  std::shared_ptr<SpoolFile> file_;
  std::uint64_t written_;
  std::string in_memory_;
};

class SharedSource final : public ByteSource {
 public:
  explicit SharedSource(std::shared_ptr<ByteSource> text) : text_(std::move(text)) {}
  std::size_t read(std::uint64_t offset, char* to, std::size_t size) override { return text_->read(offset, to, size); }
  std::uint64_t size() const override { return text_->size(); }

 private:
  std::shared_ptr<ByteSource> text_;
};

/// Returns the end of the last whole line in the piece. If the piece is only a part of a line, returns the end of its last whole character.
std::size_t end_of_piece(std::string_view piece) {
  constexpr unsigned char follows = 0x80, mask = 0xc0;
  if (const std::size_t line = piece.rfind('\n'); line != std::string_view::npos) return line + 1;
  std::size_t end = piece.size() - 1;
  while (end > 0 && (static_cast<unsigned char>(piece[end]) & mask) == follows) --end;
  return end == 0 ? piece.size() : end;
}

}  // namespace

void TextSpool::spill() {
  if (!file_) file_ = std::make_shared<SpoolFile>();
  const std::size_t done = file_->write(in_memory_, written_);
  written_ += done;
  in_memory_.erase(0, done);
  most_in_memory_ = in_memory_.empty() ? std::min(most_in_memory_, spilled_at_once) : std::string::npos;
}

std::shared_ptr<ByteSource> TextSpool::source() {
  return std::make_shared<SpoolSource>(std::exchange(file_, nullptr), std::exchange(written_, 0), std::exchange(in_memory_, {}));
}

std::unique_ptr<ByteSource> shared_source(std::shared_ptr<ByteSource> text) { return std::make_unique<SharedSource>(std::move(text)); }

std::string whole_text(ByteSource& source) {
  std::string all;
  (void)each_piece(source, [&](std::string_view piece) {
    all += piece;
    return true;
  });
  return all;
}

bool each_piece(ByteSource& source, const std::function<bool(std::string_view)>& take) {
  std::string piece;
  std::uint64_t at = 0;
  while (true) {
    const std::size_t before = piece.size();
    piece.resize(before + piece_bytes);
    const std::size_t got = source.read(at, piece.data() + before, piece_bytes);
    piece.resize(before + got);
    at += got;
    if (got == 0) return piece.empty() || take(piece);
    const std::size_t end = end_of_piece(piece);
    if (!take(std::string_view(piece).substr(0, end))) return false;
    piece.erase(0, end);
  }
}

}  // namespace kadr
