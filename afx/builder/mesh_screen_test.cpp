// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/mesh_screen.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

namespace afx {
namespace {

Status screen(const std::string& path, std::string_view text) {
  return screen_mesh_file(path, {reinterpret_cast<const uint8_t*>(text.data()), text.size()},
                          Limits());
}

std::string text_of(const Status& status) { return status.ok() ? "ok" : status.error().text; }

std::string repeated(std::string_view text, int count) {
  std::string result;
  for (int i = 0; i < count; ++i) result += text;
  return result;
}

std::string ply(const std::string& format, const std::string& vertices, const std::string& faces,
                const std::string& data) {
  return "ply\nformat " + format + " 1.0\nelement vertex " + vertices +
         "\nproperty float x\nproperty float y\nproperty float z\nelement face " + faces +
         "\nproperty list uchar int vertex_indices\nend_header\n" + data;
}

TEST(ScreenMeshFile, RefusesPlyCountsThatTheFileHasNoBytesFor) {
  const std::string data = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2";
  EXPECT_EQ(text_of(screen("a.ply", ply("ascii", "3", "1", data))), "ok");
  const Status faces = screen("a.ply", ply("ascii", "3", "150000000", data));
  ASSERT_FALSE(faces.ok());
  EXPECT_EQ(faces.error().code, Errc::truncated);
  EXPECT_EQ(faces.error().text, "the file ends before its 150000000 faces");
  EXPECT_EQ(text_of(screen("a.ply", ply("ascii", "18446744073709551615", "1", data))),
            "the file ends before its 18446744073709551615 vertices");
  // Binary: 12 bytes a vertex, at least one a face, none to spare but one.
  const std::string bytes(3 * 12 + 1, '\0');  // the face is an empty list
  EXPECT_EQ(text_of(screen("a.ply", ply("binary_little_endian", "3", "1", bytes))), "ok");
  EXPECT_EQ(screen("a.ply", ply("binary_little_endian", "3", "3", bytes)).error().code,
            Errc::truncated);
  EXPECT_EQ(screen("a.ply", ply("binary_big_endian", "4", "1", bytes)).error().code,
            Errc::truncated);
}

TEST(ScreenMeshFile, RefusesBinaryPlyListsThatRunPastTheEnd) {
  const std::string vertices(3 * 12, '\0');
  std::string faces = std::string("\3", 1) + std::string(12, '\0');
  const auto check = [&] {
    return text_of(screen("a.ply", ply("binary_little_endian", "3", "1", vertices + faces)));
  };
  EXPECT_EQ(check(), "ok");
  faces[0] = 4;
  EXPECT_EQ(check(), "the file ends before its 4 entries of a list");
}

TEST(ScreenMeshFile, KeepsPlyToTheLimitOfMemory) {
  const std::string text = ply("ascii", "3", "1", "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  const std::span<const uint8_t> bytes(reinterpret_cast<const uint8_t*>(text.data()), text.size());
  EXPECT_TRUE(screen_mesh_file("a.ply", bytes, {.memory = 64}).ok());
  const Status status = screen_mesh_file("a.ply", bytes, {.memory = 63});
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().code, Errc::limit_exceeded);
}

TEST(ScreenMeshFile, RefusesOffCountsThatTheFileHasNoBytesFor) {
  EXPECT_EQ(text_of(screen("a.off", "OFF\n# three\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")), "ok");
  const Status vertices = screen("a.off", "OFF\n400000000 1 0\n0 0 0\n");
  ASSERT_FALSE(vertices.ok());
  EXPECT_EQ(vertices.error().code, Errc::truncated);
  EXPECT_EQ(vertices.error().text, "the file ends before its 400000000 vertices");
  EXPECT_FALSE(screen("noending", "COFF\n1 99999999999999999999999 0\n0 0 0\n").ok());
}

TEST(ScreenMeshFile, RefusesCountsOfTextXMeshes) {
  const std::string head = "xof 0303txt 0032\n";
  EXPECT_EQ(text_of(screen("m.x", head + "Mesh {\n 400000000;\n 0;0;0;,\n}\n")),
            "the file ends before its 400000000 entries of a mesh");
  EXPECT_FALSE(screen("m.x", head + "Frame f { Mesh m { 1; 0;0;0;; 400000000; } }").ok());
  EXPECT_FALSE(screen("m.x", head + "SkinWeights { \"bone\"; 400000000; }").ok());
  // No counts: coordinates, numbers in other blocks, strings and comments.
  EXPECT_EQ(text_of(screen("m.x", head + "Mesh { 1; 400000000.5;-400000000;4e18;; } // 400000000\n"
                                         "DeclData { 1065353216; } Frame \"400000000\" { }")),
            "ok");
}

TEST(ScreenMeshFile, RefusesNestingBeyondAThousandLevels) {
  struct Case {
    const char *path, *head, *open, *close;
  };
  const Case cases[] = {{"a.gltf", "", "[", "]"},
                        {"a.gltf", "{\"a\":", "{\"a\":", "}"},
                        {"a.dae", "<?xml version=\"1.0\"?><!-- < -->", "<node id='>'>", "</node>"},
                        {"a.x3d", "\xEF\xBB\xBF ", "<Group>", "</Group>"},
                        {"a.x", "xof 0303txt 0032\n", "Frame f {", "}"},
                        {"a.fbx", "; FBX 7.3\n", "Model: \"{\" {", "}"}};
  for (const Case& c : cases) {
    EXPECT_EQ(text_of(screen(c.path, c.head + repeated(c.open, 990) + repeated(c.close, 990))),
              "ok")
        << c.open;
    // As deep, again and again.
    const std::string flat = repeated(std::string(c.open) + c.close, 3000);
    EXPECT_EQ(text_of(screen(c.path, c.head + flat)), "ok") << c.open;
    const Status deep = screen(c.path, c.head + repeated(c.open, 1100));
    ASSERT_FALSE(deep.ok()) << c.open;
    EXPECT_EQ(deep.error().code, Errc::limit_exceeded);
    EXPECT_EQ(deep.error().text, "nested deeper than 1000 levels");
  }
}

TEST(ScreenMeshFile, TakesEmptyElementsAndBracketsInStringsForNoNesting) {
  EXPECT_EQ(text_of(screen("a.dae", "<a>" + repeated("<b/>", 3000) + "</a>")), "ok");
  EXPECT_EQ(text_of(screen("a.dae", "<a><![CDATA[" + repeated("<b>", 3000) + "]]></a>")), "ok");
  EXPECT_EQ(text_of(screen("a.gltf", "[\"\\\"" + repeated("[", 3000) + "\"]")), "ok");
}

TEST(ScreenMeshFile, LooksOnlyAtTheJsonOfAGlb) {
  const std::string head = std::string("glTF\2\0\0\0\0\0\0\0", 12);
  const std::string json = std::string("\4\0\0\0JSON[[]]", 12);
  EXPECT_EQ(text_of(screen("a.glb", head + json + repeated("[", 3000))), "ok");
  const std::string deep = std::string("\xB8\x0B\0\0JSON", 8) + repeated("[", 3000);
  EXPECT_EQ(text_of(screen("a.glb", head + deep)), "nested deeper than 1000 levels");
}

TEST(ScreenMeshFile, TakesWhateverIsCutShort) {
  const std::string texts[] = {ply("ascii", "3", "1", "0 0 0\n"),
                               "xof 0303txt 0032\nMesh { 1; \"a",
                               "OFF\n3 1 0\n",
                               "<?xml ?><!-- --><a b='c'/><![CDATA[x]]>",
                               "{\"a\\\"\":[1]}",
                               std::string("glTF\2\0\0\0\0\0\0\0\4\0\0\0JSON{}", 22)};
  for (const std::string& text : texts) {
    for (size_t length = 0; length <= text.size(); ++length) {
      for (const char* path : {"a", "a.off", "a.gltf", "a.fbx", "a.b/c"}) {
        const Status status = screen(path, text.substr(0, length));
        EXPECT_TRUE(status.ok() || !status.error().text.empty());
      }
    }
  }
}

}  // namespace
}  // namespace afx
