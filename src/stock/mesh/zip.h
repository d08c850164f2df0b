#pragma once
// Reads and writes ZIP archives, as far as 3MF needs them (PKWARE, APPNOTE.TXT 6.3). Files in an archive are stored or deflated, without a
// password. Kadr writes only archives smaller than 4 GB.

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
  std::uint64_t local;             // position of the local header of this entry in the archive, bytes
};

/// Reads the directory of an archive.
///   returns  the entries, or an error sentence if the text is not an archive, is truncated, or contains too many files
tl::expected<std::vector<ZipEntry>, std::string> zip_entries(std::string_view archive);

/// Unpacks one file of an archive.
///   most     greatest unpacked size in bytes; checked while unpacking, because the directory may give a wrong size
///   returns  the content, or an error sentence if the file is too long, is damaged, or has an unknown method
tl::expected<std::string, std::string> zip_file(std::string_view archive, const ZipEntry& entry, std::size_t most);

/// Writes an archive, one file after the other.
class ZipWriter {
 public:
  explicit ZipWriter(const ByteSink& sink) : sink_(sink) {}
  /// Adds a file. `content` must write the file to the given sink. The file is packed while it is written, and stays in memory until the
  /// packed file is complete.
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
