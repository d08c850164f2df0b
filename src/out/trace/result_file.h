#pragma once
// ResultFile: a file that a command leaves behind. It stands in its place whole, or not at all.
//
//   open   a regular file: written beside its place, under a name of its own; a pipe, terminal or device: straight
//   keep   takes its place, through links, with the rights of what was there
//   else   it goes away, and what was there stays

#include <cstdio>
#include <string>
#include <tl/expected.hpp>

namespace kadr {

/// Whether all that was written has come out; writes what still waits.
///   returns  an errno, EPIPE where the reader has gone, at whatever writing it was noticed; 0: all is out
int error_of(std::FILE* file);

class ResultFile {
 public:
  /// `name`: "-" is standard output, as is any name of what that goes to.
  ///   returns  an error sentence: it can never be written there
  static tl::expected<ResultFile, std::string> open(const std::string& name);

  ResultFile(ResultFile&& other) noexcept;
  ResultFile& operator=(ResultFile&& other) noexcept;
  ~ResultFile() { discard(); }

  std::FILE* get() const { return file_; }
  const std::string& name() const { return name_; }

  /// It is complete. An error sentence: not all could be written; what was there stays. An empty one: its reader has gone (`| head`), of
  /// which nothing is said.
  tl::expected<void, std::string> keep();
  void discard();

  /// Of a process that must end at once: all that is not kept goes away. Nothing may be opened or kept afterwards.
  static void discard_all();

 private:
  explicit ResultFile(std::string name) : name_(std::move(name)) {}
  tl::expected<void, std::string> open_beside();
  bool take_place() const;

  std::string name_;
  std::string place_;   // the true path; empty: written straight
  std::string beside_;  // where it is until it is kept
  std::FILE* file_ = nullptr;
  bool owned_ = false;  // else a standard stream
};

}  // namespace kadr
