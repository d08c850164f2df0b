// Writes archives, one file after the other. Used by stock/mesh/threemf_write.

#include "stock/mesh/zip.h"
#include "stock/mesh/zlib_library.h"
#include "texts/zip_file.h"

namespace kadr {
namespace {

constexpr std::size_t max_bytes = 0xfffffffe;  // greatest size of an archive without ZIP64, bytes
// Date of all files: 1 January 1980, so that the bytes do not depend on the present date.
constexpr std::uint32_t first_day = (1 << 5 | 1) << 16;
constexpr std::uint32_t version = 20, deflate = 8;
constexpr int packing_level = 3;  // zlib level, 1 to 9; a level that takes twice the time would make a mesh only a tenth shorter

void put_le(std::string& out, std::uint32_t value, int bytes) {
  for (int i = 0; i < bytes; ++i) out.push_back(char(value >> (8 * i) & 0xff));
}

/// Packs bytes, and computes the length and the checksum of the bytes before packing.
class Deflater {
 public:
  explicit Deflater(const Zlib& zlib) : zlib_(zlib) {
    good_ = zlib_.deflateInit2_(&stream_, packing_level, Z_DEFLATED, -15, 8, Z_DEFAULT_STRATEGY, ZLIB_VERSION, int(sizeof stream_)) == Z_OK;
  }
  Deflater(const Deflater&) = delete;
  Deflater& operator=(const Deflater&) = delete;
  ~Deflater() { zlib_.deflateEnd(&stream_); }

  bool take(std::string_view bytes, int flush) {
    if (!bytes.empty()) crc_ = zlib_.crc32(crc_, reinterpret_cast<const Bytef*>(bytes.data()), uInt(bytes.size()));
    length_ += bytes.size();
    stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    stream_.avail_in = uInt(bytes.size());
    do {
      char piece[1 << 15];
      stream_.next_out = reinterpret_cast<Bytef*>(piece);
      stream_.avail_out = sizeof piece;
      good_ = good_ && zlib_.deflate(&stream_, flush) != Z_STREAM_ERROR;
      packed_.append(piece, sizeof piece - stream_.avail_out);
    } while (good_ && stream_.avail_out == 0);
    return good_ && length_ <= max_bytes;
  }
  const std::string& packed() const { return packed_; }
  std::size_t length() const { return length_; }
  std::uint32_t crc() const { return std::uint32_t(crc_); }

 private:
  const Zlib& zlib_;
  z_stream stream_{};
  std::string packed_;
  std::size_t length_ = 0;
  uLong crc_ = 0;
  bool good_ = false;
};

}  // namespace

bool ZipWriter::put(const std::string& bytes) {
  written_ += bytes.size();
  return sink_(bytes);
}

std::string ZipWriter::add(const std::string& name, const std::function<bool(const ByteSink&)>& content) {
  const Zlib* const zlib = zlib_library();
  if (zlib == nullptr) return translated(texts::zip_file::no_zlib);
  Deflater deflater(*zlib);
  const bool whole = content([&](std::string_view bytes) { return deflater.take(bytes, Z_NO_FLUSH); }) && deflater.take({}, Z_FINISH);
  if (written_ + deflater.packed().size() + name.size() > max_bytes || deflater.length() > max_bytes)
    return translated(texts::zip_file::too_long_to_write);
  if (!whole) return translated(texts::zip_file::not_written);
  std::string sizes;  // the fields that both headers of a file contain
  put_le(sizes, 0, 2), put_le(sizes, deflate, 2), put_le(sizes, first_day, 4), put_le(sizes, deflater.crc(), 4);
  put_le(sizes, std::uint32_t(deflater.packed().size()), 4), put_le(sizes, std::uint32_t(deflater.length()), 4);
  put_le(sizes, std::uint32_t(name.size()), 2), put_le(sizes, 0, 2);
  put_le(directory_, 0x02014b50, 4), put_le(directory_, version, 2), put_le(directory_, version, 2);
  directory_ += sizes;
  put_le(directory_, 0, 2), put_le(directory_, 0, 2), put_le(directory_, 0, 2), put_le(directory_, 0, 4);
  put_le(directory_, std::uint32_t(written_), 4);
  directory_ += name;
  ++count_;
  std::string local;
  put_le(local, 0x04034b50, 4), put_le(local, version, 2);
  return put(local + sizes + name) && put(deflater.packed()) ? std::string() : translated(texts::zip_file::not_written);
}

std::string ZipWriter::finish() {
  if (written_ + directory_.size() > max_bytes) return translated(texts::zip_file::too_long_to_write);
  std::string end = directory_;
  put_le(end, 0x06054b50, 4), put_le(end, 0, 4), put_le(end, count_, 2), put_le(end, count_, 2);
  put_le(end, std::uint32_t(directory_.size()), 4), put_le(end, std::uint32_t(written_), 4), put_le(end, 0, 2);
  return put(end) ? std::string() : translated(texts::zip_file::not_written);
}

}  // namespace kadr
