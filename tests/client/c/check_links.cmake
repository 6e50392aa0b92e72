# The client's library is as free of the numerics as the C++ client.
include(${CMAKE_CURRENT_LIST_DIR}/../cpp/check_links.cmake)
