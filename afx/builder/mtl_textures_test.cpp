// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/mtl_textures.h"

#include <gtest/gtest.h>

namespace afx {
namespace {

MtlTexture only(const std::string& line) {
  const MtlTextures textures = mtl_textures("newmtl a\n" + line);
  return textures.size() == 1 ? textures.begin()->second : MtlTexture{};
}

TEST(MtlTextures, TakesOneToThreeValuesAndLeavesTheFile) {
  for (const char* line :
       {"map_Kd -o 2 3 4 t.png", "map_Kd -o 2 3 t.png", "\tmap_kd  -o 2 3\tt.png\r\n"}) {
    EXPECT_EQ(only(line).file, "t.png") << line;
    EXPECT_EQ(only(line).offset, glm::vec2(2, 3)) << line;
    EXPECT_EQ(only(line).scale, glm::vec2(1, 1)) << line;
  }
  EXPECT_EQ(only("map_Kd -s 2 t.png").scale, glm::vec2(2, 1));
  EXPECT_EQ(only("map_Kd -o 2 3 4 5").file, "5");
  EXPECT_EQ(only("map_Kd -o 2 3").file, "3");
}

TEST(MtlTextures, PassesOverOtherOptions) {
  const MtlTexture texture =
      only("map_Kd -clamp on -s 2 2 2 -mm 0 1 -blendu off -t 1 1 -texres 64 my file.png");
  EXPECT_EQ(texture.file, "my file.png");
  EXPECT_EQ(texture.scale, glm::vec2(2, 2));
  EXPECT_EQ(texture.offset, glm::vec2(0, 0));
}

TEST(MtlTextures, AreThoseWithSuchOptionsOnly) {
  EXPECT_TRUE(mtl_textures("newmtl a\nmap_Kd -clamp on t.png\nmap_Ks -o 1 1 1 t.png\n").empty());
  EXPECT_TRUE(mtl_textures("newmtl a\nmap_Kd -o\nmap_Kd\nmap_Kd -").empty());
  const MtlTextures two =
      mtl_textures("newmtl a b\nmap_Kd -o 1 t.png\nnewmtl c\nmap_Kd -s 2 u.png\n");
  ASSERT_EQ(two.size(), 2U);
  EXPECT_EQ(two.at("a b").file, "t.png");
  EXPECT_EQ(two.at("c").file, "u.png");
}

}  // namespace
}  // namespace afx
