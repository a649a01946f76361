# SPDX-License-Identifier: MIT
# The functions that the rooms of the house are declared with.

option(STAGELIGHT_SANITIZE "Build with AddressSanitizer and UndefinedBehaviorSanitizer" OFF)
option(STAGELIGHT_PEERS "Build ./stagelight bench peers, which needs packages_peers.txt" OFF)

# Warnings are errors, on our own targets only.
function(stagelight_target target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion
                                           -Wnon-virtual-dtor -Wold-style-cast -Werror)
  if(STAGELIGHT_SANITIZE)
    target_compile_options(${target} PRIVATE -fsanitize=address,undefined -fno-sanitize-recover=all
                                             -fno-omit-frame-pointer)
    target_link_options(${target} PUBLIC -fsanitize=address,undefined)
  endif()
endfunction()

# stagelight_room(NAME SOURCES … LIBRARIES …): one folder of common/ as the library stagelight_NAME.
function(stagelight_room name)
  cmake_parse_arguments(PARSE_ARGV 1 room "" "" "SOURCES;LIBRARIES")
  add_library(stagelight_${name} STATIC ${room_SOURCES})
  target_include_directories(stagelight_${name} PUBLIC ${PROJECT_SOURCE_DIR}/common)
  target_link_libraries(stagelight_${name} PUBLIC ${room_LIBRARIES})
  stagelight_target(stagelight_${name})
endfunction()
