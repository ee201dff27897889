# SPDX-License-Identifier: MIT
# What find_package finds where polhode is built for the browser: nothing of the machine that builds it. The targets are
# made by libraries.cmake, from headers and from sources that ./web has fetched. (Eigen is found as everywhere: headers
# alone, in a folder of their own.)
set(polhode_web_packages PkgConfig Freetype fmt tomlplusplus nlohmann_json Threads)
macro(polhode_web_package method name)
  if(${name} IN_LIST polhode_web_packages)
    set(${name}_FOUND TRUE)
  endif()
endmacro()
cmake_language(SET_DEPENDENCY_PROVIDER polhode_web_package SUPPORTED_METHODS FIND_PACKAGE)
