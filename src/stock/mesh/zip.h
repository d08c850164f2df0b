#pragma once
// Reads and writes ZIP archives, as far as 3MF needs them (PKWARE, APPNOTE.TXT 6.3). Files in an archive are stored or deflated, without a
// password. Written archives are smaller than 4 GB.

#include <cstdint>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "stock/mesh/byte_sink.h"

namespace kadr {

struct ZipEntry {
  std::string_view name;
  std::uint16_t method;
  std::uint32_t crc;
  std::uint64_t packed, unpacked;  // size of the packed and of the unpacked file in bytes, according to the directory
  std::uint64_t local;             // position of the entry's local header
};

/// Reads the directory of an archive.
///   returns  the entries, or an error sentence: not an archive, truncated, too many files
tl::expected<std::vector<ZipEntry>, std::string> zip_entries(std::string_view archive);

/// Unpacks one file of an archive.
///   most     limit for the unpacked size in bytes; enforced while unpacking, whatever size the directory gives
///   returns  the content, or an error sentence: too long, damaged, unknown method
tl::expected<std::string, std::string> zip_file(std::string_view archive, const ZipEntry& entry, std::size_t most);

/// Writes an archive, one file after the other.
class ZipWriter {
 public:
  explicit ZipWriter(const ByteSink& sink) : sink_(sink) {}
  /// Adds a file. `content` must write the file to the given sink. It is packed while it is written, and the packed file stays in memory
  /// until it is complete.
  ///   returns  an error sentence; empty on success
  std::string add(const std::string& name, const std::function<bool(const ByteSink&)>& content);
  /// Writes the directory and closes the archive. Returns an error sentence; empty on success.
  std::string finish();

 private:
  bool put(const std::string& bytes);

  const ByteSink& sink_;
  std::string directory_;
  std::uint16_t count_ = 0;
  std::size_t written_ = 0;
};

}  // namespace kadr
