# Installs the programs, and the C++ client as the CMake package "contactd" (targets contactd::client, ::proto, ::types).
include(CMakePackageConfigHelpers)

install(TARGETS contactd_types contactd_proto contactd_client EXPORT contactd_targets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development
  FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
install(EXPORT contactd_targets NAMESPACE contactd:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/contactd
  COMPONENT development)
install(DIRECTORY proto/include/ client/cpp/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/contactd-config.cmake.in
  ${PROJECT_BINARY_DIR}/contactd-config.cmake INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/contactd)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/contactd-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/contactd-config.cmake ${PROJECT_BINARY_DIR}/contactd-config-version.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/contactd COMPONENT development)
foreach(program contactd contactd-ic)
  if(TARGET ${program})
    install(TARGETS ${program} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT programs)
  endif()
endforeach()
