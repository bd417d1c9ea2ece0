# SPDX-License-Identifier: LGPL-2.1-or-later

# What `cmake --install` puts where, and the package that find_package(caudal) finds:
#   bin/caudal  lib/libcaudal.so  include/caudal/  lib/cmake/caudal/
#   share/caudal/scripts/  share/caudal/prm/       the scripts for runs and the cases
#   share/caudal/python/caudal/                    the package that reads results

# The program finds its library wherever the two are moved together.
file(RELATIVE_PATH _bin_to_lib
  ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})
set_target_properties(caudal libcaudal PROPERTIES INSTALL_RPATH_USE_LINK_PATH ON)
set_target_properties(caudal PROPERTIES
  INSTALL_RPATH "$ORIGIN/${_bin_to_lib}" EXPORT_NAME program)

install(TARGETS caudal libcaudal EXPORT caudalTargets
  RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR}
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY include/caudal DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})

set(_package ${CMAKE_INSTALL_LIBDIR}/cmake/caudal)
install(EXPORT caudalTargets NAMESPACE caudal:: DESTINATION ${_package})
configure_package_config_file(cmake/caudalConfig.cmake.in caudalConfig.cmake
  INSTALL_DESTINATION ${_package})
write_basic_package_version_file(caudalConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES
  ${PROJECT_BINARY_DIR}/caudalConfig.cmake ${PROJECT_BINARY_DIR}/caudalConfigVersion.cmake
  DESTINATION ${_package})

set(_share ${CMAKE_INSTALL_DATADIR}/caudal)
foreach(_script swim sweep plot report paraview salmon benchmark slurm)
  install(PROGRAMS scripts/${_script} DESTINATION ${_share}/scripts)
endforeach()
install(FILES scripts/environment scripts/caudal_setup.py DESTINATION ${_share}/scripts)
install(DIRECTORY scripts/benchmarks DESTINATION ${_share}/scripts USE_SOURCE_PERMISSIONS)
foreach(_python benchmarks paraview plots report salmon sweep)
  install(DIRECTORY scripts/caudal_${_python} DESTINATION ${_share}/scripts
    PATTERN __pycache__ EXCLUDE)
endforeach()
install(DIRECTORY python/caudal DESTINATION ${_share}/python PATTERN __pycache__ EXCLUDE)
install(DIRECTORY prm DESTINATION ${_share})
install(FILES README.md LICENSE CITATION.cff CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
