// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <glm/common.hpp>
#include <string>
#include <vector>

#include "afx/builder/model_reader.h"
#include "afx/file_test_folder.h"
#include "afx/picture_io.h"
#include "afx/srgb.h"

namespace afx {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

const char* const kSquare =
    "mtllib m.mtl\nusemtl paint\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 "
    "1\n"
    "f 1/1 2/2 3/3 4/4\n";

Picture orange() {
  Picture picture(2, 2, 3);
  for (size_t i = 0; i < 12; i += 3) {
    picture.samples[i] = 255;
    picture.samples[i + 1] = 128;
  }
  return picture;
}

struct Read {
  Result<Mesh> mesh;
  Diagnostics diagnostics;
};

Read read(const std::string& path) {
  Diagnostics diagnostics;
  Result<Mesh> mesh = read_mesh(path, Limits(), diagnostics);
  return {std::move(mesh), std::move(diagnostics)};
}

TEST(ReadMesh, GivesTrianglesWithTheirTexture) {
  const TestFolder folder;
  folder.write("m.mtl", "newmtl paint\nKd 1 1 1\nmap_Kd t.png\n");
  ASSERT_TRUE(write_picture(folder.path("t.png"), orange()).ok());
  const Read result = read(folder.write("square.obj", kSquare));
  ASSERT_TRUE(result.mesh.ok()) << result.mesh.error().text;
  const Mesh& mesh = result.mesh.value();
  EXPECT_EQ(result.diagnostics.count(), 0U);
  ASSERT_THAT(mesh.triangles, SizeIs(2));
  EXPECT_EQ(mesh.positions.size(), mesh.texture_coords.size());
  // Texture coordinates are the positions here: v grows upwards in both.
  for (size_t i = 0; i < mesh.positions.size(); ++i)
    EXPECT_EQ(glm::vec2(mesh.positions[i]), mesh.texture_coords[i]);
  ASSERT_THAT(mesh.textures, SizeIs(1));
  EXPECT_EQ(mesh.textures[0].samples, orange().samples);
  EXPECT_EQ(mesh.materials[mesh.material_of[0]].texture, 0U);
  EXPECT_EQ(mesh.materials[mesh.material_of[0]].colour, glm::vec3(1));
  EXPECT_TRUE(mesh.has_colours);
}

TEST(ReadMesh, FindsTexturesUnderTheNamesThatOtherSystemsWrite) {
  const TestFolder folder;
  ASSERT_TRUE(write_picture(folder.path("Tex Ture.png"), orange()).ok());
  for (const char* name :
       {"Tex Ture.png", "C:\\models\\Tex Ture.png", "textures/TEX TURE.PNG", "Tex%20Ture.png"}) {
    folder.write("m.mtl", std::string("newmtl paint\nKd 1 1 1\nmap_Kd ") + name + "\n");
    const Read result = read(folder.write("square.obj", kSquare));
    ASSERT_TRUE(result.mesh.ok());
    EXPECT_THAT(result.mesh.value().textures, SizeIs(1)) << name;
  }
}

TEST(ReadMesh, WarnsOfAMissingTextureAndTakesTheMaterialsColour) {
  const TestFolder folder;
  folder.write("m.mtl", "newmtl paint\nKd 1 0 0\nmap_Kd nowhere.png\n");
  const Read result = read(folder.write("square.obj", kSquare));
  ASSERT_TRUE(result.mesh.ok());
  ASSERT_THAT(result.diagnostics.warnings(), SizeIs(1));
  EXPECT_EQ(result.diagnostics.warnings()[0].code, "texture_missing");
  EXPECT_THAT(result.diagnostics.warnings()[0].text, HasSubstr("nowhere.png"));
  const Material& material = result.mesh.value().materials[result.mesh.value().material_of[0]];
  EXPECT_EQ(material.texture, Material::kNoTexture);
  EXPECT_EQ(material.colour, glm::vec3(1, 0, 0));
}

TEST(ReadMesh, TakesMaterialColoursOfObjAsSrgb) {
  const TestFolder folder;
  folder.write("m.mtl", "newmtl paint\nKd 0.5019608 0 1\n");  // 128/255
  const Read result = read(folder.write("square.obj", kSquare));
  ASSERT_TRUE(result.mesh.ok());
  const glm::vec3 colour = result.mesh.value().materials[result.mesh.value().material_of[0]].colour;
  EXPECT_NEAR(colour.r, srgb_to_linear()[128], 1e-4);
  EXPECT_EQ(linear_to_srgb(colour.r), 128);
  EXPECT_EQ(linear_to_srgb(colour.b), 255);
}

TEST(ReadMesh, KnowsThatAFileSaysNothingOfColours) {
  const TestFolder folder;
  const Read obj = read(folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
  ASSERT_TRUE(obj.mesh.ok());
  EXPECT_FALSE(obj.mesh.value().has_colours);
  const Read stl = read(folder.write(
      "a.stl",
      "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
      "endloop\nendfacet\nendsolid a\n"));
  ASSERT_TRUE(stl.mesh.ok()) << stl.mesh.error().text;
  EXPECT_FALSE(stl.mesh.value().has_colours);
}

TEST(ReadMesh, TakesVertexColours) {
  const TestFolder folder;
  const Read result = read(
      folder.write("a.ply",
                   "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float "
                   "y\nproperty float z\n"
                   "property uchar red\nproperty uchar green\nproperty uchar blue\nelement face 1\n"
                   "property list uchar int vertex_indices\nend_header\n0 0 0 255 0 128\n1 0 0 255 "
                   "0 128\n0 1 0 255 0 128\n3 0 1 2\n"));
  ASSERT_TRUE(result.mesh.ok()) << result.mesh.error().text;
  const Mesh& mesh = result.mesh.value();
  EXPECT_TRUE(mesh.has_colours);
  ASSERT_THAT(mesh.colours, SizeIs(3));
  EXPECT_EQ(linear_to_srgb(mesh.colours[0].r), 255);
  EXPECT_EQ(linear_to_srgb(mesh.colours[0].b), 128);
}

// A glTF scene by hand: a triangle under a node that moves and mirrors it, colour 0.5 in linear
// light.
std::string gltf() {
  // Positions (0,0,0) (1,0,0) (0,1,0) as little-endian floats in base64.
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],
    "nodes":[{"translation":[10,0,0],"children":[1]},{"scale":[-1,1,1],"mesh":0}],
    "meshes":[{"primitives":[{"attributes":{"POSITION":0},"material":0}]}],
    "materials":[{"name":"half","pbrMetallicRoughness":{"baseColorFactor":[0.5,0,1,1]}}],
    "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}],
    "bufferViews":[{"buffer":0,"byteLength":36}],
    "buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})";
}

TEST(ReadMesh, AppliesTheTransformsOfNodes) {
  const TestFolder folder;
  const Read result = read(folder.write("a.gltf", gltf()));
  ASSERT_TRUE(result.mesh.ok()) << result.mesh.error().text;
  const Mesh& mesh = result.mesh.value();
  std::vector<float> xs;
  for (const glm::vec3& p : mesh.positions) xs.push_back(p.x);
  std::sort(xs.begin(), xs.end());
  EXPECT_EQ(xs, (std::vector<float>{9, 10, 10}));
  // Mirroring turns the triangle around; the reader turns it back, so that its front stays the
  // front: the normal of the triangle, +z, is mirrored in x only and stays +z.
  const glm::uvec3 t = mesh.triangles[0];
  const glm::vec3 a = mesh.positions[t.y] - mesh.positions[t.x],
                  b = mesh.positions[t.z] - mesh.positions[t.x];
  EXPECT_GT(a.x * b.y - a.y * b.x, 0);
}

TEST(ReadMesh, AppliesTheTransformsOfNodesToEachInstance) {
  // One mesh under three nodes: scaled, with a child that is moved in the scaled coordinates, and a
  // mirror in a mirror.
  std::string text = gltf();
  const size_t begin = text.find("\"nodes\":[{\"translation\""), end = text.find("\"meshes\":");
  text.replace(begin, end - begin,
               R"("nodes":[{"children":[1,3]},{"scale":[2,3,1],"mesh":0,"children":[2]},
                  {"translation":[5,0,0],"mesh":0},{"scale":[1,-1,1],"children":[4]},
                  {"scale":[1,-1,1],"translation":[0,-7,0],"mesh":0}],)");
  const TestFolder folder;
  const Read result = read(folder.write("a.gltf", text));
  ASSERT_TRUE(result.mesh.ok()) << result.mesh.error().text;
  const Mesh& mesh = result.mesh.value();
  ASSERT_THAT(mesh.triangles, SizeIs(3));
  const std::vector<std::vector<glm::vec3>> expected = {{{0, 0, 0}, {2, 0, 0}, {0, 3, 0}},
                                                        {{10, 0, 0}, {12, 0, 0}, {10, 3, 0}},
                                                        {{0, 7, 0}, {1, 7, 0}, {0, 8, 0}}};
  for (size_t t = 0; t < 3; ++t)
    for (int k = 0; k < 3; ++k)
      EXPECT_EQ(mesh.positions[mesh.triangles[t][k]], expected[t][static_cast<size_t>(k)]);
}

