# SPDX-License-Identifier: GPL-3.0-or-later
# `find_package(Crest)` for users of the libraries.
include(CMakePackageConfigHelpers)
get_property(crest_libraries GLOBAL PROPERTY CREST_LIBRARIES)
list(APPEND crest_libraries crest_systems)
foreach(library ${crest_libraries})
  string(REGEX REPLACE "^crest_" "" short ${library})
  set_target_properties(${library} PROPERTIES EXPORT_NAME ${short})
endforeach()
install(TARGETS ${crest_libraries} EXPORT CrestTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT CrestTargets NAMESPACE Crest:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/Crest)
install(DIRECTORY kernel certify algorithms io DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/crest
        FILES_MATCHING PATTERN "*.hpp")
configure_package_config_file(cmake/CrestConfig.cmake.in CrestConfig.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/Crest)
write_basic_package_version_file(CrestConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/CrestConfig.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/CrestConfigVersion.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/Crest)
get_property(checkers GLOBAL PROPERTY CREST_CHECKERS)
foreach(program crest crest-recheck ${checkers})
  if(TARGET ${program})
    install(TARGETS ${program} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  endif()
endforeach()
