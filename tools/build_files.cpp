// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include <filesystem>

#include "afx/known_nodes.h"
#include "afx/picture_io.h"
#include "tools/build.h"

namespace afx::tools {

Result<std::string> PictureFiles::put(const std::string& suffix, const std::string& format,
                                      const std::vector<uint8_t>& bytes) {
  const std::filesystem::path scene(job_.command.output);
  const std::string name =
      scene.stem().string() + suffix + (format == "jpeg" ? ".jpg" : "." + format);
  bytes_ += bytes.size();
  ++count_;
  const std::string path = (scene.parent_path() / name).string();
  if (Status free = job_.outputs.check(path); !free.ok()) return free.error();
  if (job_.session.options.dry_run) return name;
  if (Status put = job_.outputs.put(path, bytes); !put.ok()) return put.error();
  return name;
}

template <class AnyPicture>
Result<std::string> PictureFiles::put(const std::string& suffix, const AnyPicture& picture,
                                      const std::string& format, bool colour) {
  PictureOptions options;
  options.jpeg_quality = jpeg_quality_;
  options.colour = colour;
  const auto bytes = encode_picture(picture, format, options);
  if (!bytes.ok()) return bytes.error();
  return put(suffix, format, bytes.value());
}

template Result<std::string> PictureFiles::put(const std::string&, const Picture&,
                                               const std::string&, bool);
template Result<std::string> PictureFiles::put(const std::string&, const DeepPicture&,
                                               const std::string&, bool);

nodes::NodeId add_transform(nodes::Scene& scene, const glm::dvec3& offset) {
  const nodes::NodeId top = add_known(scene, "Group");  // BIFS has no Transform at the top
  const nodes::NodeId transform = add_known(scene, "Transform");
  nodes::NodeId outer = transform;
  if (offset != glm::dvec3(0)) {
    outer = add_known(scene, "Transform");
    set_known(scene, outer, "translation", glm::vec3(offset));
    set_known(scene, outer, "children", std::vector<nodes::NodeId>{transform});
  }
  set_known(scene, top, "children", std::vector<nodes::NodeId>{outer});
  scene.add_root(top);
  return transform;
}

}  // namespace afx::tools
