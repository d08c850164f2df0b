// Cuts a portion of a blank into a file, and joins such files. This file is used by cli/cut.

#include "cli/cut_portion.h"

#include <fmt/core.h>

#include <algorithm>
#include <cerrno>
#include <charconv>

#include "cli/cut_meshes.h"
#include "cli/job/terminal.h"
#include "config/read_file.h"
#include "session/cutting/cut_cells.h"
#include "stock/portion/portion.h"
#include "texts/cut_command.h"

namespace kadr::cli {
namespace {

constexpr int most_portions = 100'000;

/// The build that wrote a file; other builds may store other values.
std::string build() { return fmt::format("kadr {} portion 1", KADR_VERSION); }

/// Reads "2/4". Returns nullopt if the text is no portion.
std::optional<Portion> portion_of(const std::string& text) {
  Portion portion;
  const char* const end = text.data() + text.size();
  const auto number = std::from_chars(text.data(), end, portion.number);
  if (number.ec != std::errc() || number.ptr == end || *number.ptr != '/') return std::nullopt;
  const auto count = std::from_chars(number.ptr + 1, end, portion.count);
  const bool read = count.ec == std::errc() && count.ptr == end;
  return read && portion.number >= 1 && portion.number <= portion.count && portion.count <= most_portions ? std::optional(portion)
                                                                                                          : std::nullopt;
}

PortionHead head_of(const Portion& portion, const CutJob& job) {
  const Lattice whole(job.blank->box(), job.cell);
  return {portion, job.cell, {whole.bricks(0), whole.bricks(1), whole.bricks(2)}};
}

/// Returns the first option that cannot be used together with --portion or --join; nullptr if there is none.
const char* contradicting(const CutOptions& o) {
  if (!o.window.empty()) return "--window";
  if (!o.run.plot.empty()) return "--plot";
  if (!o.deviation.empty()) return "--deviation";
  if (o.simplify > 0) return "--simplify";
  if (o.portion.empty()) return nullptr;
  return !o.json.empty() ? "--json" : !o.blocks.empty() ? "--blocks" : nullptr;
}

}  // namespace

bool portion_options_fit(const CutOptions& o) {
  if (o.portion.empty() && o.join.empty()) return true;
  const char* const option = o.portion.empty() ? "--join" : "--portion";
  std::string fault;
  if (!o.portion.empty() && !o.join.empty()) fault = translated(texts::cut_command::not_with, "--portion", "--join");
  else if (!o.portion.empty() && !portion_of(o.portion)) fault = translated(texts::cut_command::no_portion, o.portion);
  else if (!(o.resolution > 0)) fault = translated(texts::cut_command::needs, option, "--resolution");
  else if (!o.portion.empty() && o.out.empty()) fault = translated(texts::cut_command::needs, option, "--out");
  else if (const char* const other = contradicting(o); other != nullptr) fault = translated(texts::cut_command::not_with, option, other);
  else if (!o.join.empty() && o.out.ends_with(".3mf")) fault = translated(texts::cut_command::joined_out_is_no_stl, o.out);
  if (!fault.empty()) complain(fault);
  return fault.empty();
}

bool find_bricks(const CutOptions& options, CutJob& job) {
  if (!options.portion.empty()) {
    job.bricks = bricks_of(Lattice(job.blank->box(), job.cell), *portion_of(options.portion));
    job.fixtures.clear();  // the process that joins the portions cuts the fixtures
  }
  if (!options.join.empty()) job.bricks = no_bricks;
  return true;
}

PortionOutput::PortionOutput(const CutOptions& options, const Outputs& outputs, CutJob& job)
    : name_(options.out), writer_(sink_of(outputs.stream("--out"))) {
  writer_.begin(head_of(*portion_of(options.portion), job), build());
  job.on_portion_cut = [this](const PortionCut& cut) { writer_.add(cut); };
}

int PortionOutput::finish(const CutJob& job, const Cutting& cutting, const std::optional<Mesh>& part, Outputs& outputs) {
  if (cutting.has_threads()) {
    complain(translated(texts::cut_command::portion_of_threads));
    return wrong_usage;
  }
  const Stock& stock = cutting.stock();
  const bool any = stock.lattice().size() > 0;
  const Surface surface = any ? surface_of(stock) : Surface();
  const PartComparison held = any && part ? compare_with_part(job, stock, surface, *part) : PartComparison();
  writer_.finish(surface, stock.fingerprint(), part ? &held : nullptr);
  if (!writer_.complete()) {
    complain_of_writing(name_, errno);
    return wrong_usage;
  }
  return outputs.keep() ? ok : wrong_usage;
}

std::unique_ptr<PortionInputs> PortionInputs::open(const CutOptions& options, CutJob& job) {
  auto inputs = std::make_unique<PortionInputs>();
  std::vector<PortionHead> heads;
  for (const std::string& name : options.join) {
    inputs->files_.emplace_back(std::fopen(name.c_str(), "rb"), [](std::FILE* file) { return file == nullptr ? 0 : std::fclose(file); });
    std::FILE* const file = inputs->files_.back().get();
    if (file == nullptr) {
      complain(fmt::format("--join {}: {}", name, errno_message(errno)));
      return nullptr;
    }
    inputs->readers_.emplace_back(
        [file](std::span<char> bytes) { return std::fread(bytes.data(), 1, bytes.size(), file) == bytes.size(); });
    const auto head = inputs->readers_.back().begin(build());
    if (!head) {
      complain(translated(texts::cut_command::no_portion_file, name));
      return nullptr;
    }
    heads.push_back(*head);
  }
  if (!inputs->fits(heads, job)) {
    complain(translated(texts::cut_command::portions_differ));
    return nullptr;
  }
  job.portion_cuts = [all = inputs.get()] {
    std::vector<PortionCut> cuts;
    for (PortionReader& reader : all->readers_) cuts.push_back(reader.next_cut());
    return cuts;
  };
  return inputs;
}

/// Returns true if the files are all portions of the lattice that the options describe, each once.
bool PortionInputs::fits(const std::vector<PortionHead>& heads, const CutJob& job) const {
  std::vector<int> numbers;
  for (const PortionHead& head : heads) {
    if (head != head_of(head.portion, job) || head.portion.count != int(heads.size())) return false;
    numbers.push_back(head.portion.number);
  }
  std::sort(numbers.begin(), numbers.end());
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (numbers[i] != int(i) + 1) return false;
  return true;
}

/// Reads the ends of all portions. Prints an error and returns nullopt if a file is damaged, or was cut with other paths.
std::optional<std::vector<PortionEnd>> PortionInputs::ends(const CutOptions& options, const Cutting& cutting) {
  std::vector<PortionEnd> ends;
  for (std::size_t i = 0; i < readers_.size(); ++i) {
    auto end = readers_[i].end();
    const bool other = end && (end->fingerprint != cutting.stock().fingerprint() || end->comparison.has_value() != !options.part.empty());
    if (!end || other) {
      complain(other ? translated(texts::cut_command::portions_differ) : translated(texts::cut_command::no_portion_file, options.join[i]));
      return std::nullopt;
    }
    ends.push_back(std::move(*end));
  }
  return ends;
}

std::optional<Joined> PortionInputs::join(const CutOptions& options, const Outputs& outputs, const Cutting& cutting) {
  const auto ends = this->ends(options, cutting);
  if (!ends) return std::nullopt;
  Joined all;
  std::uint64_t triangles = 0;
  std::vector<PartComparison> comparisons;
  for (const PortionEnd& end : *ends) {
    triangles += end.triangles;
    if (end.comparison) comparisons.push_back(*end.comparison);
  }
  all.held = join_comparisons(std::move(comparisons));
  std::FILE* const file = outputs.stream("--out");
  StlWriter stl(sink_of(file), std::uint32_t(triangles));
  all.surface = join_surfaces(readers_, *ends, file != nullptr ? &stl : nullptr);
  if (file != nullptr && !stl.finish()) {
    complain_of_writing(options.out, errno);
    return std::nullopt;
  }
  for (std::size_t i = 0; i < readers_.size(); ++i)
    if (!readers_[i].is_sound()) {
      complain(translated(texts::cut_command::no_portion_file, options.join[i]));
      return std::nullopt;
    }
  return all;
}

}  // namespace kadr::cli
