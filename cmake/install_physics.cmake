# SPDX-License-Identifier: MIT
# The physics as a library for other programs: `cmake --install BUILD --component physics --prefix P`.
# docs/interface.md tells its users what they get.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
include(cmake/public_headers.cmake)

install_public_headers(physics physics/public/body.h physics/public/motion.h physics/public/method.h
                               physics/public/poinsot.h physics/public/errors.h)

# Base comes along because a static library does not hold what it links to; its headers are no part of the interface.
set_target_properties(polhode_physics PROPERTIES EXPORT_NAME physics OUTPUT_NAME polhode-physics)
set_target_properties(polhode_base PROPERTIES EXPORT_NAME base OUTPUT_NAME polhode-base)
target_compile_features(polhode_physics PUBLIC cxx_std_20)
install(TARGETS polhode_physics polhode_base EXPORT polhode-physics
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT physics
        INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/polhode)
install(EXPORT polhode-physics FILE polhode-physics-targets.cmake NAMESPACE polhode:: DESTINATION ${package_folder}
        COMPONENT physics)
configure_package_config_file(cmake/polhode-config.cmake.in ${PROJECT_BINARY_DIR}/polhode-config.cmake
                              INSTALL_DESTINATION ${package_folder} NO_SET_AND_CHECK_MACRO
                              NO_CHECK_REQUIRED_COMPONENTS_MACRO)
# Below 1.0 a new minor version may change the interface.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/polhode-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/polhode-config.cmake ${PROJECT_BINARY_DIR}/polhode-config-version.cmake
        DESTINATION ${package_folder} COMPONENT physics)

# All paths from the folder of the .pc file, so that an installed tree may be moved.
set(pc_folder ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig)
foreach(folder LIBDIR INCLUDEDIR)
  cmake_path(RELATIVE_PATH CMAKE_INSTALL_FULL_${folder} BASE_DIRECTORY ${pc_folder} OUTPUT_VARIABLE pc_${folder})
endforeach()
configure_file(cmake/polhode-physics.pc.in polhode-physics.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/polhode-physics.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT physics)
