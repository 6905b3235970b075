// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include <nlohmann/json.hpp>

#include "afx/builder/ply_writer.h"
#include "afx/builder/point_surfels.h"
#include "afx/file.h"
#include "tools/decode.h"
#include "tools/model_input.h"

namespace afx::tools {

int decode_points(const DecodeOptions& options, const Input& input, OutputFiles& outputs,
                  const Session& session, Diagnostics& diagnostics) {
  if (Status right = refuse_raw_octree(input); !right.ok())
    return session.fail(right.error(), options.input, diagnostics);
  OctreeQuery query{.node = {}, .resolution = {}, .frame = options.frame};
  auto model = read_model_input(input, query, session, diagnostics);
  if (!model.ok()) {
    session.show(diagnostics, options.input);
    return session.fail_query(model.error(), query.missing_is_usage, options.input);
  }
  const auto surfels = surfels_of_input(std::move(model).value(), session, diagnostics);
  if (!surfels.ok()) return session.fail(surfels.error(), options.input, diagnostics);
  const PointCloud points = points_of(surfels.value());
  const std::vector<uint8_t> bytes = write_ply_points(points);
  if (const int code = session.warn(diagnostics, options.input); code != kDone) return code;
  if (!session.options.dry_run) {
    if (Status put = outputs.put(options.output, bytes); !put.ok())
      return session.fail(put.error(), options.output);
  }
  return session.finish(
      outputs, options.output,
      {options.output + ": " + counted(points.positions.size(), "point") + ", " +
       counted(bytes.size(), "byte")},
      {{"output", options.output}, {"points", points.positions.size()}, {"bytes", bytes.size()}});
}

}  // namespace afx::tools
