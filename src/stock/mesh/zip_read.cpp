// Reads the directory of an archive, and unpacks its files up to a size limit. Used by stock/mesh/threemf_read.

#include <algorithm>

#include "stock/mesh/mesh_word_reader.h"
#include "stock/mesh/zip.h"
#include "stock/mesh/zlib_library.h"
#include "texts/zip_file.h"

namespace kadr {
namespace {

using Failed = tl::unexpected<std::string>;

constexpr std::size_t end_bytes = 22, entry_bytes = 46, local_bytes = 30, longest_comment = 65535;
constexpr std::uint32_t end_mark = 0x06054b50, entry_mark = 0x02014b50, local_mark = 0x04034b50;
constexpr std::uint32_t end64_mark = 0x06064b50, locator64_mark = 0x07064b50;
constexpr std::size_t end64_bytes = 56, locator64_bytes = 20;
// A four-byte number of this value means that the true number is stored with eight bytes in the ZIP64 record.
constexpr std::uint64_t in_zip64 = 0xffffffff;
constexpr std::size_t max_files = 10'000;
constexpr std::uint16_t stored = 0, deflated = 8, has_password = 1;

/// Returns a little-endian number; bytes beyond the end of the text count as 0.
std::uint64_t le_number(std::string_view bytes, std::size_t at, std::size_t size) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < size && at + i < bytes.size(); ++i)
    value |= std::uint64_t(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
  return value;
}

Failed cut_off() { return Failed(translated(texts::zip_file::damaged)); }

/// Returns the position of the archive's end record; npos if the archive has no end record.
std::size_t end_of_directory(std::string_view archive) {
  if (archive.size() < end_bytes) return std::string_view::npos;
  const std::size_t last = archive.size() - end_bytes, first = last > longest_comment ? last - longest_comment : 0;
  for (std::size_t at = last + 1; at-- > first;)
    if (le_number(archive, at, 4) == end_mark) return at;
  return std::string_view::npos;
}

struct Directory {
  std::uint64_t count, first;  // count: number of files in the archive; first: position of the first entry of the directory, in bytes
};

/// Finds the directory of the archive. The position of the directory is read from the ZIP64 record too, because some programs write
/// eight-byte numbers even if four bytes would suffice.
Directory directory_at(std::string_view archive, std::size_t end) {
  const Directory plain{le_number(archive, end + 10, 2), le_number(archive, end + 16, 4)};
  if (plain.first != in_zip64 || end < locator64_bytes || le_number(archive, end - locator64_bytes, 4) != locator64_mark) return plain;
  const std::uint64_t at = le_number(archive, end - locator64_bytes + 8, 8);
  if (at > end || end - at < end64_bytes || le_number(archive, std::size_t(at), 4) != end64_mark) return plain;
  return {le_number(archive, std::size_t(at) + 32, 8), le_number(archive, std::size_t(at) + 48, 8)};
}

/// Reads the numbers of an entry that do not fit into four bytes. The ZIP64 record in the extra fields contains only these numbers, in the
/// order: unpacked size, packed size, position of the local header.
void take_zip64(std::string_view extra, ZipEntry& entry) {
  for (std::size_t at = 0; at + 4 <= extra.size();) {
    const std::size_t size = std::size_t(le_number(extra, at + 2, 2));
    if (le_number(extra, at, 2) == 1) {
      std::size_t next = at + 4;
      for (std::uint64_t* const value : {&entry.unpacked, &entry.packed, &entry.local})
        if (*value == in_zip64) *value = le_number(extra, next, 8), next += 8;
    }
    at += 4 + size;
  }
}

/// Unpacks in steps, until the data ends or the result exceeds the limit.
tl::expected<std::string, std::string> inflated(std::string_view packed, std::size_t most, const Failed& too_long) {
  const Zlib* const zlib = zlib_library();
  if (zlib == nullptr) return Failed(translated(texts::zip_file::no_zlib));
  z_stream stream{};
  constexpr int raw_window = -15;  // the negative window size means that the data has no zlib header
  if (zlib->inflateInit2_(&stream, raw_window, ZLIB_VERSION, int(sizeof stream)) != Z_OK) return cut_off();
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  stream.avail_in = uInt(packed.size());
  std::string out;
  constexpr std::size_t step = std::size_t(1) << 20;
  int state = Z_OK;
  while (state == Z_OK && out.size() <= most) {
    const std::size_t before = out.size(), more = std::min(step, most + 1 - before);
    out.resize(before + more);
    stream.next_out = reinterpret_cast<Bytef*>(out.data() + before);
    stream.avail_out = uInt(more);
    state = zlib->inflate(&stream, Z_NO_FLUSH);
    out.resize(out.size() - stream.avail_out);
    if (out.size() == before && state == Z_OK) state = Z_DATA_ERROR;  // a step without progress means that the data is damaged
  }
  zlib->inflateEnd(&stream);
  if (out.size() > most) return too_long;
  if (state != Z_STREAM_END) return cut_off();
  return out;
}

}  // namespace

