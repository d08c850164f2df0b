// Runs a fuzz target on every file of the given folders, without libFuzzer: replay_NAME FOLDER...
// A missing or empty folder is an error, so that a test with a wrong folder fails.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
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
  bool good = count > 1;
  for (int i = 1; i < count; ++i) good = replay_folder(arguments[i]) && good;
  return good ? 0 : 1;
}