TEST(ReadMesh, GivesEachTriangleItsMaterial) {
  const TestFolder folder;
  folder.write("m.mtl", "newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n");
  const Read result = read(folder.write(
      "a.obj",
      "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nusemtl red\nf 1 2 3\nusemtl blue\n"
      "f 1 2 4\nusemtl red\nf 1 3 4\n"));
  ASSERT_TRUE(result.mesh.ok()) << result.mesh.error().text;
  const Mesh& mesh = result.mesh.value();
  ASSERT_THAT(mesh.triangles, SizeIs(3));
  size_t blue = 0;
  for (size_t t = 0; t < 3; ++t) {
    const bool on_axes_x_and_z =
        mesh.positions[mesh.triangles[t].y].y == 0 && mesh.positions[mesh.triangles[t].z].y == 0;
    const glm::vec3 colour = mesh.materials[mesh.material_of[t]].colour;
    EXPECT_EQ(colour, on_axes_x_and_z ? glm::vec3(0, 0, 1) : glm::vec3(1, 0, 0));
    blue += on_axes_x_and_z ? 1 : 0;
  }
  EXPECT_EQ(blue, 1U);
}

TEST(ReadMesh, TakesColoursOfGltfAsLinearLight) {
  const TestFolder folder;
  const Read result = read(folder.write("a.gltf", gltf()));
  ASSERT_TRUE(result.mesh.ok());
  const glm::vec3 colour = result.mesh.value().materials[result.mesh.value().material_of[0]].colour;
  EXPECT_NEAR(colour.r, 0.5, 1e-6);
  EXPECT_EQ(linear_to_srgb(colour.r), 188);
}

