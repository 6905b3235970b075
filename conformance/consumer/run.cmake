# SPDX-License-Identifier: BSD-2-Clause
# Installs BUILD_DIR to a fresh prefix and builds the consumer from there in both ways, CMake and pkg-config.
# cmake -DBUILD_DIR=... -DSOURCE_DIR=... -DWORK_DIR=... -DCXX=... -P run.cmake
cmake_policy(SET CMP0057 NEW)
file(REMOVE_RECURSE ${WORK_DIR})
set(prefix ${WORK_DIR}/prefix)

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE out)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "${ARGN}\n${out}")
  endif()
endfunction()

function(expect program expected)
  execute_process(COMMAND ${program} RESULT_VARIABLE code OUTPUT_VARIABLE out)
  if(NOT code EQUAL 0 OR NOT out STREQUAL expected)
    message(FATAL_ERROR "${program} printed '${out}' (expected '${expected}')")
  endif()
endfunction()

run(${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${prefix})
run(${CMAKE_COMMAND} -S ${SOURCE_DIR} -B ${WORK_DIR}/build -DCMAKE_PREFIX_PATH=${prefix} -DCMAKE_CXX_COMPILER=${CXX})
run(${CMAKE_COMMAND} --build ${WORK_DIR}/build)
expect(${WORK_DIR}/build/consumer "voxel 0 0 0\n")
expect(${WORK_DIR}/build/scene "nodes 1\n")

file(GLOB_RECURSE pc ${prefix}/*/afx.pc)
get_filename_component(pc_dir ${pc} DIRECTORY)
set(ENV{PKG_CONFIG_PATH} ${pc_dir})
execute_process(COMMAND pkg-config --define-variable=prefix=${prefix} --cflags --libs afx
                OUTPUT_VARIABLE flags RESULT_VARIABLE code OUTPUT_STRIP_TRAILING_WHITESPACE)
if(NOT code EQUAL 0)
  message(FATAL_ERROR "pkg-config does not find afx")
endif()
separate_arguments(flags UNIX_COMMAND "${flags}")
run(${CXX} -std=c++20 ${SOURCE_DIR}/main.cpp -o ${WORK_DIR}/by_pkg_config ${flags})
expect(${WORK_DIR}/by_pkg_config "voxel 0 0 0\n")
run(${CXX} -std=c++20 ${SOURCE_DIR}/scene.cpp -o ${WORK_DIR}/scene_by_pkg_config ${flags})
expect(${WORK_DIR}/scene_by_pkg_config "nodes 1\n")

# The installed program finds its picture module.
execute_process(COMMAND ${prefix}/bin/afx --version RESULT_VARIABLE code OUTPUT_VARIABLE out)
if(NOT code EQUAL 0)
  message(FATAL_ERROR "the installed program does not start")
endif()
