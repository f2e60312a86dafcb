# Debian packages, one a component of the install rules (scripts/deb.sh):
# musclewarp, musclewarp-cohort, libmusclewarp-dev and python3-musclewarp.
set(MUSCLEWARP_MAINTAINER
    "The musclewarp authors <musclewarp@invalid.invalid>"
    CACHE STRING "Whom the Debian packages name: Name <address>")

set(CPACK_GENERATOR DEB)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL programs cohort dev)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGE_CONTACT ${MUSCLEWARP_MAINTAINER})
# Each package has a summary of its own.
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/packaging/debian.cmake)
set(CPACK_MUSCLEWARP_LICENCES ${PROJECT_SOURCE_DIR}/packaging/copyright)
get_property(CPACK_MUSCLEWARP_PAGE GLOBAL PROPERTY MUSCLEWARP_PAGE)

set(ABOUT
    "musclewarp takes surface meshes of muscles and bones as segmentation leaves
them, and an OpenSim model with a motion, or action lines and poses. For
every frame it writes muscles that follow their action lines, keep their
volume and cross neither bones nor each other.")

set(CPACK_DEBIAN_PROGRAMS_PACKAGE_NAME musclewarp)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SUGGESTS
    "musclewarp-cohort, python3-musclewarp, tetgen, gmsh")
set(CPACK_DEBIAN_PROGRAMS_DESCRIPTION
    "deforms the muscles of a musculoskeletal model - programs
${ABOUT}

This package has the programs. They contain parts of CGAL and are therefore
under GPL-3.0-or-later; the sources are under Apache-2.0.")

set(CPACK_DEBIAN_COHORT_PACKAGE_NAME musclewarp-cohort)
set(CPACK_DEBIAN_COHORT_PACKAGE_SECTION science)
set(CPACK_DEBIAN_COHORT_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_COHORT_PACKAGE_DEPENDS
    "musclewarp (>= ${PROJECT_VERSION}), python3 (>= 3.9~), snakemake (>= 7)")
set(CPACK_DEBIAN_COHORT_PACKAGE_SUGGESTS "slurm-client")
set(CPACK_DEBIAN_COHORT_DESCRIPTION
    "deforms the muscles of a musculoskeletal model - many subjects
${ABOUT}

This package has musclewarp-cohort, which does so for many subjects: by
Snakemake, on one machine or on Slurm.")

# What musclewarpConfig.cmake finds (MusclewarpDependencies.cmake), by the names
# of Debian; .ci/check_deb.sh builds a project with no others.
set(DEV_DEPENDS
    libeigen3-dev
    libgoogle-glog-dev
    libgflags-dev
    libopenmesh-dev
    libceres-dev
    libcgal-dev
    nlohmann-json3-dev
    libpugixml-dev
    zlib1g-dev)
if(MUSCLEWARP_WITH_VTK)
  list(APPEND DEV_DEPENDS libvtk9-dev libegl-dev)
endif()
list(JOIN DEV_DEPENDS ", " CPACK_DEBIAN_DEV_PACKAGE_DEPENDS)
set(CPACK_DEBIAN_DEV_PACKAGE_NAME libmusclewarp-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEV_DESCRIPTION
    "deforms the muscles of a musculoskeletal model - C++ library
${ABOUT}

This package has the headers, the static libraries and what find_package of
CMake needs. What is linked with them contains parts of CGAL and is therefore
under GPL-3.0-or-later; the sources are under Apache-2.0.")

if(MUSCLEWARP_WITH_PYTHON)
  find_package(Python 3.9 REQUIRED COMPONENTS Interpreter)
  math(EXPR NEXT_MINOR "${Python_VERSION_MINOR} + 1")
  set(PYTHON_RANGE
      "python3 (>= ${Python_VERSION_MAJOR}.${Python_VERSION_MINOR}~)"
      "python3 (<< ${Python_VERSION_MAJOR}.${NEXT_MINOR}~)")
  list(JOIN PYTHON_RANGE ", " PYTHON_RANGE)
  list(APPEND CPACK_COMPONENTS_ALL python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-musclewarp)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
      "${PYTHON_RANGE}, python3-numpy (>= 1:1.21)")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS
      "musclewarp, python3-tqdm, python3-vtk9")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA
      ${PROJECT_SOURCE_DIR}/packaging/python3/postinst
      ${PROJECT_SOURCE_DIR}/packaging/python3/prerm)
  set(CPACK_DEBIAN_PYTHON_DESCRIPTION
      "deforms the muscles of a musculoskeletal model - Python package
${ABOUT}

This package has the Python package, over arrays of numpy. It contains parts of
CGAL and is therefore under GPL-3.0-or-later; the sources are under Apache-2.0.")
endif()
include(CPack)
