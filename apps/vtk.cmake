# VTK, for the programs: the modules that their folders name.
find_package(VTK 9.1 REQUIRED COMPONENTS
  CommonCore CommonDataModel CommonExecutionModel CommonMath CommonMisc
  FiltersCore FiltersGeometry FiltersModeling FiltersSources ImagingCore InteractionStyle InteractionWidgets
  IOCore IOGeometry IOImage IOXML RenderingAnnotation RenderingCore RenderingFreeType RenderingOpenGL2
  RenderingUI glew)
