# VTK, for the programs: the modules that their folders name.
find_package(VTK 9.1 REQUIRED COMPONENTS
  CommonCore CommonDataModel CommonExecutionModel CommonMath CommonMisc
  FiltersCore FiltersGeometry FiltersModeling FiltersSources ImagingCore InteractionStyle InteractionWidgets
  IOCore IOGeometry IOImage IOXML RenderingAnnotation RenderingCore RenderingFreeType RenderingOpenGL2
  RenderingUI glew
  OPTIONAL_COMPONENTS ParallelCore ParallelMPI mpi)
option(MEDIAL_USE_MPI "Let medial-axis run as several processes by MPI" ${VTK_ParallelMPI_FOUND})
if(MEDIAL_USE_MPI AND NOT VTK_ParallelMPI_FOUND)
  message(FATAL_ERROR "MEDIAL_USE_MPI: this VTK has no MPI")
endif()
