// Stores sweeps as runs of consecutive sweeps, with the end points in pages of a fixed size. Used by stock/stock.

#include "stock/kept_sweeps.h"

#include <algorithm>
#include <cstring>

namespace kadr {

std::size_t KeptSweeps::run_of(std::size_t i) const {
  const std::size_t page = i / Page::places, known = pages_[page]->run;
  const std::size_t end = page + 1 < pages_.size() ? std::size_t(pages_[page + 1]->run) + 1 : runs_.size();
  if (known + 1 == end) return known;
  const auto later = std::upper_bound(runs_.begin() + std::ptrdiff_t(known) + 1, runs_.begin() + std::ptrdiff_t(end), i,
                                      [](std::size_t number, const Run& run) { return number < run.first; });
  return std::size_t(later - runs_.begin()) - 1;
}

KeptSweep KeptSweeps::in_run(std::size_t i, const Run& run) const {
  const Place &from = i == run.first ? run.from : to(i - 1), &end = to(i);
  return {{from.at[0], from.at[1], from.at[2]}, {end.at[0], end.at[1], end.at[2]}, run.tool, run.watched, run.leans};
}

KeptSweep KeptSweeps::operator[](std::size_t i) const { return in_run(i, runs_[run_of(i)]); }

void KeptSweeps::push_back(const KeptSweep& s) {
  const Place from{{s.from[0], s.from[1], s.from[2]}};
  const auto goes_on = [&] {
    const Run& last = runs_.back();
    return last.tool == s.tool && last.watched == s.watched && last.leans == s.leans &&
           std::memcmp(&to(size_ - 1), &from, sizeof from) == 0;
  };
  if (runs_.empty() || !goes_on()) runs_.push_back({std::uint32_t(size_), from, s.tool, s.watched, s.leans});
  if (size_ % Page::places == 0) {
    pages_.emplace_back(new Page);  // The new page is not initialised, which saves time: each end point is written before it is read.
    pages_.back()->run = std::uint32_t(runs_.size() - 1);
  }
  pages_.back()->to[size_ % Page::places] = {{s.to[0], s.to[1], s.to[2]}};
  ++size_;
}

KeptSweeps KeptSweeps::first(std::size_t count) const {
  KeptSweeps all;
  all.size_ = count;
  for (std::size_t page = 0; page * Page::places < count; ++page) all.pages_.push_back(std::make_unique<Page>(*pages_[page]));
  if (count > 0) all.runs_.assign(runs_.begin(), runs_.begin() + std::ptrdiff_t(run_of(count - 1)) + 1);
  return all;
}

std::size_t KeptSweeps::bytes() const { return pages_.size() * sizeof(Page) + runs_.size() * sizeof(Run); }

}  // namespace kadr
