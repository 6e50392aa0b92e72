# Installs the C libraries of BUILD below WORK, moves them, and builds SOURCE against them: by CMake, and by pkg-config.
file(REMOVE_RECURSE ${WORK}/installed ${WORK}/moved ${WORK}/consumer)
foreach(component c_library c_local_library c_development)
  execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/installed --component ${component}
    OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
endforeach()
file(RENAME ${WORK}/installed ${WORK}/moved)

execute_process(COMMAND ${CMAKE_COMMAND} -S ${SOURCE} -B ${WORK}/consumer -G ${GENERATOR}
  -DCMAKE_PREFIX_PATH=${WORK}/moved -DCMAKE_C_COMPILER=${COMPILER} -DCMAKE_C_FLAGS=${FLAGS} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build ${WORK}/consumer COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${WORK}/consumer/consumer COMMAND_ERROR_IS_FATAL ANY)

file(GLOB_RECURSE files ${WORK}/moved/*/contactd*.pc)
list(LENGTH files count)
if(count EQUAL 0)
  message(FATAL_ERROR "There is no file for pkg-config below ${WORK}/moved.")
endif()
foreach(file IN LISTS files)
  cmake_path(GET file STEM name)
  cmake_path(GET file PARENT_PATH folder)
  cmake_path(GET folder PARENT_PATH libraries)
  set(environment ${CMAKE_COMMAND} -E env PKG_CONFIG_PATH=${folder} LD_LIBRARY_PATH=${libraries})
  execute_process(COMMAND ${environment} pkg-config --cflags --libs ${name}
    OUTPUT_VARIABLE options OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  separate_arguments(options)
  execute_process(COMMAND ${COMPILER} ${FLAGS} ${SOURCE}/main.c ${options} -o ${WORK}/consumer/by-${name}
    COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${environment} ${WORK}/consumer/by-${name} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
