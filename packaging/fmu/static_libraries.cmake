# Configures the preset fmu: the settings of wheels, and ZeroMQ from zeromq.sh as the target that cppzmq links.
include(${CMAKE_CURRENT_LIST_DIR}/../wheels/static_libraries.cmake)
find_package(Threads REQUIRED)
find_library(CONTACTD_STATIC_SODIUM libsodium.a REQUIRED)
add_library(libzmq STATIC IMPORTED)
set_target_properties(libzmq PROPERTIES
  IMPORTED_LOCATION $ENV{CONTACTD_STATIC_ZEROMQ}/lib/libzmq.a
  INTERFACE_INCLUDE_DIRECTORIES $ENV{CONTACTD_STATIC_ZEROMQ}/include
  INTERFACE_LINK_LIBRARIES "${CONTACTD_STATIC_SODIUM};Threads::Threads")
