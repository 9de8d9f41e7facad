# Builds the filters a second time, against the VTK that ParaView brings, and the plugin around it. The
# plugin and what it loads lie in lib/paraview-5.11/plugins/Medial of the build folder.
if(MEDIAL_BUILD_FILTERS OR MEDIAL_BUILD_APPS OR MEDIAL_BUILD_TESTS)
  message(FATAL_ERROR "MEDIAL_BUILD_PARAVIEW needs a build folder of its own, as ParaView has a VTK "
    "of its own: cmake --preset paraview")
endif()
# Without COMPONENTS, find_package(ParaView) looks for Qt's development files.
find_package(ParaView 5.11 REQUIRED COMPONENTS
  ProcessXML RemotingCore RemotingServerManager VTKExtensionsFiltersGeneral WrapClientServer)

set(BUILD_SHARED_LIBS ON)
set(MEDIAL_PLUGIN_DIR "paraview-${ParaView_VERSION_MAJOR}.${ParaView_VERSION_MINOR}/plugins")
paraview_plugin_scan(
  PLUGIN_FILES "${CMAKE_CURRENT_LIST_DIR}/paraview.plugin"
  PROVIDES_PLUGINS plugins
  ENABLE_BY_DEFAULT ON
  HIDE_PLUGINS_FROM_CACHE ON)
paraview_plugin_build(
  PLUGINS ${plugins}
  LIBRARY_SUBDIRECTORY "${MEDIAL_PLUGIN_DIR}"
  INSTALL_HEADERS OFF)
medial_warnings(Filters)
target_compile_options(Filters PUBLIC $<BUILD_INTERFACE:-Wno-pedantic>)
