# contactd_library(NAME sources...) makes contactd_NAME with the alias contactd::NAME and the project's warnings.
function(contactd_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion)
  if(CONTACTD_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  if(CONTACTD_SANITIZE)
    # With sanitizers gcc finds false positives in std::regex.
    target_compile_options(${target} PRIVATE -Wno-maybe-uninitialized)
    target_compile_options(${target} PRIVATE -fsanitize=${CONTACTD_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_link_options(${target} PUBLIC -fsanitize=${CONTACTD_SANITIZE})
  endif()
  if(CONTACTD_FUZZ)
    target_compile_options(${target} PRIVATE -fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_link_options(${target} PUBLIC -fsanitize=address,undefined)
  endif()
endfunction()

# contactd_portable(TARGET): it finds its libraries where the system has them, or where who packs it says, and remembers no
# folder of the machine that built it.
function(contactd_portable target)
  set_target_properties(${target} PROPERTIES SKIP_BUILD_RPATH ON)
endfunction()

# contactd_complete(TARGET): where CONTACTD_WHEEL says so, all that a shared object needs is inside, but for what every Linux of the
# last years has.
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

# contactd_unity(TARGET sources...): where CONTACTD_UNITY says so, the sources of each folder are compiled as one. They share what
# costs more than they do: parsing the headers of JSON, Eigen and MFEM, and instances of their templates. The `sources` stay
# alone: each has a name that another one of its folder has, too. So do files with options of their own.
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
    target_compile_options(${target} PRIVATE -Wno-shadow)  # of a name of another file
  endif()
endfunction()

# contactd_test(NAME sources...) makes a Catch2 program and registers its tests with ctest: one for each source that has test
# cases, by its path below tests/ without the ending, and one more, labelled slow or long, for its cases with that tag.
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

# contactd_add_test(TARGET source suffix COMMAND...) names a test after its source, which it leaves in `test`, and limits its time;
# TARGET is what must be built for it. build/<preset>/tests.txt lists all of them.
function(contactd_add_test target source suffix)
  cmake_path(ABSOLUTE_PATH source)
  cmake_path(RELATIVE_PATH source BASE_DIRECTORY ${PROJECT_SOURCE_DIR}/tests)
  cmake_path(REMOVE_EXTENSION source LAST_ONLY OUTPUT_VARIABLE test)
  string(APPEND test "${suffix}")
  add_test(NAME ${test} ${ARGN})
  set_tests_properties(${test} PROPERTIES TIMEOUT 900 SKIP_RETURN_CODE 4)  # Catch2 says so where it has skipped all
  if(DEFINED contactd_test_cost)  # what takes longest begins first, also where nothing has run before
    set_tests_properties(${test} PROPERTIES COST ${contactd_test_cost})
  endif()
  set_property(GLOBAL APPEND PROPERTY contactd_tests "${test}\t${source}\t${target}\n")
  set(test ${test} PARENT_SCOPE)
endfunction()
