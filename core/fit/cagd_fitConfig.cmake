include(CMakeFindDependencyMacro)
find_dependency(cagd)
find_dependency(Ceres)
include(${CMAKE_CURRENT_LIST_DIR}/cagd_fitTargets.cmake)
