# With RUBICON_PCH the headers that nearly every unit includes are read once. The check builds use it (sanitizers, other
# compilers, fuzzing): a unit then takes some 40 % less time. Release does without, so a missing #include shows there.
#
# rubicon_precompile(TARGET): a target of the product; rubicon_precompile_test(TARGET): with GoogleTest.
if(RUBICON_PCH)
  file(WRITE ${PROJECT_BINARY_DIR}/precompiled.cpp "")
  set(standard_headers <algorithm> <array> <cstdint> <functional> <limits> <map> <memory> <optional> <set> <span> <string>
                       <string_view> <utility> <variant> <vector> <Eigen/Dense>)
  find_package(Eigen3 3.4 REQUIRED NO_MODULE)

  add_library(rubicon_precompiled OBJECT ${PROJECT_BINARY_DIR}/precompiled.cpp)
  target_link_libraries(rubicon_precompiled PRIVATE rubicon_options Eigen3::Eigen)
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
    target_link_libraries(rubicon_precompiled_tests PRIVATE rubicon_options Eigen3::Eigen GTest::gmock GTest::gtest)
    target_precompile_headers(rubicon_precompiled_tests PRIVATE ${standard_headers} <gmock/gmock.h> <gtest/gtest.h>)
  endif()
  target_precompile_headers(${target} REUSE_FROM rubicon_precompiled_tests)
endfunction()
