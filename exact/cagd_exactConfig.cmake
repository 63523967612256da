include(CMakeFindDependencyMacro)
find_dependency(cagd)
find_dependency(Threads)
include(${CMAKE_CURRENT_LIST_DIR}/cagd_exactTargets.cmake)
