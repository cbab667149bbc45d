# Where things are installed. Debian keeps libraries in a folder of the architecture, under /usr/local
# as under /usr; GNUInstallDirs knows of the latter only.
if (NOT DEFINED CMAKE_INSTALL_LIBDIR AND EXISTS /etc/debian_version AND CMAKE_LIBRARY_ARCHITECTURE)
  set(CMAKE_INSTALL_LIBDIR "lib/${CMAKE_LIBRARY_ARCHITECTURE}" CACHE PATH "Folder of libraries")
endif ()
if (NOT DEFINED CMAKE_INSTALL_DOCDIR)
  set(CMAKE_INSTALL_DOCDIR share/doc/surfaceflattening CACHE PATH "Folder of documentation")
endif ()
include(GNUInstallDirs)
