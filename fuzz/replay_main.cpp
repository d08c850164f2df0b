// Runs a fuzz target on every file of the given folders, without libFuzzer: replay_NAME FOLDER...
// A missing or empty folder is an error, so that a test with a wrong folder fails.
//
//   replay_NAME --mutants COUNT [--first N] FOLDER...
//
// runs the target on COUNT changed inputs instead, made of pieces of the files. Without libFuzzer's bookkeeping this is several times
// faster where the target itself is fast. Mutant N is always the same; if the target crashes, the last line names N.
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <random>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

// The buffer is exactly as long as the file: the address sanitizer then sees a read beyond its end.
bool replay(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  if (!in.is_open() || in.bad()) {
    std::fprintf(stderr, "%s: cannot be read\n", file.c_str());
    return false;
  }
  const auto exact = std::make_unique<std::uint8_t[]>(bytes.size());
  for (std::size_t i = 0; i < bytes.size(); ++i) exact[i] = static_cast<std::uint8_t>(bytes[i]);
  // If the target crashes, the last line printed names the file.
  std::printf("%s\n", file.c_str());
  std::fflush(stdout);
  LLVMFuzzerTestOneInput(exact.get(), bytes.size());
  return true;
}

/// The mutants of the files in some folders.
class Mutants {
 public:
  bool read(const std::filesystem::path& folder) {
    std::error_code error;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder, error)) {
      if (!entry.is_regular_file()) continue;
      std::ifstream in(entry.path(), std::ios::binary);
      files_.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
      if (files_.back().empty()) files_.pop_back();
    }
    if (files_.empty()) std::fprintf(stderr, "%s: no such folder, or no file in it\n", folder.c_str());
    return !files_.empty() && !error;
  }

  /// Returns mutant `number`: the beginning of one file and a piece of another one, with some bytes changed.
  const std::string& make(std::uint64_t number) {
    random_.seed(static_cast<std::minstd_rand::result_type>(number * 2'654'435'761U % 2'147'483'646U + 1));
    const std::string& head = files_[below(files_.size())];
    const std::string& tail = files_[below(files_.size())];
    made_.assign(head, 0, 1 + below(std::min(head.size(), longest)));
    const std::size_t from = below(tail.size());
    if (below(2) == 0) made_.append(tail, from, longest - made_.size());
    for (std::size_t changes = below(6); changes > 0; --changes) {
      const std::size_t at = below(made_.size());
      switch (below(4)) {
        case 0: made_[at] = static_cast<char>(below(256)); break;
        case 1: made_[at] = static_cast<char>(made_[at] ^ static_cast<char>(1U << below(8))); break;
        case 2: made_.erase(at, 1 + below(4)); break;
        default: made_.insert(at, 1, static_cast<char>(below(256)));
      }
      if (made_.empty()) made_ = "0";
    }
    return made_;
  }

 private:
  static constexpr std::size_t longest = 512;
  std::size_t below(std::size_t most) { return random_() % most; }

  std::vector<std::string> files_;
  std::minstd_rand random_;
  std::string made_;
};

volatile std::sig_atomic_t crashed = 0;
std::uint64_t mutant_number = 0;

/// Names the mutant at which the target crashed. Only calls that a signal handler may make.
extern "C" void name_mutant(int signal) {
  if (crashed == 0) {
    crashed = 1;
    char text[] = "mutant 00000000000000000000\n";
    std::size_t at = sizeof text - 3;
    for (std::uint64_t left = mutant_number; left > 0; left /= 10) text[at--] = static_cast<char>('0' + left % 10);
    (void)!::write(STDERR_FILENO, text, sizeof text - 1);
  }
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

bool run_mutants(Mutants& mutants, std::uint64_t count, std::uint64_t first) {
  for (const int signal : {SIGABRT, SIGSEGV, SIGFPE, SIGILL, SIGALRM}) std::signal(signal, name_mutant);
  constexpr unsigned longest_run = 10;          // s
  constexpr std::uint64_t between = 1'000'000;  // mutants between two lines
  for (mutant_number = first; mutant_number < first + count; ++mutant_number) {
    if ((mutant_number - first) % 1024 == 0) ::alarm(longest_run);  // a target that hangs
    const std::string& bytes = mutants.make(mutant_number);
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
    if ((mutant_number + 1 - first) % between != 0) continue;
    std::printf("%llu\n", static_cast<unsigned long long>(mutant_number + 1 - first));
    std::fflush(stdout);
  }
  ::alarm(0);
  std::printf("%llu mutants, no finding\n", static_cast<unsigned long long>(count));
  return true;
}

bool replay_folder(const std::filesystem::path& folder) {
  std::error_code error;
  bool all_read = true;
  int files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder, error)) {
    if (!entry.is_regular_file()) continue;
    all_read = replay(entry.path()) && all_read;
    ++files;
  }
  if (files == 0) std::fprintf(stderr, "%s: no such folder, or no file in it\n", folder.c_str());
  return all_read && files > 0 && !error;
}

}  // namespace

int main(int count, char** arguments) {
  std::uint64_t mutants = 0, first = 0;
  std::vector<std::string> folders;
  for (int i = 1; i < count; ++i) {
    const std::string_view word = arguments[i];
    const bool has_value = i + 1 < count;
    if (word == "--mutants" && has_value) mutants = std::strtoull(arguments[++i], nullptr, 10);
    else if (word == "--first" && has_value) first = std::strtoull(arguments[++i], nullptr, 10);
    else folders.emplace_back(word);
  }
  bool good = !folders.empty();
  if (mutants == 0) {
    for (const std::string& folder : folders) good = replay_folder(folder) && good;
    return good ? 0 : 1;
  }
  Mutants made;
  for (const std::string& folder : folders) good = made.read(folder) && good;
  return good && run_mutants(made, mutants, first) ? 0 : 1;
}
