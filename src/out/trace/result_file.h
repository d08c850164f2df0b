#pragma once
// ResultFile: a file that a command leaves behind. It appears complete or not at all.
//
//   open   a regular file: opened next to its final path, under a temporary name; a pipe, terminal or device: opened directly
//   keep   moves the file to its final path, through links, with the rights of the file that was there
//   else   the temporary file is deleted, and the file that was there stays

#include <cstdio>
#include <string>
#include <tl/expected.hpp>

namespace kadr {

/// Writes what is still buffered and checks that everything was written.
///   returns  an errno; EPIPE if the reader has gone, whichever write noticed it; 0 if all is written
int error_of(std::FILE* file);

class ResultFile {
 public:
  ///   name     "-" is standard output, and so is any name of the file that standard output goes to
  ///   returns  an error sentence if the file can never be written there
  static tl::expected<ResultFile, std::string> open(const std::string& name);

  ResultFile(ResultFile&& other) noexcept;
  ResultFile& operator=(ResultFile&& other) noexcept;
  ~ResultFile() { discard(); }

  std::FILE* get() const { return file_; }
  const std::string& name() const { return name_; }

  /// Marks the file as complete. Returns an error sentence if not all could be written (the file that was there stays), and an empty one if
  /// the reader has gone (`| head`), which is not reported.
  tl::expected<void, std::string> keep();
  void discard();

  /// For a process that must end at once: deletes all files that are not kept. Nothing may be opened or kept afterwards.
  static void discard_all();

 private:
  explicit ResultFile(std::string name) : name_(std::move(name)) {}
  tl::expected<void, std::string> open_beside();
  bool take_place() const;

  std::string name_;
  std::string place_;   // the final path, links resolved; empty: the file is written directly
  std::string beside_;  // the temporary path, until the file is kept
  std::FILE* file_ = nullptr;
  bool owned_ = false;  // false: a standard stream
};

}  // namespace kadr
