# RUBICON_VIEWER_PAGE: the page that viewer/ is built into, one file; empty where that is not possible, and then
# `rubicon` works but for the page.
option(RUBICON_VIEWER "build the report page (needs node 18 or later and npm)" ON)
set(RUBICON_VIEWER_PAGE ${PROJECT_BINARY_DIR}/viewer/index.html)
set(RUBICON_STUDY_PAGE ${PROJECT_BINARY_DIR}/viewer/study.html)

find_program(NODE_PROGRAM NAMES node nodejs)
find_program(NPM_PROGRAM npm)
set(why_no_page "")
if(NOT RUBICON_VIEWER)
  set(why_no_page "RUBICON_VIEWER is off")
elseif(NOT EXISTS ${PROJECT_SOURCE_DIR}/viewer/package-lock.json)
  set(why_no_page "there is no viewer/package-lock.json")
elseif(NOT NODE_PROGRAM OR NOT NPM_PROGRAM)
  set(why_no_page "node or npm is not there")
else()
  execute_process(COMMAND ${NODE_PROGRAM} --version OUTPUT_VARIABLE node_version OUTPUT_STRIP_TRAILING_WHITESPACE
                  ERROR_QUIET)
  string(REGEX REPLACE "^v" "" node_version "${node_version}")
  if(node_version VERSION_LESS 18)
    set(why_no_page "node is version '${node_version}', and the page needs 18 or later")
  endif()
endif()

if(why_no_page)
  add_custom_command(
    OUTPUT ${RUBICON_VIEWER_PAGE} ${RUBICON_STUDY_PAGE}
    COMMAND ${CMAKE_COMMAND} -E echo "warning: rubicon is built without the report page: ${why_no_page}"
    COMMAND ${CMAKE_COMMAND} -E make_directory ${PROJECT_BINARY_DIR}/viewer
    COMMAND ${CMAKE_COMMAND} -E rm -f ${RUBICON_VIEWER_PAGE} ${RUBICON_STUDY_PAGE}
    COMMAND ${CMAKE_COMMAND} -E touch ${RUBICON_VIEWER_PAGE} ${RUBICON_STUDY_PAGE}
    COMMENT "Leaving out the report page"
    VERBATIM)
else()
  add_custom_command(
    OUTPUT ${RUBICON_VIEWER_PAGE} ${RUBICON_STUDY_PAGE}
    COMMAND ${PROJECT_SOURCE_DIR}/cmake/build_viewer ${PROJECT_SOURCE_DIR}/viewer ${PROJECT_BINARY_DIR}/viewer
            ${NPM_PROGRAM}
    DEPENDS ${PROJECT_SOURCE_DIR}/cmake/build_viewer ${PROJECT_SOURCE_DIR}/viewer/package-lock.json
    # The sources; a glob would make the build ask anew each time. A new source counts as soon as an old one names it.
    DEPFILE ${PROJECT_BINARY_DIR}/viewer.d
    COMMENT "Building the report page"
    VERBATIM)
endif()
