# contactd_library(NAME sources...) creates contactd_NAME with the alias contactd::NAME and the project's warnings.
function(contactd_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion)
  if(CONTACTD_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  if(CONTACTD_SANITIZE)
    # With sanitizers, gcc reports false positives in std::regex.
    target_compile_options(${target} PRIVATE -Wno-maybe-uninitialized)
    target_compile_options(${target} PRIVATE -fsanitize=${CONTACTD_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_link_options(${target} PUBLIC -fsanitize=${CONTACTD_SANITIZE})
  endif()
  if(CONTACTD_FUZZ)
    target_compile_options(${target} PRIVATE -fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_link_options(${target} PUBLIC -fsanitize=address,undefined)
  endif()
endfunction()

# contactd_portable(TARGET) makes a target look for its libraries in the system's folders, or where the packager
# specifies, and in no folder of the build machine.
function(contactd_portable target)
  set_target_properties(${target} PROPERTIES SKIP_BUILD_RPATH ON)
endfunction()

# contactd_complete(TARGET) links all libraries into a shared object if CONTACTD_WHEEL is set, except those that every
# Linux of recent years provides.
function(contactd_complete target)
  if(CONTACTD_WHEEL)
    contactd_portable(${target})
    target_sources(${target} PRIVATE ${PROJECT_SOURCE_DIR}/packaging/wheels/older_glibc.c)
    target_link_options(${target} PRIVATE -static-libstdc++ -static-libgcc -Wl,--gc-sections -Wl,-s)
  endif()
endfunction()

function(contactd_library name)
  add_library(contactd_${name} STATIC ${ARGN})
  add_library(contactd::${name} ALIAS contactd_${name})
  set_target_properties(contactd_${name} PROPERTIES EXPORT_NAME ${name})
  target_compile_features(contactd_${name} PUBLIC cxx_std_20)
  contactd_warnings(contactd_${name})
endfunction()

# contactd_unity(TARGET sources...) compiles the sources of each folder as one if CONTACTD_UNITY is set. They then share
# the largest cost: parsing the headers of JSON, Eigen and MFEM, and instantiating their templates. The `sources` stay
# separate, because each defines a name that another file of its folder defines, too. Files with their own options also
# stay separate.
function(contactd_unity target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${CONTACTD_UNITY} UNITY_BUILD_MODE GROUP)
  get_target_property(sources ${target} SOURCES)
  list(REMOVE_ITEM sources "" ${ARGN})
  foreach(source ${sources})
    cmake_path(GET source PARENT_PATH folder)
    string(MAKE_C_IDENTIFIER "${folder}" group)
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP "${group}")
  endforeach()
  if(CONTACTD_UNITY)
    target_compile_options(${target} PRIVATE -Wno-shadow)  # defined in another file, too
  endif()
endfunction()

# contactd_test(NAME sources...) creates a Catch2 program and registers its tests with ctest: one for each source with
# test cases, named by its path below tests/ without the extension. Cases tagged slow or long form a second test of that
# source with this label.
function(contactd_test name)
  add_executable(${name} ${ARGN})
  contactd_warnings(${name})
  target_link_libraries(${name} PRIVATE Catch2::Catch2WithMain)
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  foreach(source ${ARGN})
    file(STRINGS ${source} cases REGEX "TEST_CASE")
    file(STRINGS ${source} left_out REGEX "\\[(slow|long)\\]")
    cmake_path(GET source STEM file)
    if(cases AND NOT cases STREQUAL left_out)
      contactd_add_test(${name} ${source} "" COMMAND ${name} --filenames-as-tags "[#${file}]~[slow]~[long]")
    endif()
    foreach(label slow long)
      if(left_out MATCHES "\\[${label}\\]")
        contactd_add_test(${name} ${source} " (${label})" COMMAND ${name} --filenames-as-tags "[#${file}][${label}]")
        set_property(TEST ${test} PROPERTY LABELS ${label})
      endif()
    endforeach()
  endforeach()
endfunction()

# contactd_add_test(TARGET source suffix COMMAND...) names a test after its source, sets its time limit, and stores the
# name in `test`. TARGET must be built for it. build/<preset>/tests.txt lists all tests.
function(contactd_add_test target source suffix)
  cmake_path(ABSOLUTE_PATH source)
  cmake_path(RELATIVE_PATH source BASE_DIRECTORY ${PROJECT_SOURCE_DIR}/tests)
  cmake_path(REMOVE_EXTENSION source LAST_ONLY OUTPUT_VARIABLE test)
  string(APPEND test "${suffix}")
  add_test(NAME ${test} ${ARGN})
  set_tests_properties(${test} PROPERTIES TIMEOUT 900 SKIP_RETURN_CODE 4)  # all tests were skipped
  if(DEFINED contactd_test_cost)  # long tests start first, also before any run was timed
    set_tests_properties(${test} PROPERTIES COST ${contactd_test_cost})
  endif()
  set_property(GLOBAL APPEND PROPERTY contactd_tests "${test}\t${source}\t${target}\n")
  set(test ${test} PARENT_SCOPE)
endfunction()
