/**
 * Time in filters of several inputs. Private to the module.
 */

#ifndef vtkMedialTimes_h
#define vtkMedialTimes_h

class vtkAlgorithm;
class vtkInformation;
class vtkInformationVector;

/**
 * Announces the times of all inputs, their steps and their range, where VTK by itself passes on
 * those of the first input alone: a filter that announces no times is not executed for a new one.
 */
void vtkAnnounceTimes(vtkInformationVector** inputVector, int ports,
  vtkInformationVector* outputVector);

/**
 * Marks outputs as those of the time that was requested of one of them, if any. They may have
 * copied the time of an input, whose steps may be others.
 */
void vtkMarkTime(vtkInformation* requested, vtkInformationVector* outputVector);

/**
 * Keeps what both do at the end of an execution that goes through the blocks of composite input:
 * there the pipeline takes the times of the first input alone again.
 */
void vtkKeepTimes(vtkAlgorithm* algorithm);

#endif