// Pictures whose colour is all the same, with the alphas given, in a row.
Picture with_alpha(const std::vector<uint8_t>& alphas) {
  Picture picture(static_cast<uint32_t>(alphas.size()), 1, 4);
  for (uint32_t x = 0; x < picture.width; ++x) {
    picture.pixel(x, 0)[0] = 200;
    picture.pixel(x, 0)[3] = alphas[x];
  }
  return picture;
}

const Material& first_material(const Mesh& mesh) { return mesh.materials[mesh.material_of[0]]; }

std::string codes(const Diagnostics& diagnostics) {
  std::string all;
  for (const Warning& warning : diagnostics.warnings()) all += warning.code + " ";
  return all;
}

TEST(ReadMesh, CutsHolesByAnAlphaThatLooksMadeForIt) {
  const TestFolder folder;
  folder.write("m.mtl", "newmtl paint\nKd 1 1 1\nmap_Kd t.png\n");
  const std::string path = folder.write("square.obj", kSquare);
  ASSERT_TRUE(write_picture(folder.path("t.png"), with_alpha({0, 255})).ok());
  const Read cut = read(path);
  ASSERT_TRUE(cut.mesh.ok()) << cut.mesh.error().text;
  EXPECT_EQ(codes(cut.diagnostics), "");
  EXPECT_EQ(first_material(cut.mesh.value()).alpha_cutoff, 0.5F);
  EXPECT_EQ(cut.mesh.value().textures[0].samples, with_alpha({0, 255}).samples);
  for (const std::vector<uint8_t>& other : {std::vector<uint8_t>{0, 0}, {200, 255}, {255, 255}}) {
    std::filesystem::remove(folder.path("t.png"));
    ASSERT_TRUE(write_picture(folder.path("t.png"), with_alpha(other)).ok());
    const Read whole = read(path);
    ASSERT_TRUE(whole.mesh.ok());
    EXPECT_EQ(first_material(whole.mesh.value()).alpha_cutoff, 0);
    EXPECT_EQ(whole.mesh.value().textures[0].components, 3U);
  }
}

