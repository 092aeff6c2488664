# `find_package(vdamf)` from an install prefix.
include(CMakePackageConfigHelpers)
set(vdamf_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/vdamf)
install(EXPORT vdamf-targets NAMESPACE vdamf:: DESTINATION ${vdamf_package_dir})
configure_package_config_file(cmake/vdamf-config.cmake.in
    ${PROJECT_BINARY_DIR}/vdamf-config.cmake INSTALL_DESTINATION ${vdamf_package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/vdamf-config-version.cmake
    COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/vdamf-config.cmake
    ${PROJECT_BINARY_DIR}/vdamf-config-version.cmake DESTINATION ${vdamf_package_dir})
