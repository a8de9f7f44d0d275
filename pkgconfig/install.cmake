# Install rules: headers, libraries, qtraj.pc and the CMake package. Every path in them is relative to the file it stands
# in, so that the installed tree can be moved.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/qtraj)
set(pc_dir ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

install(FILES include/qtraj.h include/qtraj.hpp DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})

# One export file for each kind of library: a distribution may package them apart.
foreach(kind shared static)
  if(TARGET qtraj_${kind})
    install(TARGETS qtraj_${kind} EXPORT qtraj-${kind} INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
    install(EXPORT qtraj-${kind} NAMESPACE qtraj:: FILE qtraj-${kind}-targets.cmake DESTINATION ${package_dir})
  endif()
endforeach()

write_basic_package_version_file(${PROJECT_BINARY_DIR}/qtraj-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES pkgconfig/qtraj-config.cmake ${PROJECT_BINARY_DIR}/qtraj-config-version.cmake
        DESTINATION ${package_dir})

# qtraj.pc: relative to itself, unless the folders were given as absolute paths.
if(IS_ABSOLUTE "${CMAKE_INSTALL_LIBDIR}")
  set(pc_prefix ${CMAKE_INSTALL_PREFIX})
else()
  file(RELATIVE_PATH pc_to_prefix "/${pc_dir}" "/")
  string(REGEX REPLACE "/$" "" pc_to_prefix "${pc_to_prefix}")
  set(pc_prefix "\${pcfiledir}/${pc_to_prefix}")
endif()
foreach(dir LIBDIR INCLUDEDIR)
  if(IS_ABSOLUTE "${CMAKE_INSTALL_${dir}}")
    set(pc_${dir} ${CMAKE_INSTALL_${dir}})
  else()
    set(pc_${dir} "\${prefix}/${CMAKE_INSTALL_${dir}}")
  endif()
endforeach()

# What a program needs beside libqtraj.a: only with pkg-config --static where the shared library is there too.
set(pc_private "")
if(QTRAJ_BUILD_SHARED)
  set(pc_private _private)
endif()
if(qtraj_elf)
  set(pc_libs${pc_private} " -lm")
endif()
set(pc_cflags${pc_private} " -DQTRAJ_STATIC")

configure_file(pkgconfig/qtraj.pc.in ${PROJECT_BINARY_DIR}/qtraj.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/qtraj.pc DESTINATION ${pc_dir})
