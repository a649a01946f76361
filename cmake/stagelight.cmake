# SPDX-License-Identifier: MIT
# The stages, and the functions that the modules are declared with.

# A folder is all it takes: a new one is found at the next build.
file(GLOB stagelight_stages CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}/stages
     ${PROJECT_SOURCE_DIR}/stages/[0-9][0-9]_*/main.cpp)
list(TRANSFORM stagelight_stages REPLACE "/main.cpp" "")

option(STAGELIGHT_SANITIZE "Build with AddressSanitizer and UndefinedBehaviorSanitizer" OFF)
option(STAGELIGHT_SANITIZE_THREAD "Build with ThreadSanitizer" OFF)
option(STAGELIGHT_FUZZ "Build what ./stagelight fuzz runs, which needs Clang" OFF)
option(STAGELIGHT_PEERS "Build ./stagelight bench peers, which needs packages/peers.txt" OFF)

set(stagelight_sanitizers "")
if(STAGELIGHT_SANITIZE OR STAGELIGHT_FUZZ)
  set(stagelight_sanitizers address,undefined)
elseif(STAGELIGHT_SANITIZE_THREAD)
  set(stagelight_sanitizers thread)
endif()

# Warnings for our own targets; the preset ci makes them errors.
function(stagelight_target target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion
                                           -Wnon-virtual-dtor -Wold-style-cast)
  if(stagelight_sanitizers)
    target_compile_options(${target} PRIVATE -fsanitize=${stagelight_sanitizers} -fno-sanitize-recover=all
                                             -fno-omit-frame-pointer)
    target_link_options(${target} PUBLIC -fsanitize=${stagelight_sanitizers})
  endif()
  if(STAGELIGHT_FUZZ)
    target_compile_options(${target} PRIVATE -fsanitize=fuzzer-no-link)
  endif()
endfunction()

# What most of common/ includes.
set(precompiled_headers <algorithm> <array> <cmath> <filesystem> <fstream> <functional> <map> <optional>
                        <sstream> <string> <vector> <glm/glm.hpp> <fmt/format.h>)

# stagelight_module(NAME SOURCES … LIBRARIES … [PRECOMPILED HEADERS… | PRECOMPILED_FROM NAME]): one folder of
# common/ as the library stagelight_NAME.
function(stagelight_module name)
  cmake_parse_arguments(PARSE_ARGV 1 module "" "PRECOMPILED_FROM" "SOURCES;LIBRARIES;PRECOMPILED")
  add_library(stagelight_${name} STATIC ${module_SOURCES})
  target_include_directories(stagelight_${name} PUBLIC ${PROJECT_SOURCE_DIR}/common)
  target_link_libraries(stagelight_${name} PUBLIC ${module_LIBRARIES})
  stagelight_target(stagelight_${name})
  # Without tests somebody waits for a first picture, and the compiler mostly reads the same headers again.
  # With tests each file must show that it includes what it needs.
  if(NOT BUILD_TESTING)
    if(module_PRECOMPILED)
      target_precompile_headers(stagelight_${name} PRIVATE ${module_PRECOMPILED})
    elseif(module_PRECOMPILED_FROM)
      target_precompile_headers(stagelight_${name} REUSE_FROM stagelight_${module_PRECOMPILED_FROM})
    endif()
  endif()
endfunction()
