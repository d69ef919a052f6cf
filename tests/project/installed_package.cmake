# Installs the build into a prefix of its own, builds a small program against the installed package, and runs that, the
# installed knitmech and, where it was built, the installed Python module.
set(prefix ${work_dir}/prefix)
file(REMOVE_RECURSE ${work_dir})

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY OUTPUT_VARIABLE output OUTPUT_STRIP_TRAILING_WHITESPACE)
  set(output "${output}" PARENT_SCOPE)
endfunction()

run(${CMAKE_COMMAND} --install ${build_dir} --prefix ${prefix})
foreach(file share/man/man1/knitmech.1 share/bash-completion/completions/knitmech share/zsh/site-functions/_knitmech
    share/fish/vendor_completions.d/knitmech.fish share/doc/knitmech/LICENSE include/knitmech/base/errors.h include/knitmech/solve/simulate.h)
  if(NOT EXISTS ${prefix}/${file})
    message(FATAL_ERROR "${file} was not installed")
  endif()
endforeach()

run(${CMAKE_COMMAND} -G ${generator} -S ${consumer_dir} -B ${work_dir}/consumer
  -D CMAKE_PREFIX_PATH=${prefix} -D CMAKE_CXX_COMPILER=${compiler} -D CMAKE_CXX_FLAGS=${flags})
run(${CMAKE_COMMAND} --build ${work_dir}/consumer)
run(${work_dir}/consumer/consumer ${case_file})
if(NOT output STREQUAL "2715 nodes, 2700 elements, interrupted")
  message(FATAL_ERROR "The program that uses the installed package printed: ${output}")
endif()

run(${prefix}/bin/knitmech --version)
if(NOT output MATCHES "[0-9]+\\.[0-9]+\\.[0-9]+")
  message(FATAL_ERROR "The installed knitmech --version printed: ${output}")
endif()

if(python)
  run(${CMAKE_COMMAND} -E env PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=${prefix}/${python_site}
    ${python} -c "import knitmech\nprint(knitmech.__file__, knitmech.Case.read('${case_file}').model())")
  if(NOT output STREQUAL "${prefix}/${python_site}/knitmech/__init__.py <knitmech.Model of 2715 nodes and 2700 elements>")
    message(FATAL_ERROR "The installed Python module printed: ${output}")
  endif()
endif()
