// SPDX-License-Identifier: BSD-2-Clause
// A scene from XMT-A: what the library links for it (the XML parser) comes with the package.
#include <bifs/xmt_reader.h>

#include <cstdio>

int main() {
  afx::Diagnostics warnings;
  const auto scene = afx::bifs::read_xmt(
      "<XMT-A><Body><Replace><Scene><Group DEF=\"top\"/></Scene></Replace></Body></XMT-A>", {},
      warnings);
  if (!scene.ok()) return std::puts(to_string(scene.error()).c_str()), 1;
  std::printf("nodes %zu\n", scene.value().scene.node_count());
}
