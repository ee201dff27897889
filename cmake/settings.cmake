# SPDX-License-Identifier: MIT
# Compiler settings every target of ours shares.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()

find_program(POLHODE_CCACHE ccache)
if(POLHODE_CCACHE)
  # Paths relative to the source folder: a fresh clone finds what another clone has compiled.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_NOHASHDIR=1 CCACHE_BASEDIR=${PROJECT_SOURCE_DIR}
                                  ${POLHODE_CCACHE})
endif()

add_library(polhode_settings INTERFACE)
target_include_directories(polhode_settings INTERFACE ${PROJECT_SOURCE_DIR})
# No contraction to fused multiply-add: Debug and Release, GCC and Clang give the same numbers.
target_compile_options(polhode_settings INTERFACE -ffp-contract=off)
if(POLHODE_WARNINGS_AS_ERRORS)
  target_compile_options(polhode_settings INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror)
endif()
if(POLHODE_SANITIZE)
  target_compile_options(polhode_settings INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=all
                         -fno-omit-frame-pointer)
  target_link_options(polhode_settings INTERFACE -fsanitize=address,undefined)
  # GCC takes its own <regex> for uninitialised under a sanitizer (GCC bug 105562).
  target_compile_options(polhode_settings INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
endif()

# polhode_layer(NAME sources... ) : a room of ARCHITECTURE.md as a static library. What is installed of it leaves our
# settings behind: they are for our own compilers.
function(polhode_layer name)
  add_library(${name} STATIC ${ARGN})
  target_link_libraries(${name} PUBLIC $<BUILD_INTERFACE:polhode_settings>)
endfunction()
