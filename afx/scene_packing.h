// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// From a scene with files beside it to one whole presentation, and back: what the octrees and
// pictures of a scene become in an MP4 file. ISO/IEC 14496-1, 14496-11 and 14496-16 (clauses not
// checked).
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "afx/media_store.h"
#include "afx/scene_files.h"
#include "bifs/presentation.h"
#include "codec/diagnostics.h"
#include "codec/error.h"
#include "codec/limits.h"

namespace afx {

struct PackOptions {
  enum class Octrees : uint8_t {
    stream,  ///< an AFX stream for each
    buffer,  ///< the same bytes in the scene (BitWrapper.buffer)
    none     ///< stay fields of their nodes
  };
  Octrees octrees = Octrees::stream;
  bool pictures = true;  ///< an image stream for each file
  unsigned threads = 1;  ///< 0 = all cores; changes nothing that comes out
  Limits limits = {};
};

/// Makes streams of the octrees and pictures of a presentation that is a plain scene: one access
/// unit with a scene replacement, no object descriptors.
///
/// An OctreeImage with an octree comes under a BitWrapper, wherever it stands, and loses the fields
/// `octree`, `voxelImageIndex` and `octreeResolution`. It keeps its DEF name and ID; where it
/// stands in several places the BitWrapper gets a name too, NAME_BitWrapper, and an ID. The urls of
/// ImageTexture, MovieTexture, Background and Background2D that name a PNG, JPEG or JP2 file get
/// the object descriptor in front and keep the name; a file that is named twice is one stream.
///
/// Object descriptors get IDs up to 1022 that the presentation does not use, streams ES_IDs behind
/// those of the scene (1 if nothing is said) and of the object descriptors. A unit with an
/// ObjectDescriptorUpdate comes before the scene's. Media are put into `store`: a picture under its
/// file's name relative to `folder` (that of the scene's file; empty: the working folder), an
/// octree under "octree_odN.afx".
///
/// Errors    bad_argument: the presentation is no plain scene, more streams than IDs. Then nothing
///           was changed
/// Warnings  octree_in_proto: OctreeImages in bodies of PROTOs stay as they are; octree_not_packed:
///           one that cannot be coded does (more than 127 images, fields that do not fit);
///           missing_picture, picture_not_packed: urls that name no file, or none of those kinds,
///           stay as they are
Status pack_scene(bifs::Presentation& presentation, const std::string& folder,
                  const PackOptions& options, MediaStore& store, Diagnostics& diagnostics);

struct UnpackOptions {
  std::string stem = "picture";  ///< pictures without a name become STEM_od10.png, ...
  std::set<std::string> taken;  ///< names that no picture may get, such as that of the scene's file
  Limits limits = {};
};

/// A file to be written beside a scene.
struct NamedFile {
  std::string
      name;  ///< a plain relative path with "/": it leads nowhere else (is_plain_picture_name)
  std::vector<uint8_t> bytes;
};

/// The inverse, for a decoded scene: puts the fields that BitWrappers bring back into their
/// OctreeImages, which stand where the BitWrappers stood, and names instead of the object
/// descriptors of still pictures, whose files are returned in the order of their first use.
///
/// A picture's name is the first url behind its object descriptor that is_plain_picture_name(); the
/// object descriptor goes then. Without one it gets a name that is made. Of streams with several
/// samples the first is taken. After an error the scene is of no use.
///
/// Errors    those of read_octree_node; limit_exceeded: pictures of more than limits.memory
/// Warnings  bitwrapper_left: a BitWrapper stays (other node, other coding, no such stream,
/// connected
///           by ROUTE or IS, in a PROTO's interface); url_left: object descriptors that name no
///           still picture, with their count; unsafe_name, name_taken: a name is not used;
///           frames_left_out; those of read_octree_node
Result<std::vector<NamedFile>> unpack_scene(nodes::Scene& scene, const ObjectStreams& streams,
                                            const UnpackOptions& options, Diagnostics& diagnostics);

/// Whether a name from a file that is not trusted may be given to a picture: a relative path of at
/// most 1000 bytes without "..", hidden parts (".x"), backslashes, colons or control characters,
/// with the ending of a PNG, JPEG or JPEG 2000 file.
bool is_plain_picture_name(const std::string& name);

}  // namespace afx
