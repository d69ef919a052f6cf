# One library per folder of src/: knitmech_add_library(knit SOURCES loop.cpp DEPENDS base) makes knitmech_knit, alias
# knitmech::knit. DEPENDS names other folders, PRIVATE_DEPENDS targets of libraries that no public header shows.
# Includes are written from src/: #include "knit/loop.h".
function(knitmech_add_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS;PRIVATE_DEPENDS" ${ARGN})
  add_library(knitmech_${name} STATIC ${ARG_SOURCES})
  add_library(knitmech::${name} ALIAS knitmech_${name})
  set_target_properties(knitmech_${name} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON)
  target_compile_features(knitmech_${name} PUBLIC cxx_std_20)
  # The same layout of Eigen's types in a program that is compiled for another processor than the library.
  target_compile_definitions(knitmech_${name} PUBLIC EIGEN_MAX_ALIGN_BYTES=16)
  target_include_directories(knitmech_${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>
    $<INSTALL_INTERFACE:include/knitmech>)
  list(TRANSFORM ARG_DEPENDS PREPEND knitmech::)
  target_link_libraries(knitmech_${name}
    PUBLIC ${ARG_DEPENDS}
    PRIVATE $<BUILD_INTERFACE:knitmech_warnings> ${ARG_PRIVATE_DEPENDS})
endfunction()
