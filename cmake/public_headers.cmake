# SPDX-License-Identifier: MIT
# install_public_headers(COMPONENT ROOTS...): installs the headers ROOTS (paths from the root of the sources) and every
# header of ours that they lead to, all below include/polhode/:
#
#   physics/public/method.h     polhode/method.h            what a user includes
#   physics/method.h            polhode/physics/method.h    what that leads to
#
# In the sources a header is named from their root, `#include "physics/method.h"`. Of two libraries that did so one would
# find the other's base/result.h; so the installed copies say `#include "polhode/physics/method.h"`, and nothing but the
# prefix's include/ has to be on a user's path. Which headers to install is read from their includes, hence complete.
function(install_public_headers component)
  include(GNUInstallDirs)
  set(pending ${ARGN})
  set(seen ${ARGN})
  while(pending)
    list(POP_FRONT pending header)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${header})
    file(READ ${PROJECT_SOURCE_DIR}/${header} text)
    string(REGEX MATCHALL "#include \"[^\"\n]+\"" includes "${text}")
    foreach(include IN LISTS includes)
      string(REGEX REPLACE "#include \"(.*)\"" "\\1" included "${include}")
      if(NOT included IN_LIST seen)
        list(APPEND pending ${included})
        list(APPEND seen ${included})
      endif()
    endforeach()
    string(REPLACE "#include \"" "#include \"polhode/" text "${text}")
    string(REGEX REPLACE "^physics/public/" "" path ${header})
    set(copy ${PROJECT_BINARY_DIR}/include/polhode/${path})
    # Written only where it differs: touching a header builds nobody's program again.
    file(CONFIGURE OUTPUT ${copy} CONTENT "${text}" @ONLY)
    cmake_path(GET path PARENT_PATH folder)
    install(FILES ${copy} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/polhode/${folder} COMPONENT ${component})
  endwhile()
endfunction()
