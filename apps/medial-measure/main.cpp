#include "measure_options.h"
#include "measure_run.h"
#include "program_main.h"

int main(int argc, char** argv)
{
  return medial::app::runProgram("medial-measure",
    [&]
    {
      if (const auto options = medial::app::parseMeasureOptions(argc, argv))
      {
        medial::app::runMeasure(*options);
      }
    });
}
