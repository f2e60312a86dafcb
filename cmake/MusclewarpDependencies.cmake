# The packages musclewarp links, one string each, as find_package takes them.
# The build and, once installed, musclewarpConfig.cmake read this list; it
# depends on MUSCLEWARP_WITH_VTK and MUSCLEWARP_WITH_OPENMP.
set(MUSCLEWARP_PACKAGES
    "Eigen3 3.4"
    "glog"
    "gflags"
    "OpenMesh"
    "Ceres 2.1"
    "CGAL 5.5"
    "nlohmann_json 3.11"
    "pugixml 1.12"
    "ZLIB")
if(MUSCLEWARP_WITH_OPENMP)
  list(APPEND MUSCLEWARP_PACKAGES "OpenMP COMPONENTS CXX")
endif()
if(MUSCLEWARP_WITH_VTK)
  list(APPEND MUSCLEWARP_PACKAGES
       "VTK 9.1 COMPONENTS CommonCore CommonDataModel CommonExecutionModel FiltersCore ImagingGeneral IOLegacy IOXML IOXMLParser IOImage RenderingCore RenderingFreeType RenderingOpenGL2 glew"
       "OpenGL COMPONENTS EGL")
endif()
