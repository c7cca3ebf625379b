# The library as others find it: find_package(rubicon) and the target rubicon::rubicon, beside the commands.
include(CMakePackageConfigHelpers)

get_property(modules GLOBAL PROPERTY RUBICON_MODULES)

# The command has the name rubicon, so the library that joins all modules has another one inside the build.
add_library(rubicon_library INTERFACE)
add_library(rubicon::rubicon ALIAS rubicon_library)
target_link_libraries(rubicon_library INTERFACE ${modules})
set_target_properties(rubicon_library PROPERTIES EXPORT_NAME rubicon)

install(TARGETS rubicon_library rubicon_headers ${modules} EXPORT rubicon_targets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT rubicon_targets NAMESPACE rubicon:: DESTINATION ${RUBICON_INSTALL_CMAKEDIR})

# Private headers show the types of libraries that users need not have.
install(DIRECTORY interpreter src DESTINATION ${RUBICON_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.hpp"
        PATTERN "cli" EXCLUDE PATTERN "*assimp*" EXCLUDE PATTERN "*pugixml*" EXCLUDE PATTERN "*simdjson*" EXCLUDE PATTERN "parse_*.hpp" EXCLUDE)

install(FILES ${PROJECT_SOURCE_DIR}/THIRD_PARTY_NOTICES.md DESTINATION ${CMAKE_INSTALL_DOCDIR})

configure_package_config_file(cmake/rubicon-config.cmake.in rubicon-config.cmake
                              INSTALL_DESTINATION ${RUBICON_INSTALL_CMAKEDIR})
# Before 1.0 a new minor version may break its users.
write_basic_package_version_file(rubicon-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/rubicon-config.cmake ${PROJECT_BINARY_DIR}/rubicon-config-version.cmake
        DESTINATION ${RUBICON_INSTALL_CMAKEDIR})
