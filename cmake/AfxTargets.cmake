# SPDX-License-Identifier: BSD-2-Clause
# How a folder becomes targets. By file name:
#   x.cpp  library    x_test.cpp  unit tests    x_bench.cpp  benchmark    x_fuzz.cpp  fuzz target

add_library(afx_options INTERFACE)
target_compile_features(afx_options INTERFACE cxx_std_20)
target_include_directories(afx_options INTERFACE $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
                                                 $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/generated>)
# g++ 12 at -O3 warns falsely inside the standard library: -Wrestrict of "literal" + std::string(),
# -Wstringop-* of vectors that grow by insert().
target_compile_options(afx_options INTERFACE -Wall -Wextra -Wconversion -Wshadow -ffp-contract=off
                       "$<$<CXX_COMPILER_ID:GNU>:-Wno-restrict;-Wno-stringop-overflow;-Wno-stringop-overread>"
                       $<$<BOOL:${AFX_WERROR}>:-Werror>)
if(AFX_LIBFUZZER)  # the libraries too, or the fuzzer is blind
  target_compile_options(afx_options INTERFACE -fsanitize=fuzzer-no-link)
endif()
# Tests with the address sanitizer want ASAN_OPTIONS=intercept_tls_get_addr=0, as their presets set it: of a
# library's thread-local storage that is allocated at the 16th byte of a page, the search for leaks of g++ 12
# and clang 14 takes its own record for a header of glibc 2.19, follows it and crashes ("Tracer caught signal 11").
if(AFX_SANITIZE)
  target_compile_options(afx_options INTERFACE -fsanitize=${AFX_SANITIZE}
                         -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(afx_options INTERFACE -fsanitize=${AFX_SANITIZE})
  if(AFX_SANITIZE MATCHES address)
    target_compile_definitions(afx_options INTERFACE AFX_ADDRESS_SANITIZER)
  endif()
endif()

if(AFX_TESTS)
  find_package(GTest REQUIRED)
  find_package(nlohmann_json REQUIRED)
  include(GoogleTest)
endif()
if(AFX_BENCHMARKS)
  find_package(benchmark REQUIRED)
  add_custom_target(benchmarks)  # all of them, for tools/bench
endif()

# The files of that pattern in this folder, and in those of its folders that are named.
function(afx_glob out pattern)
  set(patterns ${pattern})
  foreach(folder ${ARGN})
    list(APPEND patterns ${folder}/${pattern})
  endforeach()
  file(GLOB files CONFIGURE_DEPENDS ${patterns})
  set(${out} ${files} PARENT_SCOPE)
endfunction()

# The library sources of a folder: every .cpp that is not a test, benchmark or fuzz target.
function(afx_folder_sources out)
  afx_glob(sources *.cpp ${ARGN})
  list(FILTER sources EXCLUDE REGEX "_(test|bench|fuzz|main|module)\\.cpp$")
  set(${out} ${sources} PARENT_SCOPE)
endfunction()

# afx_layer(codec DEPENDS ...): the object library afx_<folder>, part of afx::afx. FOLDERS: folders in it
# that belong to it; for afx_checks likewise.
function(afx_layer name)
  cmake_parse_arguments(arg "" "" "DEPENDS;SOURCES;FOLDERS" ${ARGN})
  afx_folder_sources(sources ${arg_FOLDERS})
  add_library(afx_${name} OBJECT ${sources} ${arg_SOURCES})
  target_link_libraries(afx_${name} PUBLIC afx_options ${arg_DEPENDS})
endfunction()

# afx_checks(codec LIBS ... FOLDERS ...): one program of unit tests, of this folder and those below it that are
# named, and a program for each benchmark and fuzz target.
function(afx_checks name)
  cmake_parse_arguments(arg "" "" "LIBS;FOLDERS" ${ARGN})
  if(AFX_TESTS)
    afx_glob(tests *_test.cpp ${arg_FOLDERS})
    if(tests)
      add_executable(${name}_tests ${tests})
      target_link_libraries(${name}_tests PRIVATE ${arg_LIBS} afx_options GTest::gmock GTest::gtest_main
                            nlohmann_json::nlohmann_json)
      target_compile_definitions(${name}_tests PRIVATE AFX_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
      gtest_discover_tests(${name}_tests TEST_PREFIX "${name}." DISCOVERY_TIMEOUT 60
                           DISCOVERY_MODE PRE_TEST PROPERTIES TIMEOUT 600)
    endif()
    afx_glob(fuzzers *_fuzz.cpp ${arg_FOLDERS})
    foreach(file ${fuzzers})
      get_filename_component(target ${file} NAME_WE)
      afx_fuzz_target(${target} ${file} ${arg_LIBS})
    endforeach()
  endif()
  if(AFX_BENCHMARKS)
    afx_glob(benches *_bench.cpp ${arg_FOLDERS})
    foreach(file ${benches})
      get_filename_component(target ${file} NAME_WE)
      add_executable(${target} ${file})
      add_dependencies(benchmarks ${target})
      target_link_libraries(${target} PRIVATE ${arg_LIBS} afx_options benchmark::benchmark)
      target_compile_definitions(${target} PRIVATE AFX_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
    endforeach()
  endif()
endfunction()

# A fuzz target: with libFuzzer a fuzzer; otherwise the same file replays conformance/corpus/<target>
# and mutations of it from a fixed seed, as an ordinary test.
function(afx_fuzz_target target file)
  add_executable(${target} ${file})
  target_link_libraries(${target} PRIVATE ${ARGN} afx_options)
  if(AFX_LIBFUZZER)
    target_compile_options(${target} PRIVATE -fsanitize=fuzzer)
    target_link_options(${target} PRIVATE -fsanitize=fuzzer)
    add_test(NAME fuzz.${target} COMMAND ${target} -runs=20000 -max_len=4096
             ${PROJECT_SOURCE_DIR}/conformance/corpus/${target})
  else()
    target_sources(${target} PRIVATE ${PROJECT_SOURCE_DIR}/conformance/fuzz_replay_main.cpp)
    add_test(NAME fuzz.${target} COMMAND ${target} ${PROJECT_SOURCE_DIR}/conformance/corpus/${target})
  endif()
  set_tests_properties(fuzz.${target} PROPERTIES TIMEOUT 900)
endfunction()
