# SPDX-License-Identifier: LGPL-2.1-or-later

# The target `revision` writes caudal/base/revision.h in the build folder, which defines
# CAUDAL_REVISION, the git revision of the sources: empty if it is unknown. It is looked up in each
# build, so that it is right after a commit, and written only where it has changed.
# This file is also the script that does it.

# In an archive that git made (git archive, a release's tarball) git has put the revision here: that
# by the last tag, if there is one, and the commit.
set(_archived "$Format:%(describe:tags=true) %h$")

if(NOT CMAKE_SCRIPT_MODE_FILE)
  set(CAUDAL_GENERATED_INCLUDE_DIR ${PROJECT_BINARY_DIR}/include)
  find_package(Git QUIET)
  add_custom_target(revision
    COMMAND ${CMAKE_COMMAND}
      -D GIT=${GIT_EXECUTABLE} -D SOURCE=${PROJECT_SOURCE_DIR}
      -D HEADER=${CAUDAL_GENERATED_INCLUDE_DIR}/caudal/base/revision.h -P ${CMAKE_CURRENT_LIST_FILE}
    BYPRODUCTS ${CAUDAL_GENERATED_INCLUDE_DIR}/caudal/base/revision.h
    COMMENT "Looking up the revision of the sources" VERBATIM)
  return()
endif()

set(_revision "")
if(_archived MATCHES "^([^$%]*) ([0-9a-f]+)$")
  set(_revision "${CMAKE_MATCH_1}")
  if(_revision STREQUAL "")
    set(_revision "${CMAKE_MATCH_2}")
  endif()
elseif(GIT)
  # The folder itself has to be the repository, not one that it was unpacked in.
  execute_process(COMMAND ${GIT} rev-parse --show-cdup WORKING_DIRECTORY ${SOURCE}
    OUTPUT_VARIABLE _way_up RESULT_VARIABLE _status ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(_status EQUAL 0 AND "${_way_up}" STREQUAL "")
    execute_process(COMMAND ${GIT} describe --tags --always --dirty WORKING_DIRECTORY ${SOURCE}
      OUTPUT_VARIABLE _revision ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
  endif()
endif()
file(CONFIGURE OUTPUT ${HEADER} CONTENT "#define CAUDAL_REVISION \"${_revision}\"\n")
