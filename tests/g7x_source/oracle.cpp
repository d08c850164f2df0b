// The oracle of tests/lathe_oracle.py: reads a profile and a cycle and prints the motions that LinuxCNC's source computes for it.
// dev/g7x_oracle compiles this file behind interp_g7x.cc, of which it uses g7x, motion_base, straight_segment and round_segment.
//
// Input, numbers of mm, X as a radius: cycle (71, 72), subcycle (0, 1, 2), start Z X, distance D, depth I, retract R; then a piece a line:
//   L Z X                     a line to (Z, X)
//   A ccw Zc Xc Z X           an arc around (Zc, Xc)
// Output: R Z X (rapid), F Z X (feed), A ccw Zc Xc Z X; or ! and the text of the alarm.
#include <cstdio>
#include <cstring>
#include <iostream>
#include <string>

using Point = std::complex<double>;

struct Printed : motion_base {
  Point at;
  explicit Printed(Point start) : at(start) {}
  void straight_move(Point end) override { line('F', end); }
  void straight_rapid(Point end) override { line('R', end); }
  void line(char kind, Point end) {
    std::printf("%c %.12g %.12g\n", kind, end.real(), end.imag());
    at = end;
  }
  template <class Sense>
  void arc(Sense ccw, Point center, Point end) {
    if (std::abs(end - at) < 1e-9) return;
    std::printf("A %d %.12g %.12g %.12g %.12g\n", ccw ? 1 : 0, center.real(), center.imag(), end.real(), end.imag());
    at = end;
  }
  void circular_move(KADR_SENSE ccw, Point center, Point end) override { arc(ccw, center, end); }
};

int main() {
  int cycle = 0, subcycle = 0;
  double z = 0, x = 0, d = 0, i = 1, r = 0.5;
  std::cin >> cycle >> subcycle >> z >> x >> d >> i >> r;
  g7x path;
  const Point begin(z, x);
  Point start = begin;
  Point first_way, last_way;
  for (std::string kind; std::cin >> kind;) {
    int ccw = 0;
    double zc = 0, xc = 0, ze = 0, xe = 0;
    if (kind == "A") std::cin >> ccw >> zc >> xc;
    std::cin >> ze >> xe;
    const Point end(ze, xe);
    if (kind == "A") path.emplace_back(std::make_unique<round_segment>(ccw, start, Point(zc, xc), end));
    else path.emplace_back(std::make_unique<straight_segment>(start, end));
    if (start == begin) first_way = end - start;
    last_way = end - start;
    start = end;
  }
  // A profile that leads away from the start and does not end square to the cuts is closed up to the level of the start
  const bool facing = cycle == 72;
  const double along = facing ? last_way.imag() : last_way.real();
  const double away = facing ? first_way.real() * (z - start.real()) : first_way.imag() * (x - start.imag());
  if (std::abs(along) > 0 && away < 0)
    path.emplace_back(std::make_unique<straight_segment>(start, facing ? Point(z, start.imag()) : Point(start.real(), x)));
  Printed out(begin);
  try {
    facing ? path.do_g72(&out, subcycle, x, z, 0, 0, d, i, r) : path.do_g71(&out, subcycle, x, z, 0, 0, d, i, r);
  } catch (std::string& text) {
    std::printf("! %s\n", text.c_str());
  }
}
