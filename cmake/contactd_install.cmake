# Installs the programs, and the C++ client as the CMake package "contactd" (targets contactd::client, ::proto, ::types).
include(CMakePackageConfigHelpers)

install(TARGETS contactd_types contactd_proto contactd_client EXPORT contactd_targets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
install(EXPORT contactd_targets NAMESPACE contactd:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/contactd
  COMPONENT development)
install(DIRECTORY proto/include/ client/cpp/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
# The headers of target types.
install(FILES
  core/include/contactd/axis.hpp
  core/include/contactd/body.hpp
  core/include/contactd/contact.hpp
  core/include/contactd/contact_load.hpp
  core/include/contactd/contact_setup.hpp
  core/include/contactd/enum_words.hpp
  core/include/contactd/error.hpp
  core/include/contactd/fem_fields.hpp
  core/include/contactd/friction.hpp
  core/include/contactd/gap.hpp
  core/include/contactd/given_ics.hpp
  core/include/contactd/grid.hpp
  core/include/contactd/ic_spec.hpp
  core/include/contactd/ic_table.hpp
  core/include/contactd/material.hpp
  core/include/contactd/observer.hpp
  core/include/contactd/subsurface.hpp
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/contactd COMPONENT development)
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
