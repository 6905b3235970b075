# SPDX-License-Identifier: BSD-2-Clause
# Sourced by the scripts beside it: the Debian packages that afx is built and tested with.

build_packages=(g++ cmake ninja-build libglm-dev libopenimageio-dev openimageio-tools libassimp-dev
  libcli11-dev libnanoflann-dev nlohmann-json3-dev libmd-dev zlib1g-dev libpugixml-dev pkg-config libepoxy-dev libglfw3-dev
  libimgui-dev libavcodec-dev libavformat-dev libswscale-dev)
test_packages=(libgtest-dev libgmock-dev libbenchmark-dev python3 python3-jsonschema ffmpeg
  clang-14 libclang-rt-14-dev libegl1 libopengl0 libgl1-mesa-dri xvfb xdotool libembree-dev)
demo_packages=(assimp-testmodels)
table_packages=(assimp-testmodels assimp-utils draco jq time zip)

# Installs those of the packages named that are missing.
need_packages() {
  local missing=() package
  for package in "$@"; do
    dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing+=("$package")
  done
  ((${#missing[@]} == 0)) && return
  echo "installing ${missing[*]}"
  local root=()
  ((EUID == 0)) || root=(sudo)
  "${root[@]}" apt-get update -qq
  DEBIAN_FRONTEND=noninteractive "${root[@]}" apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
}
