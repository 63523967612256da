include(CMakeFindDependencyMacro)
find_dependency(cagd_exact)
include(${CMAKE_CURRENT_LIST_DIR}/cagd_exactlyTargets.cmake)
