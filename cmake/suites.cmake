# SPDX-License-Identifier: MIT
# cmake -DPROGRAM=… -DNAME=… -DOUTPUT=… -DCASES=… -P suites.cmake: writes what ctest includes, a test
# for each suite of a GoogleTest program; for each case where CASES is true, or where only the case
# says its stage. A test is a process, and to start one takes longer than most cases do.
# (GoogleTest.cmake knows cases alone, and garbles lists of labels.) Where STAGELIGHT_DEVICE names a
# device, tests are called after that one: then what ctest includes asks anew, with no OUTPUT.
execute_process(COMMAND ${PROGRAM} --gtest_list_tests OUTPUT_VARIABLE listed COMMAND_ERROR_IS_FATAL ANY)
string(REGEX REPLACE " *#[^\n]*" "" listed "${listed}") # the values of parameters
string(REPLACE "\n" ";" lines "${listed}")

set(tests "")
macro(add name filter)
  set(label ${NAME})
  if("${name}" MATCHES "Stage([0-9][0-9])")
    set(label ${NAME}.stage${CMAKE_MATCH_1})
  endif()
  string(APPEND tests
         "add_test([=[${NAME}.${name}]=] [=[${PROGRAM}]=] [=[--gtest_filter=${filter}]=])\n"
         "set_tests_properties([=[${NAME}.${name}]=] PROPERTIES LABELS ${label})\n")
endmacro()

macro(finish_suite)
  if(CASES OR (NOT suite MATCHES "Stage[0-9]" AND cases MATCHES "Stage[0-9]"))
    foreach(case IN LISTS cases)
      add(${suite}.${case} ${suite}.${case})
    endforeach()
  elseif(cases)
    add(${suite} ${suite}.*)
  endif()
  set(cases "")
endmacro()

set(suite "")
set(cases "")
foreach(line IN LISTS lines)
  if(line MATCHES "^([^ ]+)\\.$")
    finish_suite()
    string(REGEX REPLACE "\\.$" "" suite "${line}")
  elseif(line MATCHES "^  (.+)$")
    list(APPEND cases ${CMAKE_MATCH_1})
  endif()
endforeach()
finish_suite()
if(OUTPUT)
  file(WRITE ${OUTPUT}
       "if(DEFINED ENV{STAGELIGHT_DEVICE})\n"
       "set(PROGRAM [=[${PROGRAM}]=])\nset(NAME [=[${NAME}]=])\nset(CASES [=[${CASES}]=])\n"
       "include([=[${CMAKE_CURRENT_LIST_FILE}]=])\n"
       "else()\n${tests}endif()\n")
else()
  cmake_language(EVAL CODE "${tests}")
endif()
