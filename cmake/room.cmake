# A room: a folder whose files have one concern. `room()`, called from the CMakeLists.txt of the folder, makes one library of
# all its sources. Its arguments are its arrows: the only rooms (folders from the checkout's root) that its files may include.
#   room(SEES compare/base membrane/laws   LIBRARIES GSL::gsl)
# The target of compare/base is compare_base. All arrows are written to rooms.txt in the build folder, for the include lint.
# The rooms of PLAIN_ROOMS are compiled with less optimisation. With VALIDATE_UNITY a room's sources are compiled together, so
# that names in its anonymous namespaces must not clash; SEPARATE is for a room where they still do.

function(room_target folder result)
  string(REPLACE "/" "_" name ${folder})
  if(NOT folder MATCHES "/")
    string(APPEND name "_data") # membrane, atomistic: the plain structs beside the leaf's rooms
  endif()
  set(${result} ${name} PARENT_SCOPE)
endfunction()

function(room)
  cmake_parse_arguments(ROOM "SEPARATE" "" "SEES;LIBRARIES" ${ARGN})
  file(RELATIVE_PATH folder ${CMAKE_SOURCE_DIR} ${CMAKE_CURRENT_SOURCE_DIR})
  room_target(${folder} name)
  file(GLOB sources CONFIGURE_DEPENDS *.cpp)
  list(FILTER sources EXCLUDE REGEX "/main\\.cpp$") # a program's
  if(sources)
    set(scope PUBLIC)
    add_library(${name} STATIC ${sources})
    if(VALIDATE_WERROR AND folder IN_LIST CONVERSION_FREE_ROOMS)
      target_compile_options(${name} PRIVATE -Wconversion)
    endif()
    # fmt's definitions are in the precompiled headers: GCC would not use them in a room that lacks them.
    target_compile_definitions(${name} PRIVATE $<TARGET_PROPERTY:fmt::fmt,INTERFACE_COMPILE_DEFINITIONS>)
    if(folder IN_LIST PLAIN_ROOMS)
      target_link_libraries(${name} PRIVATE plain_options)
      target_precompile_headers(${name} REUSE_FROM plain_headers)
    else()
      target_precompile_headers(${name} REUSE_FROM project_headers)
    endif()
    if(NOT ROOM_SEPARATE)
      set_target_properties(${name} PROPERTIES UNITY_BUILD ${VALIDATE_UNITY} UNITY_BUILD_BATCH_SIZE 8)
    endif()
  else()
    set(scope INTERFACE)
    add_library(${name} INTERFACE)
  endif()
  set(seen project_options)
  foreach(other ${ROOM_SEES})
    room_target(${other} target)
    list(APPEND seen ${target})
  endforeach()
  target_link_libraries(${name} ${scope} ${seen} ${ROOM_LIBRARIES})
  if(folder MATCHES "^membrane")
    set_property(GLOBAL APPEND PROPERTY MEMBRANE_ROOMS ${name}) # what is installed for others
  endif()
  list(JOIN ROOM_SEES " " arrows)
  set_property(GLOBAL APPEND_STRING PROPERTY ROOM_ARROWS "${folder}: ${arrows}\n")
endfunction()
