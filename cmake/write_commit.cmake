# Writes the commit of the sources into a header, which changes only when the commit does:
#   cmake -DSOURCE=... -DOUTPUT=... -DGIVEN=... -P write_commit.cmake
cmake_policy(VERSION 3.25)
set(commit "${GIVEN}")
if(NOT commit)
  set(commit unknown)
  find_program(git git)
  if(git)
    # The repository may belong to another user.
    set(ask ${git} -c safe.directory=* -C ${SOURCE})
    execute_process(COMMAND ${ask} rev-parse --show-toplevel OUTPUT_VARIABLE top OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    execute_process(COMMAND ${ask} rev-parse --short=12 HEAD OUTPUT_VARIABLE head OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    if(head AND top STREQUAL SOURCE)
      execute_process(COMMAND ${ask} status --porcelain --untracked-files=no OUTPUT_VARIABLE changes ERROR_QUIET)
      set(commit ${head})
      if(changes)
        string(APPEND commit -dirty)
      endif()
    endif()
  endif()
endif()
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT "// Made by cmake/write_commit.cmake.
#pragma once

namespace contactd::server {

inline constexpr const char* commit_text = \"@commit@\";

}  // namespace contactd::server
" @ONLY)
