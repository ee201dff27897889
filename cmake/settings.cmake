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
  # What it asks of precompiled headers: ccache(1), "Precompiled headers".
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_NOHASHDIR=1 CCACHE_BASEDIR=${PROJECT_SOURCE_DIR}
                                  CCACHE_SLOPPINESS=pch_defines,time_macros ${POLHODE_CCACHE})
endif()

# Most of what the compiler reads in a file of ours are headers of the standard library and of Eigen. They are read once for
# all rooms, with those of some libraries once for the rooms that use these, with GoogleTest once for all tests. Our own files
# include what they use all the same: the preset clang builds without.
option(POLHODE_PRECOMPILE "Read headers of libraries once for all files" ON)
set(polhode_common_headers <algorithm> <array> <chrono> <cmath> <cstdint> <filesystem> <functional> <map> <memory> <numeric>
    <optional> <set> <span> <sstream> <string> <string_view> <tuple> <unordered_map> <utility> <variant> <vector> <Eigen/Core>
    <Eigen/Geometry>)

add_library(polhode_settings INTERFACE)
target_include_directories(polhode_settings INTERFACE ${PROJECT_SOURCE_DIR})
if(EMSCRIPTEN)
  # What a standard library of 2021 lacks; a newer one needs nothing.
  include(CheckCXXSourceCompiles)
  set(CMAKE_REQUIRED_FLAGS -std=c++20)
  check_cxx_source_compiles("#include <bit>\nint main() { return std::bit_cast<int>(0U); }" POLHODE_HAS_BIT_CAST)
  unset(CMAKE_REQUIRED_FLAGS)
  if(NOT POLHODE_HAS_BIT_CAST)
    target_include_directories(polhode_settings SYSTEM BEFORE INTERFACE ${PROJECT_SOURCE_DIR}/cmake/web/libcxx13)
    target_link_libraries(polhode_settings INTERFACE polhode_web_headers)
  endif()
endif()
# No contraction to fused multiply-add: Debug and Release, GCC and Clang give the same numbers.
target_compile_options(polhode_settings INTERFACE -ffp-contract=off)
if(POLHODE_CCACHE AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  target_compile_options(polhode_settings INTERFACE -fpch-preprocess)
endif()
# With precompiled headers GCC no longer knows std::string for a header of the system, and takes "text" + std::string for an
# overflow (GCC bug 105651), newer versions, and those for ARM, also for an index out of bounds.
if(POLHODE_PRECOMPILE AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  target_compile_options(polhode_settings INTERFACE -Wno-stringop-overflow -Wno-stringop-overread -Wno-restrict)
  if(CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 13 OR NOT CMAKE_SYSTEM_PROCESSOR STREQUAL "x86_64")
    target_compile_options(polhode_settings INTERFACE -Wno-array-bounds)
  endif()
endif()
# What is released is hardened as Debian hardens its packages: checked copies and a guarded stack; code at addresses that
# nobody can foresee, and tables of other libraries' functions that nobody can write to. The program reads lessons, pictures
# and reports of others.
target_compile_options(polhode_settings INTERFACE
  $<$<CONFIG:Release>:-fstack-protector-strong$<SEMICOLON>-U_FORTIFY_SOURCE$<SEMICOLON>-D_FORTIFY_SOURCE=2$<SEMICOLON>-fPIE>)
target_link_options(polhode_settings INTERFACE $<$<CONFIG:Release>:LINKER:-z,relro,-z,now$<SEMICOLON>-pie>)
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

# polhode_precompile(NAME HEADERS... LIBRARIES...): the common headers and these, for polhode_precompiled.
function(polhode_precompile name)
  cmake_parse_arguments(ARG "" "" "HEADERS;LIBRARIES" ${ARGN})
  if(POLHODE_PRECOMPILE)
    file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp CONTENT "" @ONLY)
    add_library(${name} OBJECT ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
    target_link_libraries(${name} PRIVATE polhode_settings ${ARG_LIBRARIES})
    set_target_properties(${name} PROPERTIES POLHODE_LIBRARIES "${ARG_LIBRARIES}")
    target_precompile_headers(${name} PRIVATE ${polhode_common_headers} ${ARG_HEADERS})
  endif()
endfunction()

# polhode_precompiled(TARGET NAME): its files begin with those headers. With the libraries come their macros, which have to
# be the same.
function(polhode_precompiled target name)
  if(POLHODE_PRECOMPILE)
    target_precompile_headers(${target} REUSE_FROM ${name})
    get_target_property(libraries ${name} POLHODE_LIBRARIES)
    target_link_libraries(${target} PRIVATE ${libraries})
  endif()
endfunction()

# polhode_layer(NAME sources... ) : a room of ARCHITECTURE.md as a static library. What is installed of it leaves our
# settings behind: they are for our own compilers. POLHODE_PRECOMPILED names the headers its files begin with.
function(polhode_layer name)
  add_library(${name} STATIC ${ARGN})
  target_link_libraries(${name} PUBLIC $<BUILD_INTERFACE:polhode_settings>)
  polhode_precompiled(${name} ${POLHODE_PRECOMPILED})
endfunction()
