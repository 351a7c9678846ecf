# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
# An installed tree is complete and works from where it lies. Run by ctest: cmake -DBUILD=<build folder> -P test_install.cmake
set(tree ${BUILD}/install-test)
file(REMOVE_RECURSE ${tree})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${tree} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)

set(expected bin/hygroloom-cli lib/hygroloom/hygroloom-mesh share/man/man1/hygroloom-cli.1 share/bash-completion/completions/hygroloom-cli
  share/zsh/site-functions/_hygroloom-cli share/fish/vendor_completions.d/hygroloom-cli.fish share/doc/hygroloom/LICENSE share/hygroloom/examples/one-drop-on-cotton.hygro
  share/hygroloom/examples/paper/figure-08-wetted-radius.hygro share/hygroloom/examples/paper/README.md
  share/hygroloom/help/index.md share/hygroloom/help/drying.md share/hygroloom/examples/textile-F.study.json
  share/hygroloom/schema/hygroloom-project-1.schema.json)
if(EXISTS ${BUILD}/bin/hygroloom)
  list(APPEND expected bin/hygroloom share/man/man1/hygroloom.1 share/applications/hygroloom.desktop share/metainfo/org.hygroloom.Hygroloom.metainfo.xml
    share/mime/packages/hygroloom.xml share/icons/hicolor/scalable/apps/hygroloom.svg)
endif()
if(PYTHON AND EXISTS ${BUILD}/python)
  list(APPEND expected lib/python3/dist-packages/hygroloom/__init__.py lib/python3/dist-packages/hygroloom/py.typed
    share/hygroloom/examples/python/experiments.py)
endif()
if(EXISTS ${BUILD}/lib/hygroloom/hygroloom_openturns.so)
  list(APPEND expected lib/hygroloom/hygroloom_openturns.so)
endif()
foreach(file IN LISTS expected)
  if(NOT EXISTS ${tree}/${file})
    message(FATAL_ERROR "Not installed: ${file}")
  endif()
endforeach()
# Nor does anything come along that was made beside the source's examples.
file(GLOB_RECURSE installed LIST_DIRECTORIES true ${tree}/share/hygroloom/*)
list(FILTER installed INCLUDE REGEX "-runs$|/[.]|~$|__pycache__")
if(installed)
  message(FATAL_ERROR "Not of the source, but installed: ${installed}")
endif()
execute_process(COMMAND ${tree}/bin/hygroloom-cli check ${tree}/share/hygroloom/examples/one-drop-on-cotton.hygro
  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
# What reads files of strangers is found from the programs and from Python.
execute_process(COMMAND ${tree}/bin/hygroloom-cli garment import ${SOURCE}/tests/data/garments/sheet.dae -o ${tree}/sheet.hygro
  OUTPUT_VARIABLE said COMMAND_ERROR_IS_FATAL ANY)
if(NOT said MATCHES "front +0.2000 ")
  message(FATAL_ERROR "The installed program reads of sheet.dae: ${said}")
endif()
if(PYTHON AND EXISTS ${BUILD}/python)
  execute_process(COMMAND ${CMAKE_COMMAND} -E env PYTHONPATH=${tree}/lib/python3/dist-packages ${PYTHON} -c
    "import hygroloom, sys; p = hygroloom.Project.open(sys.argv[1]); p.set('experiments[0].duration_s', 1); hygroloom.simulate(p, experiment='wear', fidelity='live', backend='cpu')"
    ${tree}/sheet.hygro OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
endif()
file(REMOVE_RECURSE ${tree})
