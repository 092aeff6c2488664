# What the libraries stand on; all of it comes from Debian 12 packages (packages.txt).
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(NLopt REQUIRED)
find_package(mrpt-bayes REQUIRED)
find_package(mrpt-maps REQUIRED)
find_package(mrpt-topography REQUIRED)
find_package(ZLIB REQUIRED)
find_package(pugixml REQUIRED)
find_package(Threads REQUIRED)
