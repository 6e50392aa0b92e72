# Installs the built parts: the programs, the C++ client as the CMake package "contactd" (targets contactd::client,
# ::proto, ::types), and the C libraries as its components c and c_local (targets of the same names) and for pkg-config.
include(CMakePackageConfigHelpers)

# contactd_install_c(TARGET NAME COMPONENT) installs libNAME.so. The files needed to build with it belong to
# c_development.
function(contactd_install_c target name component)
  get_target_property(component_name ${target} EXPORT_NAME)
  set(folder ${CMAKE_INSTALL_LIBDIR}/cmake/contactd)
  install(TARGETS ${target} EXPORT contactd_${component_name}_targets
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${component} NAMELINK_COMPONENT c_development)
  install(EXPORT contactd_${component_name}_targets NAMESPACE contactd:: DESTINATION ${folder} COMPONENT c_development)
  # The installation can be moved, because all paths are relative to this file.
  file(RELATIVE_PATH prefix /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
  configure_file(${CMAKE_CURRENT_FUNCTION_LIST_DIR}/contactd.pc.in ${PROJECT_BINARY_DIR}/${name}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/${name}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT c_development)
endfunction()

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/contactd-config.cmake.in
  ${PROJECT_BINARY_DIR}/contactd-config.cmake INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/contactd)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/contactd-config-version.cmake COMPATIBILITY SameMinorVersion)
# contactd_install_package(COMPONENT) installs the files by which CMake finds the package, for whichever of its targets
# are installed.
function(contactd_install_package component)
  install(FILES ${PROJECT_BINARY_DIR}/contactd-config.cmake ${PROJECT_BINARY_DIR}/contactd-config-version.cmake
    DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/contactd COMPONENT ${component})
endfunction()

if(TARGET contactd_client)
  install(TARGETS contactd_types contactd_cases_read contactd_proto contactd_client EXPORT contactd_targets
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development
    FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
  install(EXPORT contactd_targets NAMESPACE contactd:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/contactd
    COMPONENT development)
  install(DIRECTORY proto/include/ client/cpp/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
  contactd_install_package(development)
endif()
if(TARGET contactd_c)
  contactd_install_c(contactd_c contactd c_library)
endif()
if(TARGET contactd_local_c)
  contactd_install_c(contactd_local_c contactd-local c_local_library)
endif()
if(TARGET contactd_c OR TARGET contactd_local_c)
  install(DIRECTORY client/c/include/ client/c/generated/include/
    DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT c_development)
  install(FILES client/c/fortran/contactd_calls.f90 client/c/fortran/contactd.f90
    client/c/matlab/contactd_mex.c client/c/matlab/contactd_mex_calls.h
    DESTINATION ${CMAKE_INSTALL_DATADIR}/contactd COMPONENT c_development)
  contactd_install_package(c_development)
endif()
foreach(program contactd contactd-ic)
  if(TARGET ${program})
    install(TARGETS ${program} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT programs)
  endif()
endforeach()
if(TARGET contactd-gmsh)
  install(TARGETS contactd-gmsh LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/contactd COMPONENT programs)
endif()
