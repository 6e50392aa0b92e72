# contactd_library(NAME sources...) makes contactd_NAME with the alias contactd::NAME and the project's warnings.
function(contactd_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion)
  if(CONTACTD_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  if(CONTACTD_SANITIZE)
    # With sanitizers gcc finds false positives in std::regex (valijson).
    target_compile_options(${target} PRIVATE -Wno-maybe-uninitialized)
    target_compile_options(${target} PRIVATE -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_link_options(${target} PUBLIC -fsanitize=address,undefined)
  endif()
endfunction()

function(contactd_library name)
  add_library(contactd_${name} STATIC ${ARGN})
  add_library(contactd::${name} ALIAS contactd_${name})
  set_target_properties(contactd_${name} PROPERTIES EXPORT_NAME ${name})
  target_compile_features(contactd_${name} PUBLIC cxx_std_20)
  contactd_warnings(contactd_${name})
endfunction()

# contactd_test(NAME sources... ) makes a Catch2 program and registers its cases with ctest, each with a time limit.
function(contactd_test name)
  add_executable(${name} ${ARGN})
  contactd_warnings(${name})
  target_link_libraries(${name} PRIVATE Catch2::Catch2WithMain)
  catch_discover_tests(${name} TEST_PREFIX "${name}: " DISCOVERY_MODE PRE_TEST PROPERTIES TIMEOUT 900)
endfunction()
