# How everything here is compiled, whatever the preset.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Debug, Release or RelWithDebInfo" FORCE)
endif()

add_library(knitmech_warnings INTERFACE)
target_compile_options(knitmech_warnings INTERFACE -Wall -Wextra -Wconversion)
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  # g++ 12 warns of `"text" + std::string` inside its own library: https://gcc.gnu.org/bugzilla/show_bug.cgi?id=105651
  target_compile_options(knitmech_warnings INTERFACE -Wno-restrict)
endif()
if(PROJECT_IS_TOP_LEVEL AND NOT DEFINED CMAKE_COMPILE_WARNING_AS_ERROR)
  set(CMAKE_COMPILE_WARNING_AS_ERROR ON)
endif()

# Nothing here asks for errno or for floating-point exceptions; to be told so lets the compiler vectorise loops with square
# roots and branches. `#pragma omp simd` marks loops whose terms may be taken in any order; no threads come with it. Products
# and sums stay separate, so that processors with and without a fused instruction agree.
add_compile_options(-ffp-contract=off -fno-math-errno -fno-trapping-math -fopenmp-simd)

# x86-64-v2 is what every x86-64 processor of the last ten years runs; functions that gain from more are compiled for newer
# processors besides (base/vectorise.h). "native" compiles everything for the machine at hand.
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64)$")
  set(KNITMECH_PROCESSOR x86-64-v2 CACHE STRING "Oldest processor the program must run on, as the compiler's -march names it")
  add_compile_options(-march=${KNITMECH_PROCESSOR})
endif()
