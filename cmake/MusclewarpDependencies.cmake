# The packages musclewarp links; shared by the build and, once installed, by
# find_package(musclewarp).
find_package(Eigen3 3.4 REQUIRED)
find_package(glog REQUIRED)
find_package(gflags REQUIRED)
find_package(OpenMesh REQUIRED)
find_package(Ceres 2.1 REQUIRED)
find_package(CGAL 5.5 REQUIRED)
find_package(nlohmann_json 3.11 REQUIRED)
find_package(OpenMP REQUIRED)
if(MUSCLEWARP_WITH_VTK)
  find_package(VTK 9.1 REQUIRED
               COMPONENTS CommonCore CommonDataModel IOLegacy IOXML IOImage
                          RenderingCore RenderingOpenGL2)
endif()
