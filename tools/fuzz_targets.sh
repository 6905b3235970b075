# SPDX-License-Identifier: BSD-2-Clause
# Sourced by the scripts beside it: the fuzz targets, and what each is fed with.

# The kinds of files among the conformance suites that are seeds of a target.
declare -A fuzz_endings=(
  [octree_frame_fuzz]='' [octree_stream_fuzz]='afx' [bifs_decoder_fuzz]='' [od_fuzz]='' [mp4_fuzz]='mp4'
  [picture_header_fuzz]='' [model_source_fuzz]='' [decoded_scene_fuzz]='mp4'
  [suite_fuzz]='' [scene_text_fuzz]='wrl bt' [bt_fuzz]='bt wrl' [xmt_fuzz]='xmt' [dibr_model_fuzz]='wrl')
readarray -t fuzz_targets < <(printf '%s\n' "${!fuzz_endings[@]}" | sort)

# Copies the seeds of a target into a folder: its corpus, and streams of the suites up to 64 KiB.
copy_seeds() {
  local target=$1 folder=$2 ending file
  mkdir -p "$folder"
  cp -n conformance/corpus/"$target"/* "$folder"
  for ending in ${fuzz_endings[$target]}; do
    while IFS= read -r file; do
      cp -n "$file" "$folder/$(sha256sum "$file" | cut -c1-16).$ending"
    done < <(find conformance/suites -name "*.$ending" -size -65k | sort)
  done
}
