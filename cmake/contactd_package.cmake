# Debian packages by CPack: contactd (daemon, builder, unit, configuration), python3-contactd (client),
# python3-contactd-local (the client's solver for use without a daemon), contactctl (command line), and the C libraries
# libcontactd1, libcontactd-local1 and libcontactd-cntc0. libcontactd-dev and libcontactd-cntc-dev contain the headers.
#   ./dev package
set(package_files ${PROJECT_SOURCE_DIR}/packaging)

# contactd_compressed(FILE NAME DESTINATION COMPONENT) installs FILE as NAME.gz with reproducible bytes.
function(contactd_compressed file name destination component)
  set(made ${PROJECT_BINARY_DIR}/packaging/${component}/${name}.gz)
  add_custom_command(OUTPUT ${made} DEPENDS ${file}
    COMMAND sh -c "mkdir -p '${PROJECT_BINARY_DIR}/packaging/${component}' && gzip -9nc '${file}' >'${made}'" VERBATIM)
  add_custom_target(contactd_${component}_${name} ALL DEPENDS ${made})
  install(FILES ${made} DESTINATION ${destination} COMPONENT ${component})
endfunction()

contactd_compressed(${package_files}/man/contactd.8 contactd.8 share/man/man8 programs)
contactd_compressed(${package_files}/man/contactd-ic.1 contactd-ic.1 share/man/man1 programs)
contactd_compressed(${package_files}/man/contactctl.1 contactctl.1 share/man/man1 cli)
contactd_compressed(${package_files}/debian/changelog changelog share/doc/contactd programs)
contactd_compressed(${package_files}/debian/changelog changelog share/doc/python3-contactd python)
install(FILES ${package_files}/debian/copyright DESTINATION share/doc/contactd COMPONENT programs)
install(FILES ${package_files}/debian/copyright DESTINATION share/doc/python3-contactd COMPONENT python)
foreach(package IN ITEMS libcontactd1=c_library libcontactd-local1=c_local_library libcontactd-dev=c_development
    libcontactd-cntc0=cntc libcontactd-cntc-dev=cntc_development python3-contactd-local=python_local contactctl=cli)
  string(REGEX MATCH "^(.+)=(.+)$" package ${package})
  contactd_compressed(${package_files}/debian/changelog changelog share/doc/${CMAKE_MATCH_1} ${CMAKE_MATCH_2})
  install(FILES ${package_files}/debian/copyright DESTINATION share/doc/${CMAKE_MATCH_1} COMPONENT ${CMAKE_MATCH_2})
endforeach()
install(FILES ${package_files}/contactd.service DESTINATION lib/systemd/system COMPONENT programs)
install(FILES ${package_files}/contactd.json DESTINATION /etc/contactd COMPONENT programs)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/client/python/contactd DESTINATION lib/python3/dist-packages COMPONENT python
  PATTERN __pycache__ EXCLUDE)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/client/python/contactctl DESTINATION lib/python3/dist-packages COMPONENT cli
  PATTERN __pycache__ EXCLUDE)
install(PROGRAMS ${package_files}/contactctl DESTINATION bin COMPONENT cli)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME contactd)
# The first line of each description is that of the project.
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "elastic contact with computed influence coefficients, as a service")
set(CPACK_PACKAGE_CONTACT "contactd authors <contactd@example.org>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_COMPONENTS_ALL programs python python_local cli c_library c_local_library c_development cntc cntc_development)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
if(CMAKE_SYSTEM_PROCESSOR STREQUAL aarch64) # for which CPack would use the name of this machine
  set(CPACK_DEBIAN_PACKAGE_ARCHITECTURE arm64)
endif()
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_DEBIAN_PROGRAMS_PACKAGE_NAME contactd)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_DEPENDS "adduser, init-system-helpers (>= 1.52)")
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_RECOMMENDS "openmpi-bin")
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SUGGESTS "contactctl, python3-contactd")
set(CPACK_DEBIAN_PROGRAMS_DESCRIPTION "The daemon solves contact problems with the boundary element method. Where the
influence coefficients of the bodies have no closed form, a second program
computes them with finite elements; they are kept in HDF5 files. Clients talk
to it over ZeroMQ, with JSON envelopes and raw array frames.")
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_CONTROL_EXTRA ${package_files}/debian/postinst ${package_files}/debian/prerm
  ${package_files}/debian/postrm ${PROJECT_BINARY_DIR}/packaging/conffiles)
