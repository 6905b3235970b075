# SPDX-License-Identifier: BSD-2-Clause
# One public library, afx::afx, of the layers codec to render; its headers, CMake package, pkg-config file.
include(CMakePackageConfigHelpers)

set(layers codec nodes bifs model render)
add_library(afx STATIC)
add_library(afx::afx ALIAS afx)
foreach(layer ${layers})
  target_sources(afx PRIVATE $<TARGET_OBJECTS:afx_${layer}>)
endforeach()
target_include_directories(afx INTERFACE $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
                                         $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/afx>)
target_compile_features(afx INTERFACE cxx_std_20)
target_link_libraries(afx PUBLIC glm::glm Threads::Threads ${CMAKE_DL_LIBS} PRIVATE pugixml::pugixml)

install(TARGETS afx EXPORT afx-targets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(TARGETS afx_pictures LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/afx)
if(TARGET afx_video)
  install(TARGETS afx_video LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/afx)
endif()
if(TARGET afx_meshes)
  install(TARGETS afx_meshes LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/afx)
endif()
if(TARGET afx_viewer)
  install(TARGETS afx_viewer LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/afx)
endif()
if(TARGET afx_program)
  install(TARGETS afx_program RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
foreach(folder codec nodes bifs afx afx/shapes render)
  file(GLOB headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${folder}/*.h)
  list(FILTER headers EXCLUDE REGEX "(_|/)test_[^/]*$")
  install(FILES ${headers} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/afx/${folder})
endforeach()

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/afx)
install(EXPORT afx-targets NAMESPACE afx:: DESTINATION ${package_dir})
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/afx-config.cmake.in
                              ${PROJECT_BINARY_DIR}/afx-config.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/afx-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/afx-config.cmake ${PROJECT_BINARY_DIR}/afx-config-version.cmake
        DESTINATION ${package_dir})
configure_file(${PROJECT_SOURCE_DIR}/cmake/afx.pc.in ${PROJECT_BINARY_DIR}/afx.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/afx.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
