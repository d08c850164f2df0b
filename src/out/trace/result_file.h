#pragma once
// ResultFile: a file that a command writes. It appears complete or not at all.
//
//   open   a regular file is opened under a temporary name in the same folder; a pipe, terminal or device is opened directly
//   keep   moves the temporary file to the final path, through links, with the permissions of the file that it replaces
//   else   deletes the temporary file; an existing file at the final path stays unchanged

#include <cstdio>
#include <string>
#include <tl/expected.hpp>

namespace kadr {

/// Writes the buffered data and checks that all data was written.
///   returns  an errno; EPIPE if the reader of a pipe has closed it, even if an earlier write noticed that; 0: everything is written
int error_of(std::FILE* file);

class ResultFile {
 public:
  ///   name     "-" is standard output, and so is any name of the file that standard output is redirected to
  ///   returns  an error sentence if no file can be written at this path
  static tl::expected<ResultFile, std::string> open(const std::string& name);

  ResultFile(ResultFile&& other) noexcept;
  ResultFile& operator=(ResultFile&& other) noexcept;
  ~ResultFile() { discard(); }

  std::FILE* get() const { return file_; }
  const std::string& name() const { return name_; }

  /// Completes the file. Returns an error sentence if not all data was written (an existing file stays unchanged), and an empty one if
  /// the reader of a pipe has closed it (`| head`), which is not reported to the user.
  tl::expected<void, std::string> keep();
  void discard();

  /// For a process that must end at once: deletes the temporary files of all ResultFiles that were not kept. Afterwards nothing may be
  /// opened or kept.
  static void discard_all();

 private:
  explicit ResultFile(std::string name) : name_(std::move(name)) {}
  tl::expected<void, std::string> open_temporary();
  bool take_place() const;

  std::string name_;
  std::string place_;   // the final path, with links resolved; empty: the file is written directly
  std::string beside_;  // the temporary path, until the file is kept
  std::FILE* file_ = nullptr;
  bool owned_ = false;  // false: a standard stream, which is not closed
};

}  // namespace kadr