file(WRITE ${PROJECT_BINARY_DIR}/packaging/conffiles "/etc/contactd/contactd.json\n")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-contactd)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3 (>= 3.10), python3-numpy, python3-zmq")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-h5py, contactd, python3-contactd-local")
set(CPACK_DEBIAN_PYTHON_DESCRIPTION "client of contactd, elastic contact as a service (Python 3)
Contact problems, tables of influence coefficients and stresses inside bodies
from Python: plain classes in, NumPy arrays out.")

# One module serves all versions of Python from 3.10 on.
set(CPACK_DEBIAN_PYTHON_LOCAL_PACKAGE_NAME python3-contactd-local)
set(CPACK_DEBIAN_PYTHON_LOCAL_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_LOCAL_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PYTHON_LOCAL_PACKAGE_DEPENDS "python3-contactd (= ${PROJECT_VERSION}), python3 (>= 3.10)")
set(CPACK_DEBIAN_PYTHON_LOCAL_PACKAGE_SUGGESTS "contactd")
set(CPACK_DEBIAN_PYTHON_LOCAL_DESCRIPTION "elastic contact in the process of Python (Python 3)
What contactd.local() of python3-contactd solves with, instead of a daemon.")

set(CPACK_DEBIAN_CLI_PACKAGE_NAME contactctl)
set(CPACK_DEBIAN_CLI_PACKAGE_SECTION science)
set(CPACK_DEBIAN_CLI_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_CLI_PACKAGE_DEPENDS "python3-contactd (= ${PROJECT_VERSION}), \
python3 (>= 3.10), python3-numpy, python3-rich, python3-typer, python3-yaml, python3-zmq")
set(CPACK_DEBIAN_CLI_PACKAGE_SUGGESTS "contactd, python3-contactd-local, python3-distributed, python3-h5py, python3-matplotlib, python3-scipy")
set(CPACK_DEBIAN_CLI_DESCRIPTION "command line of contactd, elastic contact as a service
Contact problems, wheels on rails, tables of influence coefficients and
parameter studies from a terminal and from scripts: tables or JSON out.")

# contactd_library_package(COMPONENT NAME DESCRIPTION...) defines the package of a shared library. The name of the
# package contains the version.
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS_POLICY ">=")
file(WRITE ${PROJECT_BINARY_DIR}/packaging/triggers "activate-noawait ldconfig\n")
function(contactd_library_package component name)
  string(TOUPPER CPACK_DEBIAN_${component} prefix)
  list(JOIN ARGN "\n" description)
  set(${prefix}_PACKAGE_NAME ${name} PARENT_SCOPE)
  set(${prefix}_PACKAGE_SECTION libs PARENT_SCOPE)
  set(${prefix}_PACKAGE_SHLIBDEPS ON PARENT_SCOPE)
  set(${prefix}_PACKAGE_CONTROL_EXTRA ${PROJECT_BINARY_DIR}/packaging/triggers PARENT_SCOPE)
  set(${prefix}_DESCRIPTION "${description}" PARENT_SCOPE)
endfunction()

contactd_library_package(c_library libcontactd1 "C library of contactd, elastic contact as a service"
  "Contacts step by step, solved by a daemon, from C and what calls C:"
  "opaque handles, plain numbers, codes with sentences.")
contactd_library_package(c_local_library libcontactd-local1 "C library of contactd, elastic contact in process"
  "The functions of libcontactd1, which also solve in process, without a daemon.")
set(CPACK_DEBIAN_C_DEVELOPMENT_PACKAGE_NAME libcontactd-dev)
set(CPACK_DEBIAN_C_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_C_DEVELOPMENT_PACKAGE_DEPENDS
  "libcontactd1 (= ${PROJECT_VERSION}), libcontactd-local1 (= ${PROJECT_VERSION})")
set(CPACK_DEBIAN_C_DEVELOPMENT_DESCRIPTION "C libraries of contactd, elastic contact (development files)
The header contactd.h, and what CMake and pkg-config ask for.")

contactd_library_package(cntc libcontactd-cntc0 "functions of the CONTACT program's C library, by contactd"
  "Programs that are coupled to that library solve basic contact in process"
  "with contactd by linking this one instead.")
set(CPACK_DEBIAN_CNTC_DEVELOPMENT_PACKAGE_NAME libcontactd-cntc-dev)
set(CPACK_DEBIAN_CNTC_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_CNTC_DEVELOPMENT_PACKAGE_DEPENDS "libcontactd-cntc0 (= ${PROJECT_VERSION})")
set(CPACK_DEBIAN_CNTC_DEVELOPMENT_DESCRIPTION "functions of the CONTACT program's C library (development files)
The header contactd_cntc.h, and what CMake and pkg-config ask for.")

# Control files have fixed names, so those of this package are stored under a different name.
foreach(package IN ITEMS python3-contactd=python contactctl=cli)
  string(REGEX MATCH "^(.+)=(.+)$" package ${package})
  foreach(script postinst prerm)
    configure_file(${package_files}/debian/${CMAKE_MATCH_1}.${script}
      ${PROJECT_BINARY_DIR}/packaging/${CMAKE_MATCH_2}/${script} COPYONLY)
  endforeach()
endforeach()
set(CPACK_DEBIAN_CLI_PACKAGE_CONTROL_EXTRA ${PROJECT_BINARY_DIR}/packaging/cli/postinst
  ${PROJECT_BINARY_DIR}/packaging/cli/prerm)
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA ${PROJECT_BINARY_DIR}/packaging/python/postinst
  ${PROJECT_BINARY_DIR}/packaging/python/prerm)
include(CPack)
