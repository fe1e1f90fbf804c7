# usar_add_robot(NAME PLUGIN file.cpp SOURCES …): a behavior plugin that sees the SDK and nothing else, into the folder
# robots of the build. PLUGIN is the file with Q_PLUGIN_METADATA; SOURCES form usar::robot_NAME, which tests link as
# well. The same in Mission Control's own tree and with an installed SDK.
function(usar_add_robot name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "PLUGIN" "SOURCES")
  if(arg_UNPARSED_ARGUMENTS OR NOT arg_PLUGIN)
    message(FATAL_ERROR "usar_add_robot(${name}): needs PLUGIN; unknown arguments ${arg_UNPARSED_ARGUMENTS}")
  endif()
  if(arg_SOURCES)
    add_library(usar_robot_${name} STATIC ${arg_SOURCES})
    add_library(usar::robot_${name} ALIAS usar_robot_${name})
    target_link_libraries(usar_robot_${name} PUBLIC usar::agent Qt6::Core)
    set_target_properties(usar_robot_${name} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    if(COMMAND usar_precompiled)
      usar_precompiled(usar_robot_${name} robot)
    endif()
  endif()
  add_library(usar_plugin_${name} MODULE ${arg_PLUGIN})
  target_link_libraries(usar_plugin_${name} PRIVATE usar::agent $<TARGET_NAME_IF_EXISTS:usar_robot_${name}>)
  if(NOT USAR_ROBOT_FOLDER)
    set(USAR_ROBOT_FOLDER ${CMAKE_BINARY_DIR}/robots)
  endif()
  # What a plugin brings of the SDK is its own: two builds of one plugin are loaded side by side.
  target_link_options(usar_plugin_${name} PRIVATE LINKER:--exclude-libs,ALL)
  # It includes its own, so that CMake's collection of all others is empty and needs no headers.
  set_source_files_properties(${CMAKE_CURRENT_BINARY_DIR}/usar_plugin_${name}_autogen/mocs_compilation.cpp
    PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
  set_target_properties(usar_plugin_${name} PROPERTIES AUTOMOC ON PREFIX "" OUTPUT_NAME ${name}
    CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON LIBRARY_OUTPUT_DIRECTORY ${USAR_ROBOT_FOLDER})
endfunction()
