# With RUBICON_PCH (g++ only) the headers that nearly every unit includes are read once: src/motion/math/pose.cpp takes 0.4 s
# instead of 1.4 s. Not for clang, which writes the folder into its precompiled headers, so that two checkouts could not share
# what the compiler cache holds; for g++ they can, and scripts/build_lib.sh tells ccache what it must know.
#
# rubicon_precompile(TARGET): a target of the product; rubicon_precompile_test(TARGET): with GoogleTest.
option(RUBICON_PCH "read the headers that all units include once (g++)" OFF)

if(RUBICON_PCH)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    # Reading them so, g++ 12 sees overflows in the joining of std::strings that are not there (its bug 105651, fixed in 13).
    # The builds without precompiled headers and the sanitizers look for such faults.
    target_compile_options(rubicon_options INTERFACE -Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread)
  endif()
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
    if(CMAKE_BUILD_TYPE STREQUAL "Release")
      target_compile_options(rubicon_precompiled_tests PRIVATE -O1)  # as tests are compiled (tests/CMakeLists.txt)
    endif()
    target_precompile_headers(rubicon_precompiled_tests PRIVATE ${standard_headers} <gmock/gmock.h> <gtest/gtest.h>)
  endif()
  target_precompile_headers(${target} REUSE_FROM rubicon_precompiled_tests)
endfunction()
