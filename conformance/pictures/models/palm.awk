# SPDX-License-Identifier: BSD-2-Clause
# A palm with thin leaves as a Wavefront mesh: awk -f palm.awk >palm.obj. Leaflets have no thickness.
function vertex(x, y, z, r, g, b) {
  printf "v %.5f %.5f %.5f %.3f %.3f %.3f\n", x, y, z, r ^ 0.6, g ^ 0.6, b ^ 0.6
  return ++vertices
}
function face(a, b, c) { printf "f %d %d %d\n", a, b, c }

# A ring of the trunk around (x, y, 0); returns the number of its first vertex.
function ring(x, y, radius, shade,   k, first) {
  first = vertices + 1
  for (k = 0; k < 16; ++k)
    vertex(x + radius * cos(k * pi / 8), y, radius * sin(k * pi / 8), 0.45 * shade, 0.33 * shade, 0.2 * shade)
  return first
}
function trunk(   i, k, below, here, t) {
  for (i = 0; i <= 60; ++i) {
    t = i / 60
    here = ring(0.25 * t * t, 2.6 * t, 0.11 - 0.05 * t + (i % 2) * 0.006, 0.75 + (i % 2) * 0.25)
    for (k = 0; i > 0 && k < 16; ++k) {
      face(below + k, here + k, here + (k + 1) % 16)
      face(below + k, here + (k + 1) % 16, below + (k + 1) % 16)
    }
    below = here
  }
}

# A frond bends down as it leaves the crown; leaflets stand on both sides of its rib.
function frond(angle, rise, length_,   i, t, along, x, y, z, px, py, pz, side, green, w, l) {
  for (i = 0; i <= 44; ++i) {
    t = i / 44
    along = length_ * t
    x = 0.25 + along * cos(angle) * cos(rise * (1 - t))
    z = along * sin(angle) * cos(rise * (1 - t))
    y = 2.6 + along * sin(rise) * (1 - t) - 0.75 * length_ * t * t
    if (i > 2) {
      green = 0.4 + 0.35 * t + 0.1 * (i % 3 - 1)
      for (side = -1; side <= 1; side += 2) {
        l = 0.42 * sin(pi * (0.12 + 0.86 * t)) + 0.02
        w = 0.016
        leaflet(x, y, z, px, py, pz, angle, side, l, w, green)
      }
      rib(px, py, pz, x, y, z, angle)
    }
    px = x; py = y; pz = z
  }
}
function leaflet(x, y, z, px, py, pz, angle, side, l, w, green,   ox, oz, fx, fz, a, b, c) {
  ox = -sin(angle) * side; oz = cos(angle) * side
  fx = cos(angle); fz = sin(angle)
  a = vertex(px, py, pz, 0.15, green * 0.8, 0.08)
  b = vertex(px + fx * w * 2, py + 0.004, pz + fz * w * 2, 0.15, green * 0.8, 0.08)
  c = vertex(x + ox * l + fx * l * 0.5, y - l * 0.35, z + oz * l + fz * l * 0.5, 0.35, green, 0.12)
  face(a, b, c)
}
function rib(px, py, pz, x, y, z, angle,   ox, oz, a, b, c, d) {
  ox = -sin(angle) * 0.012; oz = cos(angle) * 0.012
  a = vertex(px - ox, py, pz - oz, 0.4, 0.45, 0.15); b = vertex(px + ox, py, pz + oz, 0.4, 0.45, 0.15)
  c = vertex(x - ox, y, z - oz, 0.4, 0.45, 0.15); d = vertex(x + ox, y, z + oz, 0.4, 0.45, 0.15)
  face(a, b, d); face(a, d, c)
}
BEGIN {
  pi = atan2(0, -1)
  trunk()
  for (i = 0; i < 17; ++i) frond(i * 2.39996, 0.25 + 0.75 * ((i * 7) % 17) / 17, 1.25 + 0.25 * ((i * 5) % 3))
}
