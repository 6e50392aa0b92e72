# Of the preset wheel: libraries are taken as archives where there are any, those of static_libraries.sh before Debian's.
set(CMAKE_FIND_LIBRARY_SUFFIXES .a .so)
set(HDF5_USE_STATIC_LIBRARIES ON)
find_package(ZLIB REQUIRED) # HDF5 names it as a target, and does not look for it
find_package(HDF5 REQUIRED COMPONENTS CXX)
# What HDF5 was compiled with is nothing to those who use it: our sources compile as for any other preset.
foreach(target hdf5-static hdf5_cpp-static)
  set_target_properties(${target} PROPERTIES INTERFACE_COMPILE_DEFINITIONS "")
endforeach()