TEST(ReadMesh, CutsHolesByOpacityTextures) {
  const TestFolder folder;
  Picture opacity(2, 2, 1);
  opacity.samples = {0, 255, 255, 255};
  ASSERT_TRUE(write_picture(folder.path("t.png"), orange()).ok());
  ASSERT_TRUE(write_picture(folder.path("d.png"), opacity).ok());
  folder.write("m.mtl", "newmtl paint\nKd 1 1 1\nmap_Kd t.png\nmap_d d.png\n");
  const std::string path = folder.write("square.obj", kSquare);
  const Read both = read(path);
  ASSERT_TRUE(both.mesh.ok()) << both.mesh.error().text;
  ASSERT_THAT(both.mesh.value().textures, SizeIs(1));
  EXPECT_EQ(first_material(both.mesh.value()).alpha_cutoff, 0.5F);
  EXPECT_EQ(
      both.mesh.value().textures[0].samples,
      (std::vector<uint8_t>{255, 128, 0, 0, 255, 128, 0, 255, 255, 128, 0, 255, 255, 128, 0, 255}));
  folder.write("m.mtl", "newmtl paint\nKd 1 0 0\nmap_d d.png\n");
  const Read alone = read(path);
  ASSERT_TRUE(alone.mesh.ok());
  EXPECT_EQ(first_material(alone.mesh.value()).colour, glm::vec3(1, 0, 0));
  EXPECT_EQ(alone.mesh.value().textures[0].samples,
            (std::vector<uint8_t>{255, 255, 255, 0, 255, 255, 255, 255, 255, 255, 255, 255, 255,
                                  255, 255, 255}));
}

TEST(ReadMesh, TheOpacityOfAMaterialTakesPart) {
  const TestFolder folder;
  ASSERT_TRUE(write_picture(folder.path("t.png"), with_alpha({0, 255})).ok());
  const std::string path = folder.write("square.obj", kSquare);
  // Alpha is taken times 0.8: below 0.5 where the texture's is below 0.625.
  folder.write("m.mtl", "newmtl paint\nKd 1 1 1\nd 0.8\nmap_Kd t.png\n");
  const Read most = read(path);
  ASSERT_TRUE(most.mesh.ok());
  EXPECT_FLOAT_EQ(first_material(most.mesh.value()).alpha_cutoff, 0.625F);
  EXPECT_EQ(codes(most.diagnostics), "alpha_blending ");
  folder.write("m.mtl", "newmtl paint\nKd 1 1 1\nd 0.3\n");
  const Read none = read(path);
  ASSERT_FALSE(none.mesh.ok());
  EXPECT_THAT(none.mesh.error().text, HasSubstr("none of the file's 2 triangles can be used"));
  EXPECT_THAT(none.mesh.error().text, HasSubstr("2 are transparent"));
  folder.write("m.mtl", "newmtl paint\nKd 1 1 1\nd 0\n");  // a mistake: taken as opaque
  EXPECT_TRUE(read(path).mesh.ok());
}

TEST(ReadMesh, LeavesOutTransparentMaterialsBesideOthers) {
  const TestFolder folder;
  folder.write("m.mtl", "newmtl glass\nd 0.1\nnewmtl wood\nd 1\n");
  const Read result = read(folder.write("a.obj",
                                        "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl glass\n"
                                        "f 1 2 3\nf 3 2 1\nusemtl wood\nf 1 2 3\n"));
  ASSERT_TRUE(result.mesh.ok()) << result.mesh.error().text;
  EXPECT_THAT(result.mesh.value().triangles, SizeIs(1));
  EXPECT_EQ(codes(result.diagnostics), "transparent ");
  EXPECT_THAT(result.diagnostics.warnings()[0].text, HasSubstr("2 triangles"));
}

// Positions, texture coordinates and indices of the square below, in base64.
const char* const kSquareBuffer =
    "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAACAPwAAgD8AAAAAAAAAAAAAgD8AAAAAAAAAAAAAAAAAAIA/"
    "AAAAAAAAgD8AAIA/AAAAAAAAgD8AAQIAAgM=";

