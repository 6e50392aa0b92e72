# Installs the library of BUILD below WORK, and builds EXAMPLE against it, with pkg-config and as a project of somebody else.
set(prefix ${WORK}/installed-cntc)
file(REMOVE_RECURSE ${prefix} ${WORK}/consumer-cntc ${WORK}/source-cntc)
foreach(component cntc cntc_development)
  execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix} --component ${component}
    OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
endforeach()
file(WRITE ${WORK}/source-cntc/CMakeLists.txt "cmake_minimum_required(VERSION 3.25)
project(somebody LANGUAGES C)
find_package(contactd-cntc REQUIRED)
add_executable(creep_forces ${EXAMPLE})
target_link_libraries(creep_forces PRIVATE contactd::cntc)
")
execute_process(COMMAND ${CMAKE_COMMAND} -S ${WORK}/source-cntc -B ${WORK}/consumer-cntc -G ${GENERATOR}
  -DCMAKE_PREFIX_PATH=${prefix} -DCMAKE_C_COMPILER=${COMPILER} -DCMAKE_C_FLAGS=${FLAGS} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build ${WORK}/consumer-cntc OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${WORK}/consumer-cntc/creep_forces OUTPUT_VARIABLE by_cmake COMMAND_ERROR_IS_FATAL ANY)

file(GLOB_RECURSE description ${prefix}/*/contactd-cntc.pc)
cmake_path(GET description PARENT_PATH folder)
execute_process(COMMAND ${CMAKE_COMMAND} -E env PKG_CONFIG_PATH=${folder}
  pkg-config --define-variable=prefix=${prefix} --cflags --libs contactd-cntc
  OUTPUT_VARIABLE flags OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
separate_arguments(flags UNIX_COMMAND "${flags}")
execute_process(COMMAND ${COMPILER} ${FLAGS} ${EXAMPLE} ${flags} -o ${WORK}/consumer-cntc/by_pkg_config COMMAND_ERROR_IS_FATAL ANY)
cmake_path(GET folder PARENT_PATH libraries)
execute_process(COMMAND ${CMAKE_COMMAND} -E env LD_LIBRARY_PATH=${libraries} ${WORK}/consumer-cntc/by_pkg_config
  OUTPUT_VARIABLE by_pkg_config COMMAND_ERROR_IS_FATAL ANY)
if(by_cmake STREQUAL "" OR NOT by_cmake STREQUAL by_pkg_config)
  message(FATAL_ERROR "The installed library answers otherwise:\n${by_cmake}${by_pkg_config}")
endif()
