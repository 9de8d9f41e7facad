# VTK, for the programs: the modules that their folders name.
find_package(VTK 9.1 REQUIRED COMPONENTS
  ChartsCore CommonCore CommonDataModel CommonExecutionModel CommonMath CommonMisc
  FiltersCore FiltersGeometry FiltersModeling FiltersSources ImagingCore InteractionStyle InteractionWidgets
  IOCore IOGeometry IOImage IOXML RenderingAnnotation RenderingContext2D RenderingContextOpenGL2 RenderingCore
  RenderingFreeType RenderingOpenGL2 RenderingUI glew
  OPTIONAL_COMPONENTS ParallelCore ParallelMPI mpi)
option(MEDIAL_USE_MPI "Let medial-axis run as several processes by MPI" ${VTK_ParallelMPI_FOUND})
if(MEDIAL_USE_MPI AND NOT VTK_ParallelMPI_FOUND)
  message(FATAL_ERROR "MEDIAL_USE_MPI: this VTK has no MPI")
endif()

# medial_autoinit(TARGET MODULE...): vtk_module_autoinit(), but with definitions that name no folder, so that
# ccache shares what one build folder has compiled with the others.
function(medial_autoinit target)
  vtk_module_autoinit(TARGETS ${target} MODULES ${ARGN})
  get_target_property(definitions ${target} COMPILE_DEFINITIONS)
  if(definitions)
    string(REPLACE "${CMAKE_BINARY_DIR}/CMakeFiles/" "" definitions "${definitions}")
    set_target_properties(${target} PROPERTIES COMPILE_DEFINITIONS "${definitions}")
    target_include_directories(${target} PRIVATE "${CMAKE_BINARY_DIR}/CMakeFiles")
  endif()
endfunction()