// A square by hand, its texture coordinates (0, 0), (1, 0), (1, 1), (0, 1), v downwards, at the
// corners (0, 0), (1, 0), (1, 1), (0, 1).
std::string gltf_square(const std::string& material, const std::string& texture = "") {
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
    "meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1},"indices":2,"material":0}]}],
    "extensionsUsed":["KHR_texture_transform"],
    "materials":[{"name":"m",)" +
         material + R"("pbrMetallicRoughness":{"baseColorTexture":{"index":0)" + texture + R"(}}}],
    "textures":[{"source":0}],"images":[{"uri":"t.png"}],
    "accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[0,0,0],"max":[1,1,0]},
      {"bufferView":1,"componentType":5126,"count":4,"type":"VEC2"},
      {"bufferView":2,"componentType":5121,"count":6,"type":"SCALAR"}],
    "bufferViews":[{"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":32},
      {"buffer":0,"byteOffset":80,"byteLength":6}],
    "buffers":[{"byteLength":86,"uri":"data:application/octet-stream;base64,)" +
         kSquareBuffer + R"("}]})";
}

// Where on the texture the corners (0, 0), (1, 0), (1, 1), (0, 1) of a square lie, to 1/10000.
std::vector<glm::ivec2> corners_on_texture(const Mesh& mesh) {
  std::vector<glm::ivec2> places;
  for (const glm::vec2 corner : {glm::vec2(0, 0), {1, 0}, {1, 1}, {0, 1}})
    for (size_t i = 0; i < mesh.positions.size(); ++i)
      if (glm::vec2(mesh.positions[i]) == corner)
        places.emplace_back(glm::round(mesh.texture_coords[i] * 10000.0F));
  return places;
}

using Places = std::vector<glm::ivec2>;

// By the prose and the examples of KHR_texture_transform: scale, then rotation against the clock as
// seen with v downwards, then offset: u' = c u + s v + offset, v' = -s u + c v + offset. Expected
// are places with v upwards, 1 - v'.
TEST(ReadMesh, TransformsTextureCoordinatesOfGltf) {
  const TestFolder folder;
  ASSERT_TRUE(write_picture(folder.path("t.png"), orange()).ok());
  struct Case {
    const char* transform;
    Places places;
  };
  for (const Case& c : {
           Case{R"("offset":[0.25,0.5])",
                {{2500, 5000}, {12500, 5000}, {12500, -5000}, {2500, -5000}}},
           Case{R"("scale":[0.5,0.25])", {{0, 10000}, {5000, 10000}, {5000, 7500}, {0, 7500}}},
           // "inverts the T axis"
           Case{R"("offset":[0,1],"scale":[1,-1])",
                {{0, 0}, {10000, 0}, {10000, 10000}, {0, 10000}}},
           Case{R"("rotation":1.57079632679)",
                {{0, 10000}, {0, 20000}, {10000, 20000}, {10000, 10000}}},
           // "only the lower left quadrant of the source image, rotated clockwise"
           Case{R"("offset":[0,1],"rotation":1.57079632679,"scale":[0.5,0.5])",
                {{0, 0}, {0, 5000}, {5000, 5000}, {5000, 0}}},
           // cos = 0.8, sin = 0.6; (1, 1) goes to 0.8 * 2 + 0.6 * 0.5 + 0.1 and
           // -0.6 * 2 + 0.8 * 0.5 + 0.2.
           Case{R"("offset":[0.1,0.2],"rotation":0.643501108793,"scale":[2,0.5])",
                {{1000, 8000}, {17000, 20000}, {20000, 16000}, {4000, 4000}}},
       }) {
    const Read result = read(folder.write(
        "a.gltf", gltf_square("", std::string(R"(,"extensions":{"KHR_texture_transform":{)") +
                                      c.transform + "}}")));
    ASSERT_TRUE(result.mesh.ok()) << result.mesh.error().text;
    EXPECT_EQ(corners_on_texture(result.mesh.value()), c.places) << c.transform;
  }
}

