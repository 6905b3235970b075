// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include <utility>

#include "afx/builder/mesh_import_module.h"
#include "afx/builder/mesh_screen.h"
#include "afx/builder/model_reader.h"
#include "afx/file.h"
#include "afx/module_loader.h"

namespace afx {
namespace {

Status check_file(const std::string& path, const Limits& limits) {
  const Result<MappedFile> file = MappedFile::open_regular(path, limits);
  if (!file.ok()) return file.error();
  Status status = screen_mesh_file(path, file.value().bytes(), limits);
  if (!status.ok()) status.error().file = path;
  return status;
}

}  // namespace

Result<Mesh> read_mesh(const std::string& path, const Limits& limits, Diagnostics& diagnostics) {
  if (Status status = check_file(path, limits); !status.ok()) return status.error();
  static const ModuleSymbol module =
      find_in_module("afx_meshes", "afx_mesh_import", "the module for meshes");
  if (module.symbol == nullptr) return Error{Errc::not_available, {}, module.problem, {}, path};
  Result<Mesh> mesh = Error{};
  reinterpret_cast<afx_mesh_import_function>(module.symbol)(&path, &limits, &diagnostics, &mesh);
  return mesh;
}

Result<SourceModel> read_source_model(const std::string& path, const Limits& limits,
                                      Diagnostics& diagnostics) {
  const Result<MappedFile> file = MappedFile::open(path, limits);
  if (!file.ok()) return file.error();
  if (ply_kind(file.value().bytes()) == PlyKind::points) {
    Result<PointCloud> cloud = read_ply_points(file.value().bytes(), limits, diagnostics);
    if (cloud.ok()) return SourceModel(std::move(cloud).value());
    cloud.error().file = path;
    return cloud.error();
  }
  if (path == "-")
    return Error{Errc::unsupported,
                 {},
                 "standard input holds no points (meshes can be read from files only)",
                 {},
                 path};
  Result<Mesh> mesh = read_mesh(path, limits, diagnostics);
  if (!mesh.ok()) return mesh.error();
  return SourceModel(std::move(mesh).value());
}

}  // namespace afx
