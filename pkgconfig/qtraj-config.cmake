# find_package(qtraj [version] CONFIG [COMPONENTS shared static])
#
# Targets: qtraj::shared and qtraj::static, those that are installed; qtraj::qtraj is the shared library, or the static
# one where there is no other. Components only ask for one of them to be there. No language but C is needed.
if(CMAKE_VERSION VERSION_LESS 3.18)
  set(qtraj_FOUND FALSE)
  set(qtraj_NOT_FOUND_MESSAGE "qtraj needs CMake 3.18 or later")
  return()
endif()

foreach(_qtraj_kind shared static)
  include("${CMAKE_CURRENT_LIST_DIR}/qtraj-${_qtraj_kind}-targets.cmake" OPTIONAL)
  if(TARGET qtraj::${_qtraj_kind})
    set(qtraj_${_qtraj_kind}_FOUND TRUE)
    if(NOT TARGET qtraj::qtraj)
      add_library(qtraj::qtraj ALIAS qtraj::${_qtraj_kind})
    endif()
  endif()
endforeach()
unset(_qtraj_kind)

foreach(_qtraj_component IN LISTS qtraj_FIND_COMPONENTS)
  if(qtraj_FIND_REQUIRED_${_qtraj_component} AND NOT qtraj_${_qtraj_component}_FOUND)
    set(qtraj_FOUND FALSE)
    set(qtraj_NOT_FOUND_MESSAGE "qtraj: component '${_qtraj_component}' is not installed (there are shared and static)")
  endif()
endforeach()
unset(_qtraj_component)
