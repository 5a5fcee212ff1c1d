# SPDX-License-Identifier: GPL-3.0-or-later

# Builds `wrong_parameters`, which has to fail with the sentences that tell what is wrong, and the tags of the parameters.

cmake_minimum_required(VERSION 3.25)

execute_process(COMMAND ${CMAKE_COMMAND} --build ${PROJECT_BINARY_DIR} --target wrong_parameters --config ${CONFIG}
  RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(status EQUAL 0)
  message(FATAL_ERROR "wrong parameters compile")
endif()
set(texts_of_distributed_meshes)
if(DISTRIBUTED)
  set(texts_of_distributed_meshes "a placement of all vertices together, other than Fitted_placement, is not available"
    feature_angle_t "fits_map[^\n]*Key = [a-z ]*long[^\n]*Property_map")
endif()
foreach(text IN LISTS texts_of_distributed_meshes ITEMS "this named parameter cannot be used in this pack of this function"
    "how many vertices\\? Give a number"
    "the number of vertices precedes the output: coarsen_mesh\\(input, number_of_vertices, output\\)"
    "the property map of this named parameter has keys of another type"
    "the property map of this named parameter has values of another type"
    "cluster_energy and cluster_weight cannot both be given"
    "the class has an energy where a cluster_weight is given, or a weight where a cluster_energy is given"
    "the parameters vertex_ratio, number_of_faces and neighborhood_level exclude each other"
    "no member named [^\n]*neighborhood_level"
    vertex_source_t vertex_ratio_t repair_output_t number_of_iterations_t neighborhood_level_t error_feedback_t vertex_placement_t
    face_density_t)
  if(text MATCHES "_t$")
    set(text "check_parameter[^\n]*Tag = [A-Za-z_:]*${text}")
  endif()
  if(NOT output MATCHES "${text}")
    message(FATAL_ERROR "no error says '${text}':\n${output}")
  endif()
endforeach()
