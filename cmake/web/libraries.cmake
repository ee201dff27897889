# SPDX-License-Identifier: MIT
# The libraries of a build for the browser, under the names by which the rooms link to them. HarfBuzz, FreeType, md4c and
# libmd are compiled from Debian's sources, unpacked in POLHODE_WEB_SOURCES by ./web; of fmt, toml++, nlohmann-json and
# OpenGL only headers are needed, those of the machine, through a folder of links: /usr/include itself is of another system.
enable_language(C)
set(POLHODE_WEB_SOURCES ${PROJECT_SOURCE_DIR}/build/web-sources CACHE PATH "Where ./web has unpacked sources")
foreach(library harfbuzz freetype md4c libmd)
  if(NOT IS_DIRECTORY ${POLHODE_WEB_SOURCES}/${library})
    message(FATAL_ERROR "the sources of ${library} are not in ${POLHODE_WEB_SOURCES}: run ./web, which fetches them")
  endif()
endforeach()

set(headers ${CMAKE_BINARY_DIR}/headers)
file(MAKE_DIRECTORY ${headers})
foreach(folder fmt toml++ nlohmann fast_float GL KHR)
  if(NOT EXISTS /usr/include/${folder})
    message(FATAL_ERROR "there is no /usr/include/${folder}: run ./web, which installs what is missing")
  endif()
  file(CREATE_LINK /usr/include/${folder} ${headers}/${folder} SYMBOLIC)
endforeach()
add_library(polhode_web_headers INTERFACE)
target_include_directories(polhode_web_headers SYSTEM INTERFACE ${headers})
# pkg-config asks for nothing here: the targets it would make are below.
function(pkg_check_modules)
endfunction()

add_library(fmt::fmt INTERFACE IMPORTED GLOBAL)
target_link_libraries(fmt::fmt INTERFACE polhode_web_headers)
target_compile_definitions(fmt::fmt INTERFACE FMT_HEADER_ONLY)
foreach(name tomlplusplus::tomlplusplus nlohmann_json::nlohmann_json Threads::Threads)
  add_library(${name} INTERFACE IMPORTED GLOBAL)
  target_link_libraries(${name} INTERFACE polhode_web_headers)
endforeach()

# Of another project: its warnings are its own.
function(polhode_web_library name alias)
  add_library(${name} STATIC ${ARGN})
  target_compile_options(${name} PRIVATE -w)
  add_library(${alias} ALIAS ${name})
endfunction()

set(md4c ${POLHODE_WEB_SOURCES}/md4c/src)
polhode_web_library(web_md4c PkgConfig::MD4C ${md4c}/md4c.c)
target_include_directories(web_md4c SYSTEM PUBLIC ${md4c})
target_compile_definitions(web_md4c PRIVATE MD4C_USE_UTF8)

set(md ${POLHODE_WEB_SOURCES}/libmd)
polhode_web_library(web_md PkgConfig::MD ${md}/src/sha2.c ${md}/src/sha256hl.c)
target_include_directories(web_md SYSTEM PUBLIC ${md}/include)
target_include_directories(web_md PRIVATE ${CMAKE_BINARY_DIR}/libmd)
file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/libmd/config.h CONTENT "#define HAVE_UNISTD_H 1\n")

# HarfBuzz without threads, FreeType with what OpenType fonts with CFF outlines and grey pixels need.
set(harfbuzz ${POLHODE_WEB_SOURCES}/harfbuzz/src)
polhode_web_library(web_harfbuzz PkgConfig::HARFBUZZ ${harfbuzz}/harfbuzz.cc)
target_include_directories(web_harfbuzz SYSTEM PUBLIC ${harfbuzz})
target_compile_definitions(web_harfbuzz PRIVATE HB_NO_MT)

set(freetype ${POLHODE_WEB_SOURCES}/freetype)
set(modules ${CMAKE_BINARY_DIR}/freetype/polhode_modules.h)
file(CONFIGURE OUTPUT ${modules} CONTENT [[
FT_USE_MODULE( FT_Driver_ClassRec, cff_driver_class )
FT_USE_MODULE( FT_Module_Class, psaux_module_class )
FT_USE_MODULE( FT_Module_Class, psnames_module_class )
FT_USE_MODULE( FT_Module_Class, pshinter_module_class )
FT_USE_MODULE( FT_Module_Class, sfnt_module_class )
FT_USE_MODULE( FT_Renderer_Class, ft_smooth_renderer_class )
]])
set(parts base/ftbase.c base/ftbitmap.c base/ftdebug.c base/ftinit.c base/ftmm.c base/ftsystem.c cff/cff.c gzip/ftgzip.c psaux/psaux.c
          pshinter/pshinter.c psnames/psnames.c sfnt/sfnt.c smooth/smooth.c)
list(TRANSFORM parts PREPEND ${freetype}/src/)
polhode_web_library(web_freetype Freetype::Freetype ${parts})
target_include_directories(web_freetype SYSTEM PUBLIC ${freetype}/include)
target_include_directories(web_freetype PRIVATE ${CMAKE_BINARY_DIR}/freetype)
target_compile_definitions(web_freetype PRIVATE FT2_BUILD_LIBRARY FT_CONFIG_MODULES_H=<polhode_modules.h>)
