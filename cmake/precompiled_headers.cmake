# With RUBICON_PCH the headers that nearly every unit includes are read once. The check builds use it (sanitizers with the
# fuzz targets, other compilers): a unit then takes some 40 % less time. Release does without: a missing #include shows
# there, and with optimisation g++ 12 then warns inside its own headers.
#
# rubicon_precompile(TARGET): a target of the product; rubicon_precompile_test(TARGET): with GoogleTest.
if(RUBICON_PCH)
  file(WRITE ${PROJECT_BINARY_DIR}/precompiled.cpp "")
  set(standard_headers <algorithm> <array> <cstdint> <functional> <limits> <map> <memory> <optional> <set> <span> <string>
                       <string_view> <utility> <variant> <vector> <Eigen/Dense>)
  find_package(Eigen3 3.4 REQUIRED NO_MODULE)
endif()

# The headers as compiled with some options: units that share them must have the same.
function(rubicon_precompiled name)
  add_library(${name} OBJECT ${PROJECT_BINARY_DIR}/precompiled.cpp)
  target_link_libraries(${name} PRIVATE rubicon_options Eigen3::Eigen)
  target_precompile_headers(${name} PRIVATE ${standard_headers})
endfunction()

if(RUBICON_PCH)
  rubicon_precompiled(rubicon_precompiled)
  if(RUBICON_FUZZ)
    rubicon_precompiled(rubicon_precompiled_fuzzed)
    target_compile_options(rubicon_precompiled_fuzzed PRIVATE ${rubicon_fuzz_options})
  endif()
endif()

function(rubicon_precompile target)
  if(NOT RUBICON_PCH)
    return()
  endif()
  get_target_property(options ${target} COMPILE_OPTIONS)
  if(RUBICON_FUZZ AND "${rubicon_fuzz_options}" IN_LIST options)
    target_precompile_headers(${target} REUSE_FROM rubicon_precompiled_fuzzed)
  else()
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
