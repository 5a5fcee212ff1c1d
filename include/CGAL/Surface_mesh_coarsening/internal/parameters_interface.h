// SPDX-License-Identifier: GPL-3.0-or-later

// The named parameters of the package, in the form of CGAL's own parameters_interface.h. It is included several
// times, each time with another meaning of CGAL_add_named_parameter: there is no include guard.

CGAL_add_named_parameter(face_density_t, face_density, face_density_map)
CGAL_add_named_parameter(face_cluster_t, face_cluster, face_cluster_map)
CGAL_add_named_parameter(vertex_boundary_count_t, vertex_boundary_count, vertex_boundary_count_map)
CGAL_add_named_parameter(vertex_to_cluster_t, vertex_to_cluster, vertex_to_cluster_map)
CGAL_add_named_parameter(vertex_source_t, vertex_source, vertex_source_map)
CGAL_add_named_parameter(cluster_weight_t, cluster_weight_p, cluster_weight)
CGAL_add_named_parameter(cluster_energy_t, cluster_energy_p, cluster_energy)
CGAL_add_named_parameter(maximum_density_t, maximum_density_p, maximum_density)
CGAL_add_named_parameter(vertex_ratio_t, vertex_ratio_p, vertex_ratio)
CGAL_add_named_parameter(keep_small_components_t, keep_small_components_p, keep_small_components)
CGAL_add_named_parameter(number_of_faces_t, number_of_faces_p, number_of_faces)
CGAL_add_named_parameter(paper_rules_t, paper_rules_p, paper_rules)
CGAL_add_named_parameter(neighborhood_level_t, neighborhood_level_p, neighborhood_level)
CGAL_add_named_parameter(convergence_tolerance_t, convergence_tolerance_p, convergence_tolerance)
CGAL_add_named_parameter(vertex_placement_t, vertex_placement_p, vertex_placement)
CGAL_add_named_parameter(subdivide_input_t, subdivide_input_p, subdivide_input)
CGAL_add_named_parameter(repair_output_t, repair_output_p, repair_output)
CGAL_add_named_parameter(feature_angle_t, feature_angle_p, feature_angle)
CGAL_add_named_parameter(error_feedback_t, error_feedback_p, error_feedback)
CGAL_add_named_parameter(faces_per_block_t, faces_per_block_p, faces_per_block)
CGAL_add_named_parameter(face_name_t, face_name, face_name_map)
CGAL_add_named_parameter(scratch_directory_t, scratch_directory_p, scratch_directory)
CGAL_add_named_parameter(scratch_memory_t, scratch_memory_p, scratch_memory)
CGAL_add_named_parameter(output_on_all_ranks_t, output_on_all_ranks_p, output_on_all_ranks)
