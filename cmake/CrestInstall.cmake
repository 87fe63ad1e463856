# SPDX-License-Identifier: GPL-3.0-or-later
# What is installed: the programs with their man pages, completion, licence and documents (component
# runtime; scripts/package.sh makes a .deb of it) and the libraries with `find_package(Crest)`
# and pkg-config (component development), with the public headers under crest/.
include(CMakePackageConfigHelpers)
set(CMAKE_INSTALL_DOCDIR ${CMAKE_INSTALL_DATAROOTDIR}/doc/crest)

# The programs. Pages and completion are made from their --help, when they are installed.
get_property(checkers GLOBAL PROPERTY CREST_CHECKERS)
foreach(program crest crest-recheck ${checkers})
  if(TARGET ${program})
    install(TARGETS ${program} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT runtime)
    list(APPEND program_files $<TARGET_FILE:${program}>)
  endif()
endforeach()
if(program_files)
  set(made ${CMAKE_CURRENT_BINARY_DIR}/help)
  install(CODE "
    execute_process(COMMAND ${PROJECT_SOURCE_DIR}/scripts/man.sh ${made}/man1 ${PROJECT_VERSION}
      ${program_files} COMMAND_ERROR_IS_FATAL ANY)
    execute_process(COMMAND ${PROJECT_SOURCE_DIR}/scripts/completion.sh ${program_files}
      OUTPUT_FILE ${made}/crest COMMAND_ERROR_IS_FATAL ANY)" COMPONENT runtime)
  install(DIRECTORY ${made}/man1 DESTINATION ${CMAKE_INSTALL_MANDIR} COMPONENT runtime)
  install(FILES ${made}/crest DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
          COMPONENT runtime)
endif()
install(FILES LICENSES/GPL-3.0-or-later.txt RENAME LICENSE
        DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT runtime)
install(FILES .reuse/dep5 RENAME copyright
        DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT runtime)
install(FILES README.md CHANGELOG.md CITATION.cff references.bib
        DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT runtime)
install(DIRECTORY docs/ DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT runtime
        FILES_MATCHING PATTERN "*.md" PATTERN "pictures" EXCLUDE)
file(GLOB specifications RELATIVE ${PROJECT_SOURCE_DIR} certify/SPEC.md certify/*/SPEC.md)
foreach(specification ${specifications})
  get_filename_component(folder ${specification} DIRECTORY)
  install(FILES ${specification} DESTINATION ${CMAKE_INSTALL_DOCDIR}/${folder} COMPONENT runtime)
endforeach()

# The libraries.
get_property(crest_libraries GLOBAL PROPERTY CREST_LIBRARIES)
foreach(library ${crest_libraries})
  string(REGEX REPLACE "^crest_" "" short ${library})
  set_target_properties(${library} PROPERTIES EXPORT_NAME ${short})
endforeach()
set_target_properties(crest_systems PROPERTIES EXPORT_NAME systems)
install(TARGETS ${crest_libraries} crest_systems EXPORT CrestTargets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
install(EXPORT CrestTargets NAMESPACE Crest:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/Crest
        COMPONENT development)
install(CODE "
  execute_process(COMMAND ${CMAKE_COMMAND} -D SOURCE=${PROJECT_SOURCE_DIR} -D IO=${CREST_WITH_VTK}
    -D TO=${CMAKE_CURRENT_BINARY_DIR}/headers -P ${PROJECT_SOURCE_DIR}/cmake/public_headers.cmake
    COMMAND_ERROR_IS_FATAL ANY)" COMPONENT development)
install(DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/headers/crest DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
        COMPONENT development)
install(DIRECTORY examples DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT development)
configure_package_config_file(cmake/CrestConfig.cmake.in CrestConfig.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/Crest)
write_basic_package_version_file(CrestConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/CrestConfig.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/CrestConfigVersion.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/Crest COMPONENT development)
# Static libraries that use one another.
list(FILTER crest_libraries EXCLUDE REGEX "^crest_io")
list(TRANSFORM crest_libraries PREPEND "-l" OUTPUT_VARIABLE CREST_PC_LIBRARIES)
list(JOIN CREST_PC_LIBRARIES " " CREST_PC_LIBRARIES)
file(RELATIVE_PATH CREST_PC_UP /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
configure_file(cmake/crest.pc.in crest.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/crest.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
        COMPONENT development)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME crest)
set(CPACK_PACKAGE_CONTACT "The Crest developers <crest@localhost>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL runtime)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME crest)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SECTION math)
set(CPACK_STRIP_FILES ON)
include(CPack)