// The options shift and scale texture coordinates: u' = scale u + offset.
TEST(ReadMesh, TransformsTextureCoordinatesOfMtl) {
  const TestFolder folder;
  ASSERT_TRUE(write_picture(folder.path("t.png"), orange()).ok());
  struct Case {
    const char* options;
    Places places;
  };
  for (const Case& c : {
           Case{"", {{0, 0}, {10000, 0}, {10000, 10000}, {0, 10000}}},
           Case{"-o 0.25 0.5 0", {{2500, 5000}, {12500, 5000}, {12500, 15000}, {2500, 15000}}},
           Case{"-s 2 3 1", {{0, 0}, {20000, 0}, {20000, 30000}, {0, 30000}}},
           Case{"-s 2 3 1 -o 0.5 0.25 0 -clamp on",
                {{5000, 2500}, {25000, 2500}, {25000, 32500}, {5000, 32500}}},
           Case{"-o 0.25 0.5", {{2500, 5000}, {12500, 5000}, {12500, 15000}, {2500, 15000}}},
           Case{"-o 0.25", {{2500, 0}, {12500, 0}, {12500, 10000}, {2500, 10000}}},
       }) {
    folder.write("m.mtl", std::string("newmtl paint\nKd 1 1 1\nmap_Kd ") + c.options + " t.png\n");
    const Read result = read(folder.write("square.obj", kSquare));
    ASSERT_TRUE(result.mesh.ok()) << result.mesh.error().text;
    EXPECT_THAT(result.mesh.value().textures, SizeIs(1)) << c.options;
    EXPECT_EQ(corners_on_texture(result.mesh.value()), c.places) << c.options;
  }
}

TEST(ReadMesh, CutsHolesAsAlphaModeOfGltfSays) {
  const TestFolder folder;
  ASSERT_TRUE(write_picture(folder.path("t.png"), with_alpha({0, 60, 255})).ok());
  struct Case {
    const char* material;
    float cutoff;
    const char* warnings;
  };
  for (const Case& c : {Case{"", 0, ""}, Case{R"("alphaMode":"OPAQUE",)", 0, ""},
                        Case{R"("alphaMode":"MASK",)", 0.5F, ""},
                        Case{R"("alphaMode":"MASK","alphaCutoff":0.2,)", 0.2F, ""},
                        Case{R"("alphaMode":"MASK","alphaCutoff":0,)", 0, ""},
                        Case{R"("alphaMode":"BLEND",)", 0.5F, "alpha_blending "}}) {
    const Read result = read(folder.write("a.gltf", gltf_square(c.material)));
    ASSERT_TRUE(result.mesh.ok()) << result.mesh.error().text;
    EXPECT_EQ(first_material(result.mesh.value()).alpha_cutoff, c.cutoff) << c.material;
    EXPECT_EQ(result.mesh.value().textures[0].components, c.cutoff > 0 ? 4U : 3U) << c.material;
    EXPECT_EQ(codes(result.diagnostics), c.warnings) << c.material;
  }
}

TEST(ReadMesh, TheAlphaOfBaseColorFactorTakesPart) {
  const TestFolder folder;
  ASSERT_TRUE(write_picture(folder.path("t.png"), with_alpha({0, 60, 255})).ok());
  const auto file = [](const char* mode, const char* alpha) {
    return gltf_square(mode, std::string(R"(},"baseColorFactor":[1,1,1,)") + alpha +
                                 R"(],"metallicRoughnessTexture":{"index":0)");
  };
  const Read cut = read(folder.write("a.gltf", file(R"("alphaMode":"MASK",)", "0.8")));
  ASSERT_TRUE(cut.mesh.ok()) << cut.mesh.error().text;
  EXPECT_FLOAT_EQ(first_material(cut.mesh.value()).alpha_cutoff, 0.625F);
  for (const char* alpha : {"0.4", "0"}) {
    const Read none = read(folder.write("a.gltf", file(R"("alphaMode":"BLEND",)", alpha)));
    ASSERT_FALSE(none.mesh.ok()) << alpha;
    EXPECT_THAT(none.mesh.error().text, HasSubstr("2 are transparent"));
  }
  const Read opaque = read(folder.write("a.gltf", file("", "0.4")));
  ASSERT_TRUE(opaque.mesh.ok());
  EXPECT_EQ(first_material(opaque.mesh.value()).alpha_cutoff, 0);
}

TEST(ReadMesh, AlphaThatIsOneEverywhereCutsNothing) {
  const TestFolder folder;
  ASSERT_TRUE(write_picture(folder.path("t.png"), with_alpha({255, 255})).ok());
  for (const char* mode : {R"("alphaMode":"MASK",)", R"("alphaMode":"BLEND",)"}) {
    const Read result = read(folder.write("a.gltf", gltf_square(mode)));
    ASSERT_TRUE(result.mesh.ok()) << result.mesh.error().text;
    EXPECT_EQ(first_material(result.mesh.value()).alpha_cutoff, 0);
    EXPECT_EQ(codes(result.diagnostics), "");
  }
}

