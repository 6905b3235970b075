# SPDX-License-Identifier: BSD-2-Clause
# Says at configure time what is built and what is left out.
message(STATUS "afx ${PROJECT_VERSION}: ${CMAKE_BUILD_TYPE}, ${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}")
foreach(option AFX_BUILDER AFX_TESTS AFX_BENCHMARKS AFX_LIBFUZZER AFX_WERROR)
  message(STATUS "  ${option}: ${${option}}")
endforeach()
if(AFX_SANITIZE)
  message(STATUS "  sanitizers: ${AFX_SANITIZE}")
endif()
