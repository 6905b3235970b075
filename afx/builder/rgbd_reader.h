// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// RGB-D pictures with their calibration, as a JSON file describes them:
//
//   { "convention": "opencv",
//     "depthScale": 0.001,
//     "intrinsics": {"fx": 525, "fy": 525, "cx": 319.5, "cy": 239.5, "width": 640, "height": 480},
//     "near": 0.3, "far": 4,
//     "frames": [
//       { "colour": "0.png", "depth": "0-depth.png", "mask": "0-mask.png",
//         "pose": [[1,0,0,0], [0,1,0,0], [0,0,1,0], [0,0,0,1]] }, ... ] }
//
// fx fy cx cy  focal lengths and principal point in pixels of the depth picture; the centre of its
//              upper left pixel is (0, 0)
// width height optional: the size that the depth pictures have
// depthScale   scene units for one step of depth pictures of integers (8 or 16 bits); depth
// pictures
//              in floating point (OpenEXR, TIFF) hold scene units
// pose         rows of the matrix from the camera's system to the world: affine, any scale
// convention   the camera's system. "opencv" (default): x right, y down, z forward; "opengl": x
//              right, y up, z back
// near far     optional: distances outside are background
// mask         optional picture: where it is black is background
//
// Depths are distances to the plane through the camera; 0, below 0 and not finite mean none. All
// but `frames` may stand in a frame, in its "intrinsics", at the top, or in "intrinsics" there, and
// is looked for in this order. Names of pictures lead from the folder of the file. Colour and mask
// may have other sizes than the depth; they show the same view.
#pragma once

#include <string>

#include "afx/surfels.h"
#include "codec/diagnostics.h"
#include "codec/error.h"
#include "codec/limits.h"

namespace afx {

/// Reads all frames of such a file as surfels in the world. Flying pixels are dropped
/// (rgbd_frame.h).
///
/// threads   0 = all cores; the result is the same for any number
/// Errors    malformed: no JSON, with the place; bad_argument, naming the file and the member, e.g.
///           "frames[2].fx": missing, of another type, not in range; a pose that is not finite,
///           affine or invertible; a depth picture of more than two components or of another size
///           than width and height say; no frames. Those of reading files and pictures, naming the
///           picture; limit_exceeded
/// Warnings  unknown_member; empty_frame: frames without any valid depth, counted
Result<Surfels> read_rgbd(const std::string& path, unsigned threads, const Limits& limits,
                          Diagnostics& diagnostics);

}  // namespace afx
