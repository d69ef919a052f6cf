# The Python module: KNITMECH_PYTHON is AUTO, which builds it where an interpreter with its headers and NumPy, and pybind11
# are found; ON, which asks for them; or OFF.
set(KNITMECH_PYTHON AUTO CACHE STRING "Build the Python module: ON, OFF, or AUTO (where Python, NumPy and pybind11 are found)")
set_property(CACHE KNITMECH_PYTHON PROPERTY STRINGS AUTO ON OFF)
set(KNITMECH_HAS_PYTHON OFF)
if(NOT KNITMECH_PYTHON)
  return()
endif()

# The first python3 on the path need not be the one that has NumPy.
function(knitmech_check_python result program)
  execute_process(
    COMMAND ${program} -c "import numpy, os, sysconfig; open(os.path.join(sysconfig.get_path('include'), 'Python.h'))"
    RESULT_VARIABLE failed OUTPUT_QUIET ERROR_QUIET)
  if(failed)
    set(${result} FALSE PARENT_SCOPE)
  endif()
endfunction()
find_program(KNITMECH_PYTHON_INTERPRETER python3 VALIDATOR knitmech_check_python
  DOC "Interpreter for which the Python module is built")

if(KNITMECH_PYTHON_INTERPRETER)
  set(Python_EXECUTABLE ${KNITMECH_PYTHON_INTERPRETER})
  find_package(Python 3.9 QUIET COMPONENTS Interpreter Development.Module)
  find_package(pybind11 2.10 QUIET CONFIG)
endif()
if(Python_FOUND AND pybind11_FOUND)
  set(KNITMECH_HAS_PYTHON ON)
elseif(NOT KNITMECH_PYTHON STREQUAL AUTO)
  message(FATAL_ERROR "The Python module needs Python with its headers, NumPy and pybind11; on Debian these are "
    "python3-dev, python3-numpy and pybind11-dev. Without them, configure with -D KNITMECH_PYTHON=OFF.")
endif()
