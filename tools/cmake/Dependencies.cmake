# Debian 12 packages; each is found once, here.
find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)

list(APPEND CMAKE_MODULE_PATH /usr/lib/${CMAKE_LIBRARY_ARCHITECTURE}/cmake/OpenVDB)
find_package(OpenVDB 10 REQUIRED COMPONENTS openvdb)  # also gives TBB::tbb
list(POP_BACK CMAKE_MODULE_PATH)                      # its FindOpenEXR and others would shadow the configs

find_package(OpenImageIO 2.4 REQUIRED CONFIG)
# The package names an OpenCV include folder that Debian does not install with it.
foreach(property INTERFACE_INCLUDE_DIRECTORIES INTERFACE_SYSTEM_INCLUDE_DIRECTORIES)
  get_target_property(directories OpenImageIO::OpenImageIO ${property})
  if(directories)
    list(FILTER directories EXCLUDE REGEX "opencv")
    set_target_properties(OpenImageIO::OpenImageIO PROPERTIES ${property} "${directories}")
  endif()
endforeach()

find_package(glm REQUIRED CONFIG)
find_package(CLI11 REQUIRED CONFIG)
find_package(tomlplusplus REQUIRED CONFIG)
find_package(nlohmann_json REQUIRED CONFIG)
find_package(fmt REQUIRED CONFIG)
find_package(muparser REQUIRED CONFIG)
find_package(assimp REQUIRED CONFIG)
find_package(glfw3 3.3 REQUIRED CONFIG)
pkg_check_modules(epoxy REQUIRED IMPORTED_TARGET epoxy)
pkg_check_modules(imgui REQUIRED IMPORTED_TARGET imgui)
if(EIKONAL_TESTS)
  find_package(GTest REQUIRED CONFIG)
endif()
