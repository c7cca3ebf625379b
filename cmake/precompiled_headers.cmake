# The headers that nearly every unit includes are read once (g++): a unit then takes a third of the time. The build by clang
# does without, so that a missing #include shows there: clang writes the folder into its precompiled headers, and two
# checkouts could not share what the compiler cache holds. For g++ scripts/build_lib.sh tells ccache what it must know.
#
# rubicon_precompile(TARGET): a target of the product; rubicon_precompile_test(TARGET): with GoogleTest.
set(rubicon_pch_default OFF)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  set(rubicon_pch_default ON)
endif()
option(RUBICON_PCH "read the headers that all units include once (g++)" ${rubicon_pch_default})

if(RUBICON_PCH)
  file(WRITE ${PROJECT_BINARY_DIR}/precompiled.cpp "")
  set(standard_headers <algorithm> <array> <cmath> <cstdint> <functional> <limits> <map> <memory> <optional> <set> <span>
                       <string> <string_view> <utility> <variant> <vector> <Eigen/Geometry> <fmt/format.h>)
  add_library(rubicon_precompiled OBJECT ${PROJECT_BINARY_DIR}/precompiled.cpp)
  target_link_libraries(rubicon_precompiled PRIVATE rubicon_options)
  target_precompile_headers(rubicon_precompiled PRIVATE ${standard_headers})
endif()

function(rubicon_precompile target)
  if(RUBICON_PCH)
    target_precompile_headers(${target} REUSE_FROM rubicon_precompiled)
  endif()
endfunction()

function(rubicon_precompile_test target)
  if(NOT RUBICON_PCH)
    return()
  endif()
  if(NOT TARGET rubicon_precompiled_tests)
    add_library(rubicon_precompiled_tests OBJECT ${PROJECT_BINARY_DIR}/precompiled.cpp)
    target_link_libraries(rubicon_precompiled_tests PRIVATE rubicon_options GTest::gmock GTest::gtest)
    target_precompile_headers(rubicon_precompiled_tests PRIVATE ${standard_headers} <gmock/gmock.h> <gtest/gtest.h>)
  endif()
  target_precompile_headers(${target} REUSE_FROM rubicon_precompiled_tests)
endfunction()
