# SPDX-License-Identifier: BSD-2-Clause
# The front of a house as a Wavefront mesh with colours: awk -f facade.awk >facade.obj. It looks along +z.
function box(x0, y0, z0, x1, y1, z1, r, g, b,   first, k) {
  first = vertices + 1
  for (k = 0; k < 8; ++k) {
    printf "v %.4f %.4f %.4f %.3f %.3f %.3f\n", (k % 2 ? x1 : x0), (int(k / 2) % 2 ? y1 : y0), (k > 3 ? z1 : z0), r ^ 0.5, g ^ 0.5, b ^ 0.5
    ++vertices
  }
  quad(first, 4, 5, 7, 6); quad(first, 1, 0, 2, 3); quad(first, 5, 1, 3, 7)
  quad(first, 0, 4, 6, 2); quad(first, 6, 7, 3, 2); quad(first, 0, 1, 5, 4)
}
function quad(first, a, b, c, d) {
  printf "f %d %d %d\nf %d %d %d\n", first + a, first + b, first + c, first + a, first + c, first + d
}
function noise(i) { return (i * 7919 % 1009) / 1009 }
# Bricks, where there is no window.
function bricks(   row, i, x, y, tone) {
  for (row = 0; row < 92; ++row) {
    for (i = -1; i < 60; ++i) {
      x = -5 + (i + (row % 2) / 2) / 6
      y = row * 0.085
      if (x < -5.001 || x > 4.85 || is_open(x, y)) continue
      box(x, y, -0.4, x + 1 / 6, y + 0.085, -0.02, 0.6, 0.57, 0.52)
      tone = 0.75 + 0.25 * noise(row * 61 + i)
      box(x + 0.006, y + 0.006, -0.02, x + 0.16, y + 0.079, 0.02 * noise(row * 17 + i * 3), 0.62 * tone, 0.3 * tone, 0.22 * tone)
    }
  }
}
function is_open(x, y,   i, floor) {
  for (floor = 0; floor < 3; ++floor)
    for (i = 0; i < 5; ++i)
      if (!(floor == 0 && i == 2) && x > -4.72 + 2 * i && x < -3.3 + 2 * i && y > 0.68 + 2.5 * floor && y < 2.2 + 2.5 * floor) return 1
  return x > -0.9 && x < 0.75 && y < 2.3
}
function window_(x, y,   i, j) {
  box(x - 0.6, y, -0.34, x + 0.6, y + 1.5, -0.3, 0.25, 0.33, 0.42)
  for (i = -1; i <= 1; ++i) box(x + i * 0.56 - 0.04, y, -0.3, x + i * 0.56 + 0.04, y + 1.5, -0.24, 0.93, 0.92, 0.88)
  for (j = 0; j <= 2; ++j) box(x - 0.6, y + j * 0.71, -0.3, x + 0.6, y + j * 0.71 + 0.08, -0.24, 0.93, 0.92, 0.88)
  box(x - 0.78, y - 0.14, -0.3, x + 0.78, y, 0.16, 0.8, 0.78, 0.72)
  box(x - 0.74, y + 1.5, -0.3, x + 0.74, y + 1.66, 0.1, 0.8, 0.78, 0.72)
}
BEGIN {
  box(-5, 0, -0.6, 5, 7.9, -0.4, 0.55, 0.52, 0.48)
  bricks()
  for (floor = 0; floor < 3; ++floor)
    for (i = 0; i < 5; ++i)
      if (floor > 0 || i != 2) window_(-4 + 2 * i, 0.75 + 2.5 * floor)
  box(-0.75, 0, -0.3, 0.75, 2.2, -0.22, 0.22, 0.13, 0.08)
  for (i = 0; i < 4; ++i) box(-0.62 + 0.7 * (i % 2), 0.2 + int(i / 2), -0.22, -0.08 + 0.7 * (i % 2), 0.95 + int(i / 2), -0.18, 0.3, 0.18, 0.1)
  box(-1, 2.2, -0.2, 1, 2.42, 0.35, 0.82, 0.8, 0.74)
  for (i = -1; i <= 1; i += 2) box(i * 0.86 - 0.1, 0, -0.2, i * 0.86 + 0.1, 2.2, 0.24, 0.82, 0.8, 0.74)
  for (i = 0; i < 3; ++i) box(-1.2 - 0.15 * i, 0, 0, 1.2 + 0.15 * i, 0.3 - 0.1 * i, 0.4 + 0.2 * i, 0.6, 0.58, 0.55)
  for (floor = 1; floor < 3; ++floor) box(-5.05, 2.5 * floor - 0.02, -0.3, 5.05, 2.5 * floor + 0.1, 0.1, 0.8, 0.78, 0.72)
  box(-5.1, 7.7, -0.5, 5.1, 7.95, 0.3, 0.82, 0.8, 0.74)
  box(-5.2, 7.95, -0.5, 5.2, 8.1, 0.45, 0.75, 0.73, 0.68)
  for (i = 0; i < 34; ++i) box(-5 + i * 0.3, 7.5, -0.2, -4.86 + i * 0.3, 7.7, 0.2, 0.82, 0.8, 0.74)
}
