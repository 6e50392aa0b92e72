# Configures the preset wheel: libraries are linked as archives where available, first those of static_libraries.sh,
# then Debian's.
set(CMAKE_FIND_LIBRARY_SUFFIXES .a .so)
set(HDF5_USE_STATIC_LIBRARIES ON)
find_package(ZLIB REQUIRED) # HDF5 refers to it as a target without looking for it
find_package(HDF5 REQUIRED COMPONENTS CXX)
# The compile options of HDF5 do not concern its users: our sources are compiled as in other presets.
foreach(target hdf5-static hdf5_cpp-static)
  set_target_properties(${target} PROPERTIES INTERFACE_COMPILE_DEFINITIONS "")
endforeach()
