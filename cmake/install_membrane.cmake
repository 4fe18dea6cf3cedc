# The membrane as a library for other projects: find_package(validate), then link validate::membrane.
include(CMakePackageConfigHelpers)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/validate)
get_property(membrane_rooms GLOBAL PROPERTY MEMBRANE_ROOMS)
install(TARGETS project_options membrane ${membrane_rooms} EXPORT validate
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}/validate COMPONENT membrane)
install(EXPORT validate NAMESPACE validate:: DESTINATION ${package_folder} COMPONENT membrane)
install(DIRECTORY membrane DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/validate COMPONENT membrane
  FILES_MATCHING PATTERN "*.hpp")
configure_package_config_file(cmake/validateConfig.cmake.in ${CMAKE_BINARY_DIR}/validateConfig.cmake
  INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/validateConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/validateConfig.cmake ${CMAKE_BINARY_DIR}/validateConfigVersion.cmake
  cmake/FindCHOLMOD.cmake DESTINATION ${package_folder} COMPONENT membrane)
