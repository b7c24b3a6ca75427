# CTest runs this before the tests, for each executable of limn_add_test without windows: every suite of it becomes one
# test, a process of its own, because a process for each of thousands of small tests would take longer than they do.
# What failed in it is in what GoogleTest prints. The list is kept until the executable is built anew.
#   executable, folder  the executable, and where it is run
#   list                the file of CTest's commands that is written
#   apart               suites of which each test is a process
#   properties          those of each test
#   registration        the file that says all this
cmake_policy(VERSION 3.25) # CTest sets none
if(NOT EXISTS "${executable}")
  get_filename_component(name "${executable}" NAME)
  add_test("${name}_NOT_BUILT" "${name}_NOT_BUILT")
  return()
endif()
if(NOT EXISTS "${list}" OR NOT "${list}" IS_NEWER_THAN "${executable}" OR
   NOT "${list}" IS_NEWER_THAN "${CMAKE_CURRENT_LIST_FILE}" OR NOT "${list}" IS_NEWER_THAN "${registration}")
  execute_process(COMMAND "${executable}" --gtest_list_tests WORKING_DIRECTORY "${folder}" TIMEOUT 60
                  OUTPUT_VARIABLE listed ERROR_VARIABLE complaints RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${executable} did not list its tests: ${status}\n${complaints}")
  endif()
  get_filename_component(name "${executable}" NAME)
  set(commands "")
  # A suite stands at the beginning of its line and ends with a dot; its tests are indented. Values of parameters stand
  # behind a #.
  string(REGEX REPLACE " +#[^\n]*" "" listed "${listed}")
  string(REPLACE "\n" ";" lines "${listed}")
  foreach(line IN LISTS lines)
    if(line MATCHES "^([A-Za-z_][A-Za-z0-9_/]*)\\.$")
      set(suite ${CMAKE_MATCH_1})
      set(filter ${suite}.*)
    elseif(line MATCHES "^  ([^ ]+)$" AND suite IN_LIST apart)
      set(filter ${suite}.${CMAKE_MATCH_1})
    else()
      continue()
    endif()
    if(suite IN_LIST apart AND filter STREQUAL "${suite}.*")
      continue()
    endif()
    string(REPLACE ".*" "" test "${name}.${filter}")
    string(APPEND commands "add_test([=[${test}]=] [=[${executable}]=] [=[--gtest_filter=${filter}]=])\n"
                           "set_tests_properties([=[${test}]=] PROPERTIES WORKING_DIRECTORY [=[${folder}]=] "
                           "FAIL_REGULAR_EXPRESSION \"Running 0 tests\" ${properties})\n")
  endforeach()
  file(WRITE "${list}" "${commands}")
endif()
include("${list}")
