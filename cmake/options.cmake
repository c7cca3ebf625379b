# Compiler options every target of the project shares, and one function to declare a module.

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE_PROGRAM})
endif()

add_library(rubicon_options INTERFACE)
# No fused multiply-add: the same bits on every processor and optimisation level.
target_compile_options(rubicon_options INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
                                                 -ffp-contract=off)
if(RUBICON_WERROR)
  target_compile_options(rubicon_options INTERFACE -Werror)
endif()
target_include_directories(rubicon_options INTERFACE $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>)

# rubicon_module(NAME SOURCES a.cpp ... USES other modules or libraries; PRIVATE libraries only its .cpp files see)
function(rubicon_module name)
  cmake_parse_arguments(ARG "" "" "SOURCES;USES;PRIVATE" ${ARGN})
  add_library(rubicon_${name} STATIC ${ARG_SOURCES})
  target_link_libraries(rubicon_${name} PUBLIC rubicon_options ${ARG_USES} PRIVATE ${ARG_PRIVATE})
endfunction()
