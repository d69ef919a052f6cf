# cmake --install puts the program into bin, the libraries into lib, the headers into include/knitmech, and a CMake package
# beside the libraries: find_package(KnitMech) gives knitmech::knit, knitmech::solve and the other folders of src/, but not
# app and serve, which are the program itself. python/ installs the Python module.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/KnitMech)
set(doc_dir ${CMAKE_INSTALL_DATADIR}/doc/knitmech)

get_property(folders DIRECTORY ${PROJECT_SOURCE_DIR}/src PROPERTY SUBDIRECTORIES)
foreach(folder ${folders})
  get_filename_component(name ${folder} NAME)
  get_property(targets DIRECTORY ${folder} PROPERTY BUILDSYSTEM_TARGETS)
  foreach(target ${targets})
    get_target_property(type ${target} TYPE)
    if(type STREQUAL EXECUTABLE)
      install(TARGETS ${target} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
    elseif(type MATCHES "LIBRARY$" AND NOT name MATCHES "^(app|serve)$")
      install(TARGETS ${target} EXPORT KnitMechLibraries ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
    endif()
  endforeach()
  if(NOT name MATCHES "^(app|serve)$")
    install(DIRECTORY ${folder}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/knitmech/${name} FILES_MATCHING PATTERN "*.h")
  endif()
endforeach()

install(EXPORT KnitMechLibraries NAMESPACE knitmech:: DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/KnitMechConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_SOURCE_DIR}/cmake/KnitMechConfig.cmake ${PROJECT_BINARY_DIR}/KnitMechConfigVersion.cmake
  DESTINATION ${package_dir})

install(FILES LICENSE README.md CHANGELOG.md CITATION.cff DESTINATION ${doc_dir})
install(DIRECTORY docs examples DESTINATION ${doc_dir})

# Where man and the shells look for them.
set(words_dir ${PROJECT_BINARY_DIR}/words)
install(FILES ${words_dir}/knitmech.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${words_dir}/knitmech DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
install(FILES ${words_dir}/_knitmech DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions)
install(FILES ${words_dir}/knitmech.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
