#pragma once
// ResultFile: a file that a command writes. The file appears complete or not at all.
//
//   open     opens a regular file under a temporary name in the same folder; opens a pipe, terminal or device directly
//   keep     moves the temporary file to the final path, through links, with the permissions of the file that it replaces
//   no keep  the temporary file is deleted; an existing file at the final path remains unchanged

#include <cstdio>
#include <string>
#include <tl/expected.hpp>

namespace kadr {

/// Writes the buffered data and checks that all data was written.
///   returns  an errno; EPIPE if the reader of a pipe has closed it, even if an earlier write noticed that; 0: all data was written
int error_of(std::FILE* file);

class ResultFile {
 public:
  /// Opens a file for writing.
  ///   name     name of the file; "-", or any name of the file to which standard output is redirected, is standard output
  ///   returns  an error sentence if no file can be written at this path
  static tl::expected<ResultFile, std::string> open(const std::string& name);

  ResultFile(ResultFile&& other) noexcept;
  ResultFile& operator=(ResultFile&& other) noexcept;
  ~ResultFile() { discard(); }

  std::FILE* get() const { return file_; }
  const std::string& name() const { return name_; }

  /// Completes the file. Returns an error sentence if not all data was written; then an existing file remains unchanged. The error sentence
  /// is empty if the reader of a pipe has closed it (`| head`), since the user need not know that.
  tl::expected<void, std::string> keep();
  void discard();

  /// Deletes the temporary files of all ResultFiles that have not been completed. This function is for a process that must end at once.
  /// Afterwards no ResultFile may be opened or completed.
  static void discard_all();

 private:
  explicit ResultFile(std::string name) : name_(std::move(name)) {}
  tl::expected<void, std::string> open_temporary();
  bool take_place() const;

  std::string name_;
  std::string place_;      // final path of the file, with links resolved; empty: the data is written directly to the file
  std::string temporary_;  // path of the temporary file, until keep() moves it
  std::FILE* file_ = nullptr;
  bool owned_ = false;  // false: the stream is a standard stream, which must not be closed
};

}  // namespace kadr
