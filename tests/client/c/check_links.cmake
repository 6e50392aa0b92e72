# Checks that the client's library depends on no numerical libraries, like the C++ client.
include(${CMAKE_CURRENT_LIST_DIR}/../cpp/check_links.cmake)
