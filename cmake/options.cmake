# What every target of the project shares: the place of its headers, warnings, floating point rules, sanitizers.

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE_PROGRAM})
endif()

# The headers, as "src/motion/math/pose.hpp" or "interpreter/machine/machine.hpp"; all that a user of the installed library gets.
add_library(rubicon_headers INTERFACE)
target_compile_features(rubicon_headers INTERFACE cxx_std_20)
target_include_directories(
  rubicon_headers INTERFACE $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
                            $<INSTALL_INTERFACE:${RUBICON_INSTALL_INCLUDEDIR}>)

# How our own code is compiled; never handed on to users of the library.
add_library(rubicon_options INTERFACE)
target_link_libraries(rubicon_options INTERFACE rubicon_headers)
# No fused multiply-add: the same bits on every processor and optimisation level.
target_compile_options(rubicon_options INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
                                                 -ffp-contract=off)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  # g++ 12 sees overlaps in the joining of std::strings that are not there (its bug 105651, fixed in 13).
  target_compile_options(rubicon_options INTERFACE -Wno-restrict)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # Else ccache cannot keep what was compiled with precompiled headers; without these it changes nothing.
  target_compile_options(rubicon_options INTERFACE -fpch-preprocess)
endif()
# Part of the precompiled headers, so every unit has the same definitions.
target_link_libraries(rubicon_options INTERFACE Eigen3::Eigen fmt::fmt)
if(CMAKE_UNITY_BUILD)
  # Several files are compiled as one unit (presets release and asan): what one names may hide what another does, and what is
  # in a file looks as if it were in a header. Builds of the other presets look for real cases.
  target_compile_options(rubicon_options INTERFACE -Wno-shadow $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
endif()
if(RUBICON_WERROR)
  target_compile_options(rubicon_options INTERFACE -Werror)
endif()

# RUBICON_SANITIZE is a list for -fsanitize=, e.g. "address;undefined". The whole build gets it, or none of it.
if(RUBICON_SANITIZE)
  list(JOIN RUBICON_SANITIZE "," sanitizers)
  add_compile_options(-fsanitize=${sanitizers} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${sanitizers})
  if(RUBICON_SANITIZE_NOT)
    # Those that look at every access to memory, as the address sanitizer does anyway: without them a unit takes 23 s instead of 40.
    list(JOIN RUBICON_SANITIZE_NOT "," left_out)
    add_compile_options(-fno-sanitize=${left_out})
  endif()
  add_compile_definitions(_GLIBCXX_ASSERTIONS)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # The checks that the sanitizers add split the paths g++ reasons about; it then warns inside Eigen and std::variant.
    target_compile_options(rubicon_options INTERFACE -Wno-maybe-uninitialized)
  endif()
endif()

# With RUBICON_SANITIZE: the modules that are done with their work in a blink, optimised or not. Without, they are compiled in half the time.
set(rubicon_quick_modules
    advice answers area_io building_io cluster comparison debug encoding files film flow gantt gltf golden layout page palette project_io
    report search statistics study urdf why)

# With RUBICON_FUZZ: the modules whose ways through the code guide the fuzzer (tests/fuzz).
set(rubicon_fuzzed_modules interpreter project_io building_io urdf ifc verify film debug why)
set(rubicon_fuzz_options -fsanitize=fuzzer-no-link)
