# SPDX-License-Identifier: GPL-3.0-or-later
#
# Plots peers.csv, the output of compare_peers, to peers.png: median, minimum and maximum of the processor seconds.

set terminal pngcairo size 900,600 font ",11"
set output "peers.png"
set datafile separator comma
set logscale xy
set xlabel "faces of the input"
set ylabel "processor seconds"
set key outside right
set offsets graph 0.1, graph 0.1, 0, 0
set grid
methods = "\"ours uniform\" \"ours area\" \"ours maximum quadric\" \"CGAL edge collapse\" \"CGAL ACVD\" meshoptimizer \"OpenMesh decimation\""
method(i) = word(methods, i)
plot for [i = 1:words(methods)] "peers.csv" skip 1 \
  using 2:(strcol(4) eq method(i) && $7 > 0 ? $9 : NaN):11:14 with yerrorbars pointtype i linewidth 1.5 title method(i)
