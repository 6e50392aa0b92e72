# Configures the preset windows: HDF5 and zlib are the archives of static_libraries.sh.
set(CMAKE_FIND_LIBRARY_SUFFIXES .a)
set(HDF5_USE_STATIC_LIBRARIES ON)
find_package(ZLIB REQUIRED) # HDF5 refers to it as a target without looking for it
find_package(HDF5 REQUIRED COMPONENTS CXX)
# The compile options of HDF5 do not concern its users: our sources are compiled as in other presets.
foreach(target hdf5-static hdf5_cpp-static)
  set_target_properties(${target} PROPERTIES INTERFACE_COMPILE_DEFINITIONS "")
endforeach()
# Debian's headers are in /usr/include next to those of Linux's C library, which a compiler for Windows must not see.
file(COPY /usr/include/nlohmann DESTINATION ${CMAKE_BINARY_DIR}/headers)
find_package(nlohmann_json REQUIRED)
set_target_properties(nlohmann_json::nlohmann_json PROPERTIES INTERFACE_INCLUDE_DIRECTORIES ${CMAKE_BINARY_DIR}/headers
  INTERFACE_SYSTEM_INCLUDE_DIRECTORIES "")
