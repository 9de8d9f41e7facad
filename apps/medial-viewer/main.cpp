#include "program_main.h"
#include "viewer.h"
#include "viewer_options.h"

#include <csignal>

int main(int argc, char** argv)
{
  // Writing to a display that was lost must not end the program before it can say so.
  std::signal(SIGPIPE, SIG_IGN);
  return medial::app::runProgram("medial-viewer",
    [&]
    {
      if (const auto options = medial::app::parseViewerOptions(argc, argv))
      {
        medial::app::runViewer(*options);
      }
    });
}
