#include "program_main.h"
#include "viewer.h"
#include "viewer_options.h"

int main(int argc, char** argv)
{
  return medial::app::runProgram("medial-viewer",
    [&]
    {
      if (const auto options = medial::app::parseViewerOptions(argc, argv))
      {
        medial::app::runViewer(*options);
      }
    });
}