tl::expected<std::vector<ZipEntry>, std::string> zip_entries(std::string_view archive) {
  const std::size_t end = end_of_directory(archive);
  if (end == std::string_view::npos) return cut_off();
  const Directory directory = directory_at(archive, end);
  if (directory.count > max_files) return Failed(translated(texts::zip_file::too_many_files));
  if (directory.first > end) return cut_off();
  std::vector<ZipEntry> entries;
  std::size_t at = std::size_t(directory.first);
  for (std::uint64_t i = 0; i < directory.count; ++i) {
    if (at + entry_bytes > end || le_number(archive, at, 4) != entry_mark) return cut_off();
    const std::size_t name = le_number(archive, at + 28, 2), extra = le_number(archive, at + 30, 2), rest = le_number(archive, at + 32, 2);
    if (at + entry_bytes + name + extra + rest > end) return cut_off();
    if ((le_number(archive, at + 8, 2) & has_password) != 0) return Failed(translated(texts::zip_file::has_password));
    ZipEntry entry{archive.substr(at + entry_bytes, name),
                   std::uint16_t(le_number(archive, at + 10, 2)),
                   std::uint32_t(le_number(archive, at + 16, 4)),
                   le_number(archive, at + 20, 4),
                   le_number(archive, at + 24, 4),
                   le_number(archive, at + 42, 4)};
    take_zip64(archive.substr(at + entry_bytes + name, extra), entry);
    entries.push_back(entry);
    at += entry_bytes + name + extra + rest;
  }
  return entries;
}

tl::expected<std::string, std::string> zip_file(std::string_view archive, const ZipEntry& entry, std::size_t most) {
  const Failed too_long(translated(texts::zip_file::file_too_long, shown(entry.name), most));
  if (entry.unpacked > most) return too_long;
  if (archive.size() < local_bytes || entry.local > archive.size() - local_bytes) return cut_off();
  const std::size_t local = std::size_t(entry.local);
  if (le_number(archive, local, 4) != local_mark) return cut_off();
  const std::size_t begin = local + local_bytes + le_number(archive, local + 26, 2) + le_number(archive, local + 28, 2);
  if (begin > archive.size() || entry.packed > archive.size() - begin) return cut_off();
  const std::string_view packed = archive.substr(begin, std::size_t(entry.packed));
  tl::expected<std::string, std::string> out;
  if (entry.method == deflated) out = inflated(packed, most, too_long);
  else if (entry.method == stored && packed.size() <= most) out = std::string(packed);
  else return Failed(translated(texts::zip_file::unknown_packing, entry.method));
  if (!out) return out;
  const Zlib* const zlib = zlib_library();
  if (zlib != nullptr && zlib->crc32(0, reinterpret_cast<const Bytef*>(out->data()), uInt(out->size())) != entry.crc) return cut_off();
  return out;
}

}  // namespace kadr
