# The day of the last commit, so that the same sources make the same files everywhere.
find_program(GIT git)
if(GIT AND NOT DEFINED ENV{SOURCE_DATE_EPOCH})
  execute_process(COMMAND ${GIT} -C ${CMAKE_SOURCE_DIR} log -1 --format=%ct OUTPUT_VARIABLE seconds
                  OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(seconds)
    set(ENV{SOURCE_DATE_EPOCH} ${seconds})
  endif()
endif()
string(TIMESTAMP LIMN_DATE "%Y-%m-%d" UTC)
