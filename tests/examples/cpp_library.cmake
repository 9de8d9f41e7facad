# The example of the library alone must not need VTK.
include("${CMAKE_CURRENT_LIST_DIR}/consumer.cmake")
include("${CMAKE_CURRENT_LIST_DIR}/box_axis.cmake")
build_example("${SOURCE}" -DCMAKE_DISABLE_FIND_PACKAGE_VTK=ON)
expect_box_axis("${WORK}/box_axis")
