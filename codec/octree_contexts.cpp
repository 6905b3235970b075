// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "codec/octree_contexts.h"

#include <limits>

namespace afx::codec {

OctreeContexts::OctreeContexts(unsigned textures) : tables_(size_t{kClasses} * 8) {
  tables_[0].reset(256, kNodeSteps[0], kNodeLimit);
  texture_.reset(textures + 1, kTextureStep, kTextureLimit);
}

uint64_t OctreeContexts::enter_stage(uint64_t coded) {
  if (stage_ == 0 && coded >= kStage1Start) {
    stage_ = 1;
    tables_[0].set_step(kNodeSteps[1]);
    for (unsigned i = 1; i < kClasses; ++i) tables_[i] = tables_[0];
  }
  if (stage_ == 1 && coded >= kStage2Start) {
    stage_ = 2;
    for (unsigned i = kClasses * 8;
         i-- > 0;) {  // backwards: a class is read after its copies are written
      tables_[i] = tables_[i / 8];
      tables_[i].set_step(kNodeSteps[2]);
    }
  }
  if (stage_ == 0) return kStage1Start - coded;
  if (stage_ == 1) return kStage2Start - coded;
  return std::numeric_limits<uint64_t>::max();
}

}  // namespace afx::codec