TEST(ReadMesh, CountsLinesAndPointsThatItLeavesOut) {
  const TestFolder folder;
  const Read result =
      read(folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nl 1 2\nl 2 3\n"));
  ASSERT_TRUE(result.mesh.ok()) << result.mesh.error().text;
  EXPECT_THAT(result.mesh.value().triangles, SizeIs(1));
  ASSERT_THAT(result.diagnostics.warnings(), SizeIs(1));
  EXPECT_EQ(result.diagnostics.warnings()[0].code, "skipped_primitives");
  EXPECT_THAT(result.diagnostics.warnings()[0].text, HasSubstr("2 lines"));
}

TEST(ReadMesh, SaysWhatIsWrong) {
  const TestFolder folder;
  const Read missing = read(folder.path("no.obj"));
  ASSERT_FALSE(missing.mesh.ok());
  EXPECT_EQ(missing.mesh.error().code, Errc::io);
  const Read unknown = read(folder.write("a.xyzzy", "something else"));
  ASSERT_FALSE(unknown.mesh.ok());
  EXPECT_EQ(unknown.mesh.error().code, Errc::unsupported);
  EXPECT_EQ(unknown.mesh.error().file, folder.path("a.xyzzy"));
  for (const char* text :
       {"", "v 0 0 0\nv 1 0 0\n", "v 0 0 0\nv 1 0 0\nl 1 2\n", "v 0 0 0\nf 1 2 3\n"}) {
    const Read empty = read(folder.write("a.obj", text));
    ASSERT_FALSE(empty.mesh.ok()) << text;
    EXPECT_EQ(empty.mesh.error().code, Errc::malformed);
    EXPECT_EQ(empty.mesh.error().file, folder.path("a.obj"));
  }
}

TEST(ReadMesh, RefusesWhatWouldCostAssimpGigabytesBeforeItStarts) {
  const TestFolder folder;
  const Read counts = read(folder.write(
      "a.ply",
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
      "property float z\nelement face 150000000\nproperty list uchar int vertex_indices\n"
      "end_header\n0 0 0\n3 0 0 0\n"));
  ASSERT_FALSE(counts.mesh.ok());
  EXPECT_EQ(counts.mesh.error().code, Errc::truncated);
  EXPECT_EQ(counts.mesh.error().file, folder.path("a.ply"));
  const Read deep = read(folder.write("a.gltf", std::string(100000, '[')));
  ASSERT_FALSE(deep.mesh.ok());
  EXPECT_EQ(deep.mesh.error().code, Errc::limit_exceeded);
}

TEST(ReadMesh, CountsTrianglesThatCannotBeUsed) {
  const TestFolder folder;
  const Read result = read(folder.write("a.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
  ASSERT_FALSE(result.mesh.ok());
  EXPECT_THAT(result.mesh.error().text,
              HasSubstr("none of the file's 1 triangles can be used (1 "));
}

TEST(ReadMesh, LeavesOutTrianglesWithoutFiniteCoordinates) {
  const TestFolder folder;
  const Read result = read(folder.write(
      "a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv nan 0 0\nv 0 inf 0\nf 1 2 3\nf 1 2 4\nf 5 2 3\n"));
  ASSERT_TRUE(result.mesh.ok()) << result.mesh.error().text;
  EXPECT_THAT(result.mesh.value().triangles, SizeIs(1));
  for (const glm::vec3& p : result.mesh.value().positions)
    EXPECT_TRUE(p.x >= 0 && p.x <= 1 && p.y >= 0 && p.y <= 1);
  ASSERT_THAT(result.diagnostics.warnings(), SizeIs(1));
  EXPECT_EQ(result.diagnostics.warnings()[0].code, "non_finite");
  EXPECT_THAT(result.diagnostics.warnings()[0].text, HasSubstr("2 triangles"));
}

TEST(ReadMesh, KeepsTrianglesWithoutArea) {
  const TestFolder folder;
  const Read result = read(
      folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 0 0\nf 1 2 3\nf 1 2 4\nf 1 1 2\n"));
  ASSERT_TRUE(result.mesh.ok()) << result.mesh.error().text;
  EXPECT_THAT(result.mesh.value().triangles, SizeIs(3));
  EXPECT_EQ(result.diagnostics.count(), 0U);
}

// A square whose materials each name a texture; every triangle of another.
std::string square_with(const TestFolder& folder, const std::vector<std::string>& textures) {
  std::string materials,
      model = "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n";
  for (size_t i = 0; i < textures.size(); ++i) {
    const std::string name = "m" + std::to_string(i);
    materials += "newmtl " + name + "\nKd 1 1 1\nmap_Kd " + textures[i] + "\n";
    model += "usemtl " + name + "\nf 1/1 2/2 3/3\n";
  }
  folder.write("m.mtl", materials);
  return folder.write("a.obj", model);
}

TEST(ReadMesh, ReadsAPictureOnceUnderHoweverManyNames) {
  const TestFolder folder;
  ASSERT_TRUE(write_picture(folder.path("t.png"), orange()).ok());
  std::filesystem::create_symlink(folder.path("t.png"), folder.path("link.png"));
  const Read result = read(square_with(folder, {"t.png", "./t.png", ".//./t.png", "link.png"}));
  ASSERT_TRUE(result.mesh.ok()) << result.mesh.error().text;
  EXPECT_THAT(result.mesh.value().textures, SizeIs(1));
  EXPECT_THAT(result.mesh.value().triangles, SizeIs(4));
  for (const uint32_t material : result.mesh.value().material_of)
    EXPECT_EQ(result.mesh.value().materials[material].texture, 0U);
}

TEST(ReadMesh, KeepsAllTexturesTogetherToTheLimitOfMemory) {
  const TestFolder folder;
  // 3 bytes a pixel, and 6 for each of the 1024 + 256 + ... + 1 of its smaller copies.
  constexpr uint64_t kOne = 64 * 64 * 3 + 1365 * 6;
  const Picture picture(64, 64, 3);
  ASSERT_TRUE(write_picture(folder.path("a.png"), picture).ok());
  ASSERT_TRUE(write_picture(folder.path("b.png"), picture).ok());
  const std::string path = square_with(folder, {"a.png", "b.png"});
  for (const bool enough : {true, false}) {
    Diagnostics diagnostics;
    const auto mesh = read_mesh(path, {.memory = 2 * kOne - (enough ? 0 : 1)}, diagnostics);
    ASSERT_TRUE(mesh.ok()) << mesh.error().text;
    EXPECT_THAT(mesh.value().textures, SizeIs(enough ? 2 : 1));
    EXPECT_EQ(diagnostics.count(), enough ? 0U : 1U);
  }
}

TEST(ReadMesh, WaitsForNoPipe) {
  const TestFolder folder;
  const std::string path = folder.path("a.obj");
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  const Read result = read(path);
  ASSERT_FALSE(result.mesh.ok());
  EXPECT_EQ(result.mesh.error().code, Errc::io);
}

TEST(ReadMesh, CutAtAnyLengthNeverCrashes) {
  const TestFolder folder;
  folder.write("m.mtl", "newmtl paint\nKd 1 0 0\n");
  for (const std::string& whole : {std::string(kSquare), gltf()}) {
    const std::string name = whole[0] == '{' ? "a.gltf" : "a.obj";
    for (size_t length = 0; length < whole.size(); length += 3) {
      const Read result = read(folder.write(name, whole.substr(0, length)));
      if (result.mesh.ok()) {
        EXPECT_FALSE(result.mesh.value().triangles.empty());
      } else {
        EXPECT_FALSE(result.mesh.error().text.empty());
      }
    }
  }
}

TEST(ReadSourceModel, TellsPointsFromMeshesByContent) {
  const TestFolder folder;
  Diagnostics diagnostics;
  const std::string points =
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float "
      "z\nend_header\n1 2 3\n";
  const auto cloud = read_source_model(folder.write("points.obj", points), Limits(), diagnostics);
  ASSERT_TRUE(cloud.ok()) << cloud.error().text;
  EXPECT_TRUE(std::holds_alternative<PointCloud>(cloud.value()));
  const auto mesh = read_source_model(
      folder.write("mesh.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), Limits(), diagnostics);
  ASSERT_TRUE(mesh.ok());
  EXPECT_TRUE(std::holds_alternative<Mesh>(mesh.value()));
  const auto bad =
      read_source_model(folder.write("bad.ply", points.substr(0, 30)), Limits(), diagnostics);
  ASSERT_FALSE(bad.ok());
  EXPECT_EQ(bad.error().file, folder.path("bad.ply"));
}

}  // namespace
}  // namespace afx
