# expect_box_axis(PROGRAM): runs the example of the library alone. Its figures must be those of its box,
# whose half sides are 1, 0.75 and 0.5.
function(expect_box_axis program)
  run(output "${program}")

  if(NOT output MATCHES "distances from (-[0-9.]+) to ([0-9.]+) at ([0-9]+) points")
    message(FATAL_ERROR "no distances were printed")
  endif()
  set(deepest "${CMAKE_MATCH_1}")
  set(farthest "${CMAKE_MATCH_2}")
  set(samples "${CMAKE_MATCH_3}")
  # 64 points over 2 + 2 * 0.05 * diagonal of 2.6926 give voxels of 0.03602.
  expect_near("the deepest distance" "${deepest}" -0.5 0.02)
  # The margin of at least 0.1346 on every side ends at a corner of the grid.
  expect_near("the farthest distance" "${farthest}" 0.24 0.03)
  expect_near("the number of samples" "${samples}" 122000 20000)

  if(NOT output MATCHES "medial axis of ([0-9]+) points and ([0-9]+) cells, radius up to ([0-9.]+)")
    message(FATAL_ERROR "no medial axis was printed")
  endif()
  set(points "${CMAKE_MATCH_1}")
  set(cells "${CMAKE_MATCH_2}")
  expect_near("the largest radius" "${CMAKE_MATCH_3}" 0.5 0.01)
  if(points LESS 1000 OR cells LESS 1000)
    message(FATAL_ERROR "the axis has only ${points} points and ${cells} cells")
  endif()
  if(NOT output MATCHES "computed in [^\n]+")
    message(FATAL_ERROR "no time was printed")
  endif()
endfunction()
